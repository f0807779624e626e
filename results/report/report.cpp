// The report's page: what stands where.
#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "computed.hpp"
#include "figures.hpp"
#include "findings.hpp"
#include "paper.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/outputs/bradley_terry_html.hpp"
#include "results/outputs/quality_html.hpp"
#include "results/page/html_table.hpp"
#include "results/page/number_text.hpp"
#include "results/page/page.hpp"
#include "results/report/report.hpp"
#include "sections.hpp"
#include "studies.hpp"
#include "synthetic_motion.hpp"
#include "tests.hpp"

namespace deixis::results {

namespace {

std::string meansTable(const AnalysisResult& result, Numbering& numbering) {
    if (result.measures.empty()) return "";
    const bool with_median = std::any_of(result.measures.begin(), result.measures.end(), hasManySteps);
    std::vector<Shown> shown{"measure", "system", "mean"};
    if (with_median) shown.emplace_back("median_of_many_steps");
    shown.insert(shown.end(), {"interval", "sd_participants", "sd_trials", "answers"});
    const std::string out = tableHtml(
        tables::means(result),
        fmt::format("Means of each system, over participants{}. Interval: {:g}\u00a0%, bootstrap over "
                    "participants. SD trials and n are of single answers.",
                    with_median ? ", and medians" : "", 100.0 * result.level),
        shown, numbering);
    const bool falls_short =
        std::any_of(result.systems.begin(), result.systems.end(), [](const auto& system) {
            return std::any_of(system.measures.begin(), system.measures.end(),
                               [](const Summary& one) { return one.interval_falls_short; });
        });
    return out + (falls_short ? noteHtml("\u2021 With so few participants no interval within the range of "
                                         "their means reaches that coverage; it is too narrow.")
                              : "");
}

/// A row for each system, and one for all; only that one where each system has one level. Empty without
/// answers.
std::string levelTable(const AnalysisResult& result, const Measure& measure, const std::string& factor,
                       Numbering& numbering) {
    Table rows = tables::levels(result, factor).where("measure", measure.name);
    std::vector<std::string> levels;
    for (const Table::Row& row : rows.where("system", "all").rows)
        levels.push_back(row.cells[rows.at("level")].text());
    if (levels.empty()) return "";
    bool crossed = levels.size() == 1;
    for (const std::string& system : result.table.systems) {
        const Table of = rows.where("system", system);
        crossed = crossed || std::count_if(of.rows.begin(), of.rows.end(), [&](const Table::Row& row) {
                                 return !row.cells[of.at("mean")].empty();
                             }) > 1;
    }
    if (!crossed) rows = rows.where("system", "all");
    const std::size_t mean = rows.at("mean");
    const std::size_t sd = rows.at("sd_trials");
    const auto meanAndSd = [=](const Table::Row& row) -> Cell {
        const auto* of = row.cells[mean].as<double>();
        if (of == nullptr) return {};
        const auto* spread = row.cells[sd].as<double>();
        return fmt::format("{} \u00b1 {}", fixedText(*of, 2), spread ? fixedText(*spread, 2) : "\u2013");
    };
    const auto n = [place = rows.at("answers")](const Table::Row& row) { return row.cells[place]; };
    Table table = wide(rows, {"system"}, "level", levels,
                       {{[](const std::string& level) { return level; }, meanAndSd},
                        {[](const std::string&) { return "n"; }, n}});
    for (Table::Row& row : table.rows) row.all = row.cells.front().text() == "all";
    const bool accuracy = measure.kind == MeasureKind::accuracy;
    table.unit = accuracy ? units::choices : measure.unit.empty() ? units::ratings : units::answers;
    return tableHtml(
        table,
        fmt::format(
            "{} by {}: {}mean \u00b1 standard deviation over trials{}.", capitalised(measure.name), factor,
            accuracy ? "proportion correct, " : "",
            accuracy && factor == "layout" && isPointing2023(result.table) ? " (the paper's Table 1)" : ""),
        numbering);
}

std::string joined(const std::vector<std::string>& items) {
    std::string out;
    for (const auto& item : items) out += (out.empty() ? "" : ", ") + escapeHtml(item);
    return out;
}

/// Answers in marked trials and participants who failed a check: in the headline, and not in one of the other
/// choices.
std::string doubtfulButKept(const ResponseTable& table) {
    std::map<std::string, int> marks;
    for (const ResponseRow& row : table.rows)
        if (!row.marked.empty()) ++marks[row.marked];
    std::string out;
    for (const auto& [why, n] : marks)
        out += fmt::format("{}{} ({} {})", out.empty() ? "Marked trials: " : ", ", escapeHtml(why), n,
                           n == 1 ? "answer" : "answers");
    if (!out.empty()) out += ".";
    if (!table.failed_checks.empty())
        out += fmt::format("{}Failed a check: {}.", out.empty() ? "" : " ",
                           joined({table.failed_checks.begin(), table.failed_checks.end()}));
    if (out.empty()) return "";
    return paragraphHtml(out +
                         " Their answers count in the headline; what changes without them is shown above.");
}

Section checksAndLeftOut(const AnalysisResult& result, Numbering& numbering) {
    const ResponseTable& table = result.table;
    const std::string kept = doubtfulButKept(table);
    if (table.checks.empty() && table.left_out.empty() && table.withdrawn == 0 && kept.empty()) return {};
    std::string out;
    const std::string heading = "Attention checks and exclusions";
    if (!table.checks.empty())
        out += tableHtml(tables::checks(result),
                         "Attention checks of all participants, including excluded ones.", numbering);
    out += kept;
    if (table.withdrawn > 0)
        out += paragraphHtml(counted(table.withdrawn, "participant", "participants") +
                             " withdrew; none of their data is kept.");
    if (table.left_out.empty())
        return {heading, out + paragraphHtml(table.withdrawn > 0 ? "Nobody else is left out."
                                                                 : "Nobody is left out.")};
    std::vector<std::string> people;
    for (const auto& one : table.left_out)
        people.push_back(fmt::format("{}: {} ({})", one.participant, one.dropped ? "dropped out" : "excluded",
                                     one.reason));
    return {heading,
            out + paragraphHtml("The answers of these participants are left out:") + listHtml(people)};
}

Section provenance(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    std::vector<Fact> facts;
    const auto entry = [&](const std::string& name, const std::string& html) {
        facts.push_back({name, html});
    };
    entry("Data", escapeHtml(table.database));
    entry("Answers (SHA-256)", result.answers_hash);
    for (const Fact& fact : studyOrigins(table)) facts.push_back(fact);
    if (!table.study_hash.empty()) {
        if (table.origins.empty()) {
            entry("Study", escapeHtml(table.study_name));
            entry("Study file (SHA-256)", escapeHtml(table.study_hash));
        }
        entry("Recorded by", joined(table.program_versions));
        if (!table.operating_systems.empty()) entry("Recorded on", joined(table.operating_systems));
        entry("Avatar (SHA-256)", joined(table.avatar_hashes));
    }
    if (!result.options.program.empty()) entry("Analysed by", escapeHtml(result.options.program));
    for (const auto& [name, value] : result.options.build) entry(propertyLabel(name), escapeHtml(value));
    entry("Settings",
          fmt::format("\u03b1 = {}, intervals at {:g}\u00a0%, {} bootstrap resamples, seed {}", result.alpha,
                      100.0 * result.level, result.options.resamples, result.options.seed));
    for (const auto& station : table.stations)
        entry("Station", fmt::format("{}{}: {} session{}{}", escapeHtml(station.kind),
                                     station.synthetic ? " (answers not from a person)" : "",
                                     station.sessions, station.sessions == 1 ? "" : "s",
                                     station.details.empty() ? "" : "; " + escapeHtml(station.details)));
    return {"Where the numbers come from", factsHtml(facts)};
}

std::string stationKinds(const ResponseTable& table) {
    std::string out;
    std::string last;
    for (const auto& station : table.stations)
        if (station.kind != last) {
            out += (out.empty() ? "" : ", ") + escapeHtml(station.kind);
            last = station.kind;
        }
    return out;
}

/// " (120 accuracy, 60 naturalness)": a trial may give several answers. Empty for one measure.
std::string answersByMeasure(const ResponseTable& table) {
    if (table.measures.size() < 2) return "";
    std::map<std::string, int> counts;
    for (const ResponseRow& row : table.rows) ++counts[row.measure];
    std::string out;
    for (const Measure& measure : table.measures)
        out +=
            fmt::format("{}{} {}", out.empty() ? "" : ", ", counts[measure.name], escapeHtml(measure.name));
    return " (" + out + ")";
}

std::string headOf(const AnalysisResult& result) {
    const ResponseTable& table = result.table;
    const auto number = [](std::size_t n) { return static_cast<int>(n); };
    std::string out =
        pageStart(table.study_title + " \u2013 report", table.study_title) +
        paragraphHtml(
            fmt::format(
                "{}{} \u00b7 {} analysed{} \u00b7 {}{}{}",
                result.by_study.empty() ? "" : fmt::format("{} studies \u00b7 ", result.by_study.size()),
                counted(result.participants, "participant", "participants"),
                counted(number(table.rows.size()), "answer", "answers"), answersByMeasure(table),
                counted(number(table.systems.size()), "system", "systems"),
                table.not_compared.empty()
                    ? ""
                    : fmt::format(" and {} that {} not compared", table.not_compared.size(),
                                  table.not_compared.size() == 1 ? "is" : "are"),
                table.stations.empty() ? "" : " \u00b7 station: " + stationKinds(table)),
            ParagraphLook::lead);
    if (result.synthetic)
        out += titledParagraph(
            "Simulated participants:", "these numbers test the pipeline and are no evidence about people.",
            ParagraphLook::synthetic);
    if (const std::string motion = syntheticMotionText(table); !motion.empty())
        out += titledParagraph("Synthetic motion:", motion, ParagraphLook::synthetic);
    return out + findingsHtml(result);
}

Section meansSection(const AnalysisResult& result, Numbering& numbering) {
    if (result.measures.empty()) return {};
    // One after another: the tables count.
    std::string out = meansTable(result, numbering);
    out += distributionsHtml(result, numbering);
    out += pooledHtml(result, numbering);
    for (const Factor& factor : withinFactors(result.table))
        for (const Measure& measure : result.measures)
            out += levelTable(result, measure, factor.name, numbering);
    return {result.by_study.empty() ? "Means" : "Means, all studies pooled", out};
}

}  // namespace

std::string renderReport(const AnalysisResult& result) {
    Numbering figures("Figure");
    Numbering tables;
    // Figures and tables count: braces, from the first to the last.
    std::vector<Section> sections{designSection(result, figures),
                                  meansSection(result, tables),
                                  notComparedSection(result, tables),
                                  studiesSection(result, tables),
                                  testsSection(result, tables),
                                  differencesSection(result, figures),
                                  bradleyTerrySection(result, tables),
                                  sensitivitySection(result, tables),
                                  betweenSection(result, tables),
                                  choicesSection(result, figures, tables),
                                  measuredSection(result, figures, tables),
                                  objectiveSection(result, tables),
                                  descriptivesSection(result, tables),
                                  scoresSection(result, tables),
                                  qualitySection(result, tables),
                                  checksAndLeftOut(result, tables),
                                  presenceSection(result, tables),
                                  remarksSection(result.remarks),
                                  paperSection(result),
                                  {"Methods in full", methodsHtml(result)},
                                  provenance(result)};
    return withContents(headOf(result), std::move(sections)) + pageEnd("The tables have all their numbers.");
}

}  // namespace deixis::results
