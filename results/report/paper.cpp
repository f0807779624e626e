#include "paper.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "computed.hpp"
#include "figures.hpp"
#include "paragraphs.hpp"
#include "participants.hpp"
#include "results/analysis/analysis_steps.hpp"
#include "results/analysis/several_studies.hpp"
#include "results/page/html_table.hpp"
#include "results/page/page.hpp"
#include "synthetic_motion.hpp"

namespace deixis::results {

namespace {

std::vector<std::string> escaped(const std::vector<std::string>& texts) {
    std::vector<std::string> out;
    for (const std::string& text : texts) out.push_back(escapeHtml(text));
    return out;
}

std::string groupsText(const AnalysisResult& result, const Factor& factor) {
    std::map<std::string, int> sizes;
    if (factor.name == study_factor && !result.by_study.empty())
        for (const AnalysisResult& one : result.by_study) sizes[one.table.study_name] = one.participants;
    else
        for (const auto& [participant, levels] : result.table.groups)
            if (const auto level = levels.find(factor.name); level != levels.end()) ++sizes[level->second];
    std::vector<std::string> out;
    for (const std::string& level : factor.levels)
        out.push_back(fmt::format("{}: {}", escapeHtml(level), sizes[level]));
    return fmt::format("{} ({})", escapeHtml(factor.name), inSentence(out));
}

std::vector<std::string> limitations(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    std::vector<std::string> out;
    if (result.synthetic)
        out.emplace_back(
            "Answers come from simulated participants: they show that the pipeline works and what a study of "
            "this size could find, but nothing about people.");
    if (std::string motion = syntheticMotionText(table); !motion.empty()) out.push_back(std::move(motion));
    for (const auto& [system, remark] : table.not_compared)
        out.push_back(fmt::format("{} was shown, but is not compared: {}", systemWithMotion(table, system),
                                  escapeHtml(remark)));
    if (!result.by_study.empty())
        out.emplace_back(
            "Participants were not assigned to the studies by this program: a difference between studies may "
            "come from anything in which they differ, including their people, clips and time. Pooled tests "
            "treat all participants as one sample, in which a study with more of them weighs more.");
    const bool rated = std::any_of(table.measures.begin(), table.measures.end(),
                                   [](const Measure& one) { return one.kind == MeasureKind::rating; });
    if (result.participants > 1 && table.systems.size() > 1)
        out.emplace_back(
            "A difference that is not significant has not been shown to be zero: its interval shows which "
            "differences are compatible with the data.");
    if (!result.items.empty())
        out.emplace_back(
            "The tests generalise to other participants with these same targets and clips. For other "
            "targets, look at the mixed models with item intercepts that the R script fits.");
    if (rated)
        out.emplace_back(
            "Means treat a rating's steps as equally wide, and the shift of the signed-rank test assumes "
            "that differences are distributed symmetrically around it. Cumulative link models do not.");
    std::set<std::string> families;
    const auto count = [&families](const auto& tests) {
        for (const auto& one : tests)
            if (one.family_size > 0) families.insert(one.family);
    };
    count(result.pairwise);
    count(result.rating_pairs);
    count(result.author_trials);
    count(result.author_trials_paired);
    count(result.level_tests);
    count(result.preferences);
    count(result.chance);
    count(result.order);
    count(result.between);
    count(result.preferences_between);
    count(result.interactions);
    count(result.group_interactions);
    count(result.score_changes);
    count(result.score_groups);
    count(result.time_tests);
    count(result.time_groups);
    for (const AnalysisResult& study : result.by_study) {
        count(study.pairwise);
        count(study.rating_pairs);
        count(study.author_trials);
        count(study.author_trials_paired);
        count(study.preferences);
        count(study.between);
    }
    if (families.size() > 1)
        out.push_back(
            fmt::format("Holm's correction applies within each of the {} families of tests of this page, not "
                        "over all of them: name the families that were planned.",
                        families.size()));
    const bool at_desktop =
        std::any_of(table.stations.begin(), table.stations.end(),
                    [](const StationUse& one) { return one.kind == "desktop" && !one.synthetic; });
    if (at_desktop)
        out.emplace_back(
            "Participants saw the avatar on a flat screen, without stereo depth and motion parallax: "
            "pointing may be understood differently in a headset.");
    if (const auto failed = static_cast<int>(table.failed_checks.size()); failed > 0)
        out.push_back(
            fmt::format("{} failed an attention check and {} not excluded: {} answers count in the headline, "
                        "and the section on other choices says what changes without them.",
                        counted(failed, "participant", "participants"), failed == 1 ? "is" : "are",
                        failed == 1 ? "this participant's" : "their"));
    if (!table.left_out.empty() || table.withdrawn > 0)
        out.emplace_back(
            "Some participants are left out; if that changes a decision, the section on other choices says "
            "so.");
    return out;
}

}  // namespace

Section designSection(const AnalysisResult& result, Numbering& figures) {
    const ResponseTable& table = result.table;
    std::vector<Fact> facts;
    const auto entry = [&](const std::string& name, const std::string& html) {
        facts.push_back({name, html});
    };
    std::vector<std::string> systems;
    for (const std::string& system : table.systems) systems.push_back(systemWithMotion(table, system));
    if (!systems.empty())
        entry("Systems", fmt::format("{}: {}{}", table.systems.size(), inSentence(systems),
                                     table.systems.size() < 2           ? ""
                                     : systemsMeetInParticipants(table) ? " (within participants)"
                                                                        : " (between participants)"));
    for (const auto& [system, remark] : table.not_compared)
        entry("Not compared", fmt::format("{}: {}", systemWithMotion(table, system), escapeHtml(remark)));
    if (!table.measures.empty()) entry("Measures", inSentence(measureTexts(table)));
    for (const Factor& factor : withinFactors(table))
        entry("Within participants",
              fmt::format("{} ({})", escapeHtml(factor.name), inSentence(escaped(factor.levels))));
    for (const Factor& factor : table.between) entry("Between participants", groupsText(result, factor));
    // It is not known how many were planned of other data than a study's, and for one kind of station.
    std::string people = !table.study_hash.empty() && table.planned_participants > 0
                             ? fmt::format("{} of {} planned have answered", result.participants,
                                           std::max(result.participants, table.planned_participants))
                             : counted(result.participants, "has answered", "have answered");
    if (const std::string left_out = leftOutText(result); !left_out.empty())
        people += "; left out: " + left_out;
    entry("Participants", people);
    for (const auto& [name, text] : participantEntries(result)) entry(name, text);
    if (const auto [min, max] = answersPerParticipant(table); max > 0)
        entry("Answers",
              fmt::format("{} in all, {} per participant", table.rows.size(),
                          min == max ? fmt::format("{}", max) : fmt::format("{} to {}", min, max)));
    return {"Design and participants", factsHtml(facts) + figuresHtml(result, figures)};
}

Section paperSection(const AnalysisResult& result) {
    std::string out = titledParagraph("Methods, to copy.", methodsParagraph(result));
    if (const std::string results = resultsParagraphs(result); !results.empty())
        out +=
            folded("Results, to copy: means, and the comparisons of systems, levels, groups and preferences",
                   results);
    if (const auto limits = limitations(result); !limits.empty())
        out += titledParagraph("Limitations.", "") + itemsHtml(limits);
    if (const auto works = references(result); !works.empty())
        out += titledParagraph("References.", "") + itemsHtml(works);
    return {"For the paper", out};
}

}  // namespace deixis::results
