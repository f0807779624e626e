// How it was done, in full: report_methods.mustache has the text, with a paragraph for each thing that was
// computed.
#include <fmt/format.h>

#include <algorithm>

#include "computed.hpp"
#include "findings.hpp"
#include "results/page/number_text.hpp"

namespace deixis::results {

namespace {

/// A study tells the scale; of other data only the answers are known.
std::string ratingSentence(const ResponseTable& table, const Measure& measure, const std::string& name) {
    if (!measure.unit.empty()) return fmt::format("{} is measured in {}; 0 is exact.", name, measure.unit);
    if (!table.study_hash.empty())
        return fmt::format("{} is the rating on the scale from {} to {}.", name, measure.low, measure.high);
    if (measure.low == measure.high)
        return fmt::format("{} is a rating; all answers are {}.", name, measure.low);
    return fmt::format("{} is a rating; the answers range from {} to {}, and the data do not give the scale.",
                       name, measure.low, measure.high);
}

std::vector<std::string> measureSentences(const AnalysisResult& result) {
    std::vector<std::string> out;
    for (const Measure& measure : result.table.measures) {
        const std::string name = capitalised(measure.name);
        if (measure.kind == MeasureKind::accuracy)
            out.push_back(fmt::format(
                "{} is the share of trials of the referential game in which the target was chosen{}.", name,
                measure.balls > 1 ? fmt::format(" (chance: {})", ballsText(measure)) : std::string()));
        else if (measure.kind == MeasureKind::rating)
            out.push_back(ratingSentence(result.table, measure, name));
        else
            out.push_back(fmt::format(
                "{} runs from 2 (clearly the first) over 0 (equal) to \u22122 (clearly the second), "
                "whichever was on the left.",
                name));
    }
    return out;
}

/// "A, b, and c" of what there is.
std::string joinedWith(const std::vector<std::string>& items) {
    std::string out;
    for (std::size_t i = 0; i < items.size(); ++i)
        out += (i == 0 ? "" : i + 1 == items.size() ? "; and " : "; ") + items[i];
    return out;
}

/// What the signed-rank tests were of.
std::string comparedText(const Computed& computed) {
    std::vector<std::string> what;
    if (computed.pairs) what.emplace_back("participants' means under two systems");
    if (computed.levels) what.emplace_back("under two levels of a factor");
    if (computed.preferences) what.emplace_back("participants' mean preferences against none");
    if (computed.chance) what.emplace_back("correct choices minus chance against none");
    if (computed.halves) what.emplace_back("the second half of a participant's answers against the first");
    if (computed.scores) what.emplace_back("a questionnaire's scores when it is asked again against before");
    if (computed.times) what.emplace_back("participants' median response times under two systems");
    return joinedWith(what);
}

std::string familiesText(const AnalysisResult& result, const Computed& computed) {
    const std::size_t systems = result.table.systems.size();
    const std::size_t pairs = systems * (systems - 1) / 2;
    std::vector<std::string> out;
    if (computed.pairs)
        out.push_back(
            (pairs == 1 ? "the one pair of systems" : fmt::format("the {} pairs of systems", pairs)) +
            " within one measure");
    if (computed.levels) out.emplace_back("for each within-participants factor the tests of all systems");
    if (computed.preferences) out.emplace_back("all pairs in preference");
    if (computed.chance) out.emplace_back("all systems against chance");
    if (computed.halves) out.emplace_back("the halves of all measures");
    if (computed.scores) out.emplace_back("the scores of two stages");
    if (computed.times) out.emplace_back("the pairs of systems in the response times of one measure");
    return joinedWith(out);
}

}  // namespace

std::string methodsHtml(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    const Computed computed(result);
    const bool accuracy = std::any_of(result.measures.begin(), result.measures.end(),
                                      [](const Measure& one) { return one.kind == MeasureKind::accuracy; });
    const bool repeats = std::any_of(table.checks.begin(), table.checks.end(),
                                     [](const CheckCount& one) { return one.kind == "repeat"; });
    std::vector<std::string> also_of_groups;
    if (computed.scores_of_groups) also_of_groups.emplace_back("the scores of questionnaires");
    if (computed.times_of_groups) also_of_groups.emplace_back("participants' median response times");
    return filled(
        "report_methods.mustache",
        {{"pointing2023", isPointing2023(table)},
         {"measures", measureSentences(result)},
         {"without_practice", !table.study_hash.empty() || !table.checks.empty()},
         {"checks", !table.checks.empty()},
         {"repeats", repeats},
         {"studies", !result.by_study.empty()},
         {"means", !result.measures.empty()},
         {"accuracy", accuracy},
         {"levels", !result.levels.empty()},
         {"intervals", computed.intervals && !result.measures.empty()},
         {"level", fmt::format("{:g}", 100.0 * result.level)},
         {"resamples", result.options.resamples},
         {"seed", result.options.seed},
         {"alpha", fmt::format("{}", result.alpha)},
         {"tests", computed.signedRank()},
         {"compared", comparedText(computed)},
         {"families", familiesText(result, computed)},
         {"zeros", computed.zeros},
         {"approximate", computed.approximate},
         {"friedman", computed.friedman},
         {"systems_apart", computed.systems_apart},
         {"any_groups", computed.groups || computed.preferences_of_groups || !also_of_groups.empty()},
         {"groups", computed.groups},
         {"preferences_of_groups", computed.preferences_of_groups},
         {"also_of_groups", fmt::format("{}", fmt::join(also_of_groups, ", and "))},
         {"interactions", computed.interactions},
         {"interactions_within", !result.interactions.empty()},
         {"interactions_between", !result.group_interactions.empty()},
         {"equivalence", computed.equivalence},
         {"ratings", computed.ratings},
         {"author_trials", computed.author_trials},
         {"other_choices", computed.pairs || computed.preferences},
         {"boxes", computed.boxes}});
}

}  // namespace deixis::results
