#include "report_paper.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "analysis_details.hpp"
#include "report_text.hpp"

namespace deixis::results {

namespace {

/// "a, b and c"; items are HTML.
std::string listed(const std::vector<std::string>& items) {
    std::string out;
    for (std::size_t i = 0; i < items.size(); ++i)
        out += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
    return out;
}

std::vector<std::string> escaped(const std::vector<std::string>& texts) {
    std::vector<std::string> out;
    for (const std::string& text : texts) out.push_back(escapeHtml(text));
    return out;
}

std::string counted(int n, const char* one, const char* many) {
    return fmt::format("{} {}", n, n == 1 ? one : many);
}

/// "naturalness, rated from 1 to 5".
std::string measureText(const ResponseTable& table, const Measure& measure) {
    const std::string name = escapeHtml(measure.name);
    if (measure.kind == MeasureKind::accuracy)
        return name + " (the target chosen, or not" +
               (measure.balls > 1 ? fmt::format("; chance: {})", ballsText(measure)) : ")");
    if (measure.kind == MeasureKind::preference) return name + " (between two systems, side by side)";
    if (table.study_hash.empty())
        return fmt::format("{} (rated; answers from {} to {})", name, measure.low, measure.high);
    return fmt::format("{} (rated from {} to {})", name, measure.low, measure.high);
}

std::vector<std::string> measureTexts(const ResponseTable& table) {
    std::vector<std::string> out;
    for (const Measure& measure : table.measures) out.push_back(measureText(table, measure));
    return out;
}

/// The fewest and the most answers that a participant gave.
std::pair<int, int> answersPerParticipant(const ResponseTable& table) {
    std::map<Name, int> answers;
    for (const ResponseRow& row : table.rows) ++answers[row.participant];
    std::pair<int, int> range{std::numeric_limits<int>::max(), 0};
    for (const auto& [participant, n] : answers)
        range = {std::min(range.first, n), std::max(range.second, n)};
    return range;
}

/// Whether anybody has answered under two systems.
bool systemsMeetInParticipants(const ResponseTable& table) {
    std::map<Name, Name> first;
    return std::any_of(table.rows.begin(), table.rows.end(), [&](const ResponseRow& row) {
        return first.try_emplace(row.participant, row.system).first->second != row.system ||
               !row.other_system.empty();
    });
}

std::string groupsText(const ResponseTable& table, const Factor& factor) {
    std::map<std::string, int> sizes;
    for (const auto& [participant, levels] : table.groups)
        if (const auto level = levels.find(factor.name); level != levels.end()) ++sizes[level->second];
    std::vector<std::string> out;
    for (const std::string& level : factor.levels)
        out.push_back(fmt::format("{}: {}", escapeHtml(level), sizes[level]));
    return fmt::format("{} ({})", escapeHtml(factor.name), listed(out));
}

std::string leftOutText(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    const auto dropped = std::count_if(table.left_out.begin(), table.left_out.end(),
                                       [](const LeftOut& one) { return one.dropped; });
    const auto excluded = static_cast<std::ptrdiff_t>(table.left_out.size()) - dropped;
    std::vector<std::string> out;
    if (excluded > 0) out.push_back(fmt::format("{} excluded", excluded));
    if (dropped > 0) out.push_back(fmt::format("{} dropped out", dropped));
    if (table.withdrawn > 0) out.push_back(fmt::format("{} withdrew", table.withdrawn));
    return listed(out);
}

std::string testsSentence(const AnalysisResult& result) {
    std::set<std::string> methods;
    for (const Comparison& one : result.pairwise)
        if (one.test.n_pairs > 0) methods.insert(one.test.method);
    const bool approximate = methods.contains("normal approximation");
    const std::size_t pairs = result.table.systems.size() * (result.table.systems.size() - 1) / 2;
    return fmt::format(
        " For each pair of systems we compared participants' means by two-sided Wilcoxon signed-rank tests "
        "({}, differences of zero dropped), with Holm's correction over the {} of each measure (&#945; = "
        "{}). "
        "Shifts are Hodges&#8211;Lehmann estimates with {:g}&#160;% intervals that invert these tests; "
        "intervals of means are "
        "bootstrap intervals over participants ({} resamples).",
        approximate ? "normal approximation where there were more than 2,000 differences, else exact"
                    : "exact, also with ties",
        pairs == 1 ? "one pair" : fmt::format("{} pairs", pairs), result.alpha, 100.0 * result.level,
        result.options.resamples);
}

std::string methodsParagraph(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    const bool tested = std::any_of(result.pairwise.begin(), result.pairwise.end(),
                                    [](const Comparison& one) { return one.test.n_pairs > 0; });
    const auto [fewest, most] = answersPerParticipant(table);
    const std::string answers =
        fewest >= most ? fmt::format("{}", most) : fmt::format("{} to {}", fewest, most);
    std::string out =
        fmt::format("{} {}, who gave {} answers each{}. Systems: {}, {}. Measures: {}.",
                    result.synthetic ? "Simulated participants, no people, stand here for a sample of"
                                     : "The answers come from",
                    counted(result.participants, "participant", "participants"), answers,
                    leftOutText(result).empty() ? "" : " (left out: " + leftOutText(result) + ")",
                    listed(escaped(table.systems)),
                    systemsMeetInParticipants(table) ? "within participants" : "one for each participant",
                    listed(measureTexts(table)));
    if (tested) out += testsSentence(result);
    if (!result.preferences.empty())
        out +=
            " Preferences between two systems were tested in the same way, as participants' mean preferences "
            "against none.";
    if (std::any_of(result.between.begin(), result.between.end(),
                    [](const BetweenResult& one) { return one.factor == systems_between; }))
        out +=
            " Systems that no participant met both of were compared by two-sided Wilcoxon rank-sum tests of "
            "participants' means, Holm-corrected.";
    if (!table.between.empty() && (!result.between.empty() || !result.preferences_between.empty()))
        out += " Groups of participants were compared by two-sided Wilcoxon rank-sum tests, Holm-corrected.";
    return out;
}

std::vector<std::string> limitations(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    std::vector<std::string> out;
    if (result.synthetic)
        out.emplace_back(
            "Answers come from simulated participants: they show that the pipeline works and what a "
            "study of this size could find, and nothing about people.");
    const bool rated = std::any_of(table.measures.begin(), table.measures.end(),
                                   [](const Measure& one) { return one.kind == MeasureKind::rating; });
    if (result.participants > 1 && table.systems.size() > 1)
        out.emplace_back(
            "A difference that is not significant is not shown to be none: its interval tells which "
            "differences the data leave possible.");
    if (!result.items.empty())
        out.emplace_back(
            "The tests speak about other participants with these same targets and clips. For other "
            "targets, look at the mixed models with item intercepts that the R script fits.");
    if (rated)
        out.emplace_back(
            "Means take a rating's steps as equally wide, and the shift of the signed-rank test "
            "supposes that differences lie evenly around it. Cumulative link models do not.");
    std::set<std::string> families;
    for (const auto* tests : {&result.pairwise, &result.level_tests})
        for (const Comparison& one : *tests)
            if (one.family_size > 0) families.insert(one.family);
    for (const PreferenceResult& one : result.preferences) families.insert(one.family);
    for (const BetweenResult& one : result.between) families.insert(one.family);
    for (const OrderResult& one : result.order) families.insert(one.family);
    for (const ChanceResult& one : result.chance)
        if (one.family_size > 0) families.insert(one.family);
    if (families.size() > 1)
        out.push_back(
            fmt::format("Holm's correction holds within each of the {} families of tests of this page, "
                        "not over all of them together: name the families that were planned.",
                        families.size()));
    const bool at_desktop =
        std::any_of(table.stations.begin(), table.stations.end(),
                    [](const StationUse& one) { return one.kind == "desktop" && !one.synthetic; });
    if (at_desktop)
        out.emplace_back(
            "Participants saw the avatar on a flat screen, without depth from two eyes and from their "
            "own movement: pointing in a headset may be understood otherwise.");
    if (!table.left_out.empty() || table.withdrawn > 0)
        out.emplace_back(
            "Some participants are left out; where that decides, the section on choices says so.");
    return out;
}

}  // namespace

std::string designHtml(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    std::string out = "\n<h2>Design and participants</h2><dl>";
    const auto entry = [&](const char* name, const std::string& html) {
        out += fmt::format("<dt>{}</dt><dd>{}</dd>", name, html);
    };
    if (!table.systems.empty())
        entry("Systems", fmt::format("{}: {}{}", table.systems.size(), listed(escaped(table.systems)),
                                     table.systems.size() < 2           ? ""
                                     : systemsMeetInParticipants(table) ? " (within participants)"
                                                                        : " (between participants)"));
    if (!table.measures.empty()) entry("Measures", listed(measureTexts(table)));
    for (const Factor& factor : withinFactors(table))
        entry("Within participants",
              fmt::format("{} ({})", escapeHtml(factor.name), listed(escaped(factor.levels))));
    for (const Factor& factor : table.between) entry("Between participants", groupsText(table, factor));
    std::string people = fmt::format("{} of {} planned have answered", result.participants,
                                     std::max(result.participants, table.planned_participants));
    if (const std::string left_out = leftOutText(result); !left_out.empty())
        people += "; left out: " + left_out;
    entry("Participants", people);
    if (const auto [fewest, most] = answersPerParticipant(table); most > 0)
        entry("Answers",
              fmt::format("{} in all, {} of each participant", table.rows.size(),
                          fewest == most ? fmt::format("{}", most) : fmt::format("{} to {}", fewest, most)));
    return out + "</dl>";
}

std::string paperHtml(const AnalysisResult& result) {
    std::string out =
        "\n<h2>For the paper</h2><p><b>Methods, to be copied.</b> " + methodsParagraph(result) + "</p>";
    const auto limits = limitations(result);
    if (limits.empty()) return out;
    out += "<p><b>Limitations.</b></p><ul class=\"findings\">";
    for (const std::string& one : limits) out += "<li>" + one + "</li>";
    return out + "</ul>";
}

}  // namespace deixis::results
