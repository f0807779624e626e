// Any bytes as the JSON of a request: a value of its shape, or an error that says what is wrong.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "server/http/json_shape.hpp"
#include "server/http/json_text.hpp"

using namespace deixis;

namespace {

const server::Shape& requestShape() {
    static const server::Shape shape = [] {
        server::Shape out = server::objectShape(
            "", {server::mayField("text", server::textShape("", 1, 50)),
                 server::mayField("id", server::textShape("", 1, 64)),
                 server::mayField("seed", server::integerShape("", 0, 1e300), 1),
                 server::mayField("format", server::choiceShape("", {"bvh", "csv"}), "bvh"),
                 server::mayField("exact", server::booleanShape(""), false),
                 server::mayField(
                     "frames", server::listShape(
                                   "", server::listShape("", server::numberShape("", -1, 1), 3, 3), 0, 4))});
        out.exactly_one = {"text", "id"};
        return out;
    }();
    return shape;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    auto value = server::parseJsonText(std::string_view(reinterpret_cast<const char*>(data), size));
    if (!value) {
        if (value.error().message.empty()) std::abort();
        return 0;
    }
    if (server::parseJsonText(value->dump()) != *value) std::abort();
    if (const auto checked = server::checkShape(requestShape(), *value); !checked) {
        if (checked.error().message.empty()) std::abort();
        return 0;
    }
    server::fillIn(requestShape(), *value);
    if (!server::checkShape(requestShape(), *value) || !value->contains("seed")) std::abort();
    return 0;
}
