#include "studies/study_file/study.hpp"

#include <algorithm>

namespace deixis::studies {

namespace {

template <typename Entry>
const Entry* findNamed(const std::vector<Entry>& entries, std::string_view wanted) {
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [&](const Entry& entry) { return entry.name == wanted; });
    return found == entries.end() ? nullptr : &*found;
}

}  // namespace

std::string Study::place(const std::string& key) const {
    const auto found = places.find(key);
    return found == places.end() ? file.string() : found->second;
}
const Layout* Study::findLayout(std::string_view wanted) const {
    return findNamed(layouts, wanted);
}
const DistanceBand* Study::findDistance(std::string_view wanted) const {
    return findNamed(distances, wanted);
}
const SystemSource* Study::findSystem(std::string_view wanted) const {
    return findNamed(systems, wanted);
}
const Stage* Study::findStage(std::string_view wanted) const {
    return findNamed(stages, wanted);
}

std::string_view checkKindName(CheckKind kind) {
    constexpr std::string_view names[] = {"number", "catch", "repeat"};
    return names[static_cast<std::size_t>(kind)];
}

std::string_view checkRuleName(CheckRule rule) {
    constexpr std::string_view names[] = {"note", "warn", "exclude", "end"};
    return names[static_cast<std::size_t>(rule)];
}

}  // namespace deixis::studies
