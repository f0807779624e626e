#include "core/name.hpp"

#include <mutex>
#include <unordered_set>

namespace deixis {

namespace {

struct TextHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
};

/// Never destroyed: names may outlive everything else.
struct Texts {
    std::mutex mutex;
    std::unordered_set<std::string, TextHash, std::equal_to<>> known;

    const std::string* keep(std::string_view text) {
        const std::lock_guard lock(mutex);
        const auto found = known.find(text);
        return found != known.end() ? &*found : &*known.emplace(text).first;
    }
};

const std::string* keep(std::string_view text) {
    if (text.empty()) return nullptr;
    static auto* const texts = new Texts;
    return texts->keep(text);
}

}  // namespace

Name::Name(std::string_view text) : text_(keep(text)) {}

const std::string& Name::emptyText() {
    static const std::string empty;
    return empty;
}

}  // namespace deixis
