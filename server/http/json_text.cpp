#include "server/http/json_text.hpp"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/json_size.hpp"

namespace deixis::server {

namespace {

/// The names of the objects that are open; which of them stands twice.
struct SeenNames {
    std::vector<std::set<std::string>> open{};
    std::optional<std::string> twice{};
};

}  // namespace

Result<nlohmann::json> parseJsonText(std::string_view text) {
    using nlohmann::json;
    if (text.empty()) return fail("", "the request has no body, expected JSON");
    if (jsonSize(text).depth > max_json_depth)
        return fail(
            "", fmt::format("lists and objects lie more than {} deep within one another", max_json_depth));
    SeenNames names;
    const auto look = [&names](int, json::parse_event_t event, json& value) {
        if (event == json::parse_event_t::object_start) names.open.emplace_back();
        if (event == json::parse_event_t::object_end) names.open.pop_back();
        if (event == json::parse_event_t::key && !names.open.back().insert(value.get<std::string>()).second)
            names.twice = value.get<std::string>();
        return true;
    };
    try {
        json value = json::parse(text.begin(), text.end(), look);
        if (names.twice) return fail(*names.twice, "stands twice in an object");
        return value;
    } catch (const json::exception& error) {
        // "[json.exception.parse_error.101] parse error at line 1, column 2: ..." without the part in
        // brackets
        const std::string what = error.what();
        const std::size_t behind = what.find("] ");
        return fail("", "is no JSON: " + (behind == std::string::npos ? what : what.substr(behind + 2)));
    }
}

}  // namespace deixis::server
