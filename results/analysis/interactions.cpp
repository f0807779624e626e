// Interactions: whether a difference is another one under another level. Each test is of a difference of
// differences, in which what a participant, a level and another level add by themselves cancels.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "results/analysis/analysis_steps.hpp"
#include "results/analysis/tests.hpp"
#include "results/statistics/descriptive.hpp"

namespace deixis::results {

namespace {

/// Participants' scores in one cell, by system: a mean of these means does not depend on how many answers
/// each system got.
using CellScores = std::map<std::string, std::map<std::string, Scores>>;
using CellMeans = std::map<std::string, Rational>;  // by participant

CellMeans meansOf(const CellScores& cell) {
    CellMeans out;
    for (const auto& [participant, systems] : cell) {
        std::vector<Rational> means;
        for (const auto& [system, scores] : systems) means.push_back(exactMeanOf(scores));
        out.emplace(participant, exactMean(means));
    }
    return out;
}

std::string levelOn(const ResponseTable& table, const ResponseRow& row, const Factor& factor) {
    return factor.name == systems_between ? row.system : levelOf(table, row, factor.name);
}

/// Systems first, then the within-participants factors.
std::vector<Factor> crossedFactors(const ResponseTable& table) {
    std::vector<Factor> out{{systems_between, table.systems}};
    for (Factor& factor : withinFactors(table)) out.push_back(std::move(factor));
    return out;
}

using LevelMeans = std::map<std::string, CellMeans>;
using CrossedMeans = std::map<std::pair<std::string, std::string>, CellMeans>;

LevelMeans levelMeans(const ResponseTable& table, const Measure& measure, const Factor& factor) {
    std::map<std::string, CellScores> cells;
    for (const ResponseRow& row : table.rows)
        if (const std::string level = levelOn(table, row, factor);
            row.measure == measure.name && !level.empty())
            cells[level][row.participant][row.system].push_back(row.value);
    LevelMeans out;
    for (const auto& [level, cell] : cells) out[level] = meansOf(cell);
    return out;
}

CrossedMeans crossedMeans(const ResponseTable& table, const Measure& measure, const Factor& first,
                          const Factor& second) {
    std::map<std::pair<std::string, std::string>, CellScores> cells;
    for (const ResponseRow& row : table.rows) {
        if (row.measure != measure.name) continue;
        const std::string a = levelOn(table, row, first);
        const std::string b = levelOn(table, row, second);
        if (!a.empty() && !b.empty()) cells[{a, b}][row.participant][row.system].push_back(row.value);
    }
    CrossedMeans out;
    for (const auto& [levels, cell] : cells) out[levels] = meansOf(cell);
    return out;
}

const Rational* meanIn(const CellMeans& means, const std::string& participant) {
    const auto found = means.find(participant);
    return found == means.end() ? nullptr : &found->second;
}

/// (a - b under c) - (a - b under d), of the participants who have all four.
std::vector<Rational> differencesOfDifferences(CrossedMeans& means, const InteractionResult& of) {
    std::vector<Rational> out;
    for (const auto& [participant, a_c] : means[{of.a, of.c}]) {
        const Rational* b_c = meanIn(means[{of.b, of.c}], participant);
        const Rational* a_d = meanIn(means[{of.a, of.d}], participant);
        const Rational* b_d = meanIn(means[{of.b, of.d}], participant);
        if (b_c != nullptr && a_d != nullptr && b_d != nullptr) out.push_back((a_c - *b_c) - (*a_d - *b_d));
    }
    return out;
}

/// Calls visit(i, j) for each pair of `n` levels.
template <typename Visit>
void forPairs(std::size_t n, const Visit& visit) {
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) visit(i, j);
}

struct Contrast {
    InteractionResult result;
    std::vector<Rational> differences;
};

void testContrasts(std::vector<Contrast>& contrasts, double level) {
    constexpr std::size_t many_participants = 200;  // whose exact tests take milliseconds
    const bool large = std::any_of(contrasts.begin(), contrasts.end(), [](const Contrast& one) {
        return one.differences.size() >= many_participants;
    });
    forRanges(contrasts.size(), large ? 1 : contrasts.size() + 1, [&](std::size_t i, std::size_t end) {
        for (; i < end; ++i) {
            Contrast& one = contrasts[i];
            one.result.mean_difference = meanOf(one.differences);
            one.result.test = signedRankTest(one.differences, level);
            one.result.normality = shapiroWilk(one.differences);
        }
    });
}

void testWithin(const Measure& measure, const Factor& first, const Factor& second, AnalysisResult& result) {
    CrossedMeans means = crossedMeans(result.table, measure, first, second);
    const std::size_t family = result.interactions.size();
    std::vector<Contrast> contrasts;
    forPairs(first.levels.size(), [&](std::size_t a, std::size_t b) {
        forPairs(second.levels.size(), [&](std::size_t c, std::size_t d) {
            Contrast one;
            one.result.measure = measure.name;
            one.result.factor = first.name;
            one.result.a = first.levels[a];
            one.result.b = first.levels[b];
            one.result.other_factor = second.name;
            one.result.c = second.levels[c];
            one.result.d = second.levels[d];
            one.differences = differencesOfDifferences(means, one.result);
            // Else it is of a factor that is nested in the other one.
            if (!one.differences.empty()) contrasts.push_back(std::move(one));
        });
    });
    testContrasts(contrasts, result.level);
    for (Contrast& one : contrasts) result.interactions.push_back(std::move(one.result));
    adjustFrom(result.interactions, family, fmt::format("{}: {} x {}", measure.name, first.name, second.name),
               result.alpha);
}

void testWithGroups(const Measure& measure, const Factor& within, const Factor& groups,
                    AnalysisResult& result) {
    LevelMeans means = levelMeans(result.table, measure, within);
    const std::size_t family = result.group_interactions.size();
    forPairs(within.levels.size(), [&](std::size_t c, std::size_t d) {
        std::map<std::string, std::vector<Rational>> by_group;
        for (const auto& [participant, mean] : means[within.levels[c]])
            if (const Rational* other = meanIn(means[within.levels[d]], participant); other != nullptr)
                if (const std::string level = levelOfParticipant(result.table, participant, groups.name);
                    !level.empty())
                    by_group[level].push_back(mean - *other);
        forPairs(groups.levels.size(), [&](std::size_t a, std::size_t b) {
            GroupInteractionResult one;
            one.measure = measure.name;
            one.other_factor = within.name;
            one.c = within.levels[c];
            one.d = within.levels[d];
            compareLevelsOf(one, groups, a, b, by_group, result.level);
            if (one.test.p_two_sided) result.group_interactions.push_back(std::move(one));
        });
    });
    adjustGroups(result.group_interactions, family,
                 fmt::format("{}: {} x {}", measure.name, within.name, groups.name), result.alpha);
}

}  // namespace

void testInteractions(AnalysisResult& result) {
    const std::vector<Factor> within = crossedFactors(result.table);
    for (const Measure& measure : result.measures) {
        forPairs(within.size(),
                 [&](std::size_t i, std::size_t j) { testWithin(measure, within[i], within[j], result); });
        for (const Factor& groups : result.table.between)
            for (const Factor& factor : within) testWithGroups(measure, factor, groups, result);
    }
}

}  // namespace deixis::results
