// The comparisons of systems with answers that the headline leaves out, and without some that it takes.
#include <algorithm>
#include <unordered_set>
#include <utility>

#include "results/analysis/analysis_steps.hpp"
#include "results/analysis/tests.hpp"

namespace deixis::results {

namespace {

/// The pairs of systems of one choice of answers.
struct PairsOfChoice {
    std::vector<Comparison> pairwise;
    std::vector<PreferenceResult> preferences;
    AnswerCounts counts;
};

AnswerCounts countsOf(const RowPointers& rows) {
    std::set<std::string> participants;
    for (const ResponseRow* row : rows) participants.insert(row->participant);
    return {static_cast<int>(participants.size()), static_cast<int>(rows.size())};
}

PairsOfChoice testChoice(const RowPointers& rows, const AnalysisResult& result) {
    // Mostly nobody is left out and nothing is in doubt: the answers are those of the headline.
    if (std::equal(
            rows.begin(), rows.end(), result.table.rows.begin(), result.table.rows.end(),
            [](const ResponseRow* row, const ResponseRow& of_headline) { return row == &of_headline; }))
        return {result.pairwise, result.preferences, result.headline_answers};
    const auto& systems = result.table.systems;
    const double level = result.level;
    return {pairTests(exactMeans(cellsOf(rows)), result.measures, systems, level, result.alpha),
            preferenceTests(rows, systems, level, result.alpha), countsOf(rows)};
}

/// Without answers it is a test without pairs.
AdjustedTest preferenceIn(const PairsOfChoice& choice, const PreferenceResult& pair) {
    for (const PreferenceResult& one : choice.preferences)
        if (one.a == pair.a && one.b == pair.b) return one;
    return {};
}

/// The answers of one choice.
RowPointers rowsOf(AnswerChoice choice, const ResponseTable& table) {
    const bool answered_only = choice == AnswerChoice::answered_only;
    const bool without_doubtful = choice == AnswerChoice::without_doubtful;
    RowPointers out;
    for (const ResponseRow& row : table.rows) {
        if (answered_only && !row.unanswered.empty()) continue;
        if (without_doubtful && (!row.marked.empty() || table.failed_checks.contains(row.participant)))
            continue;
        out.push_back(&row);
    }
    if (choice == AnswerChoice::with_left_out)
        for (const ResponseRow& row : table.left_out_rows) out.push_back(&row);
    if (choice == AnswerChoice::unanswered_wrong)
        for (const ResponseRow& row : table.skipped_rows) out.push_back(&row);
    return out;
}

}  // namespace

const char* nameOf(AnswerChoice choice) {
    switch (choice) {
        case AnswerChoice::with_left_out:
            return "with_left_out";
        case AnswerChoice::without_doubtful:
            return "without_doubtful";
        case AnswerChoice::answered_only:
            return "answered_only";
        case AnswerChoice::unanswered_wrong:
            return "unanswered_wrong";
    }
    return "";
}

void compareOtherAnswers(AnalysisResult& result) {
    result.headline_answers = countsOf(pointersTo(result.table.rows));
    std::vector<PairsOfChoice> choices;
    for (const AnswerChoice choice : all_choices) {
        choices.push_back(testChoice(rowsOf(choice, result.table), result));
        result.other_answers.at(static_cast<std::size_t>(choice)) = choices.back().counts;
    }
    const auto add = [&](const std::string& measure, const std::string& a, const std::string& b,
                         const AdjustedTest& headline, const auto& testIn) {
        SensitivityResult& out = result.sensitivity.emplace_back(SensitivityResult{measure, a, b, headline});
        for (const AnswerChoice choice : all_choices) {
            AdjustedTest test = testIn(choices[static_cast<std::size_t>(choice)]);
            const bool changes = test.significant != headline.significant;
            out.others.push_back({choice, std::move(test), changes});
        }
    };
    for (std::size_t i = 0; i < result.pairwise.size(); ++i) {
        const Comparison& pair = result.pairwise[i];
        add(pair.measure, pair.a, pair.b, pair,
            [&](const PairsOfChoice& of) -> AdjustedTest { return of.pairwise[i]; });
    }
    for (const PreferenceResult& pair : result.preferences)
        add("preference", pair.a, pair.b, pair,
            [&](const PairsOfChoice& of) { return preferenceIn(of, pair); });
}

}  // namespace deixis::results
