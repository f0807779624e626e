// Several studies: medians in order, each study's tests, and where the answers come from.
#include "studies.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "results/analysis/several_studies.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/page/html_table.hpp"
#include "tests.hpp"

namespace deixis::results {

namespace {

const Summary* summaryOf(const AnalysisResult& result, const MedianResult& of) {
    const AnalysisResult* found = of.study == pooled_studies ? &result : nullptr;
    for (const AnalysisResult& one : result.by_study)
        if (one.table.study_name == of.study) found = &one;
    for (std::size_t i = 0; found != nullptr && i < found->measures.size(); ++i)
        if (found->measures[i].name == of.measure)
            for (const SystemResult& system : found->systems)
                if (system.system == of.system) return &system.measures[i];
    return nullptr;
}

std::string mediansTable(const AnalysisResult& result, const Measure& measure, Numbering& numbering) {
    const bool of_ratings =
        std::any_of(result.medians.begin(), result.medians.end(),
                    [](const MedianResult& one) { return one.answers_median.has_value(); });
    Table table = tables::studyMedians(result);
    table.columns.push_back({"mean", ColumnKind::number});
    table.columns.push_back({"interval", ColumnKind::range});
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const MedianResult& one = result.medians[i];
        const Summary* summary = summaryOf(result, one);
        Table::Row& row = table.rows[i];
        row.all = one.study == pooled_studies;
        row.cells.push_back(summary != nullptr ? Cell(summary->mean) : Cell());
        row.cells.emplace_back(summary != nullptr ? intervalOf(summary->interval) : Interval{});
    }
    table = table.where("measure", measure.name);
    if (table.rows.empty()) return "";
    if (!of_ratings) table.unit = units::means;
    std::vector<Shown> shown{"study", "place",    "system",       "median",
                             "mean",  "interval", "participants", "answers"};
    if (of_ratings) shown.insert(shown.begin() + 4, "median_of_ratings");
    return tableHtml(
        table,
        fmt::format("{}: the systems by their medians, highest first, in each study and pooled.{} Mean with "
                    "its {:g}\u00a0% interval, bootstrap over participants. n counts participants.",
                    capitalised(measure.name),
                    of_ratings ? " Beside the median of participants' means is that of single ratings, which "
                                 "are pseudo-replicated."
                               : "",
                    100.0 * result.level),
        shown, numbering, dense_table);
}

}  // namespace

std::string mediansSentence(const AnalysisResult& result, const std::string& study, const Measure& measure) {
    std::vector<std::string> out;
    for (const MedianResult& one : result.medians)
        if (one.measure == measure.name && one.study == study)
            out.push_back(fmt::format("{} {}", escapeHtml(one.system), scoreText(measure, one.median)));
    return out.empty() ? "" : fmt::format("Medians, highest first: {}.", fmt::join(out, ", "));
}

Section studiesSection(const AnalysisResult& result, Numbering& numbering) {
    if (result.by_study.empty()) return {};
    const std::size_t n = result.by_study.size();
    std::string out = paragraphHtml(fmt::format(
        "The {} studies are groups of participants, who are different people in each. Their systems are "
        "tested within each study, and over all participants together (pooled). "
        "Holm's correction covers the pairs of systems of one measure in one study, and those of one measure "
        "pooled: {} families for each measure. What changes under other choices of answers is shown for the "
        "pooled tests; each study's own report shows it for that study.",
        n, n + 1));
    for (const Measure& measure : result.measures) out += mediansTable(result, measure, numbering);
    for (const AnalysisResult& study : result.by_study) out += studyTestsHtml(study, numbering);
    return {"Each study separately", out};
}

std::vector<Fact> studyOrigins(const ResponseTable& table) {
    std::vector<Fact> out;
    for (const DataOrigin& one : table.origins) {
        std::vector<std::string> facts;
        const auto add = [&](const char* name, const std::string& text) {
            if (!text.empty()) facts.push_back(fmt::format("{}{}", name, escapeHtml(text)));
        };
        add("", one.data);
        if (one.schema_version > 0) facts.push_back(fmt::format("schema {}", one.schema_version));
        facts.push_back(one.simulated == 0
                            ? counted(one.people, "participant", "participants")
                            : counted(one.simulated, "simulated participant (not a person)",
                                      "simulated participants (not people)") +
                                  (one.people > 0 ? " and " + counted(one.people, "person", "people") : ""));
        facts.push_back(counted(one.answers, "answer", "answers"));
        if (one.left_out > 0) facts.push_back(fmt::format("{} left out", one.left_out));
        if (one.withdrawn > 0) facts.push_back(fmt::format("{} withdrew", one.withdrawn));
        add("recorded by ", fmt::format("{}", fmt::join(one.program_versions, ", ")));
        add("study file (SHA-256) ", one.study_hash);
        add("answers (SHA-256) ", one.answers_hash);
        out.push_back({"Study " + one.study, fmt::format("{}", fmt::join(facts, "; "))});
    }
    return out;
}

}  // namespace deixis::results
