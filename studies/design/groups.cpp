// Who a participant is within the study: id, number, groups.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "core/random.hpp"
#include "core/text.hpp"
#include "studies/design/plan.hpp"

namespace deixis::studies {

namespace {

/// Every combination of one level of each factor, the last factor's levels changing fastest.
std::vector<Groups> allCells(const std::vector<BetweenFactor>& factors) {
    std::vector<Groups> cells{{}};
    for (const BetweenFactor& factor : factors) {
        std::vector<Groups> next;
        for (const Groups& cell : cells)
            for (const std::string& level : factor.levels) {
                next.push_back(cell);
                next.back()[factor.name] = level;
            }
        cells = std::move(next);
    }
    return cells;
}

}  // namespace

bool validParticipant(std::string_view participant) {
    constexpr std::size_t longest = 32;
    return !participant.empty() && participant.size() <= longest &&
           std::all_of(participant.begin(), participant.end(), [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || isDigit(c) || c == '_' || c == '-';
           });
}

Result<void> checkParticipantId(std::string_view participant) {
    if (validParticipant(participant)) return {};
    return fail(
        "participant",
        fmt::format("found \"{}\", expected 1 to 32 letters A-Z a-z, digits, '_' and '-'", participant),
        "Use an id such as P01");
}

std::optional<int> numberOfParticipant(std::string_view participant) {
    constexpr std::size_t max_digits = 6;
    const auto digits = static_cast<std::size_t>(
        std::find_if_not(participant.rbegin(), participant.rend(), isDigit) - participant.rbegin());
    if (digits == 0 || digits > max_digits) return std::nullopt;
    int number = 0;
    for (const char c : participant.substr(participant.size() - digits)) number = 10 * number + (c - '0');
    if (number == 0) return std::nullopt;
    return number;
}

Groups assignGroups(const Study& study, const GroupSizes& taken, int number) {
    const std::vector<Groups> cells = allCells(study.between);
    std::vector<int> filled;
    for (const Groups& cell : cells) {
        const auto counted = taken.find(cell);
        filled.push_back(counted == taken.end() ? 0 : counted->second);
    }
    const int min = *std::min_element(filled.begin(), filled.end());
    std::vector<const Groups*> open;
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (filled[i] == min) open.push_back(&cells[i]);
    Random random(deriveSeed(study.seed, "groups"), fmt::format("{}", number));
    return *open[random.below(open.size())];
}

Assignment assignmentOf(const Study& study, int number, const Groups& groups) {
    if (study.between.empty()) return {groups, std::nullopt};
    GroupSizes taken;
    for (int before = 1; before < number; ++before) ++taken[assignGroups(study, taken, before)];
    const Groups own = groups.empty() ? assignGroups(study, taken, number) : groups;
    return {own, taken[own] + 1};
}

}  // namespace deixis::studies
