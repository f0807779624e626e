// Which figures stand at the report's head, and the tables of what only they draw.
#include "report_figures.hpp"

#include <fmt/core.h>

#include "report_studies.hpp"
#include "results/analysis/several_studies.hpp"
#include "results/page/report_tables.hpp"
#include "results/statistics/descriptive.hpp"

namespace deixis::results {

std::string figuresHtml(const AnalysisResult& result, Numbering& figures) {
    std::string out;
    for (std::size_t i = 0; i < result.measures.size(); ++i)
        out += figureHtml(result.by_study.empty() ? boxPlot(result, i, figures)
                                                  : studyBoxPlot(result, i, figures));
    for (std::size_t i = 0; i < result.measures.size(); ++i)
        if (const auto counts = stepCounts(result, i))
            out += figureHtml(answersFigure(result, i, *counts, figures));
    for (const Factor& factor : withinFactors(result.table))
        for (std::size_t i = 0; i < result.measures.size(); ++i)
            if (const auto levels = levelsFigure(result, i, factor, figures)) out += figureHtml(*levels);
    if (!result.preferences.empty()) out += figureHtml(preferencesFigure(result, figures));
    return out.empty() ? "" : "<div class=\"plots\">" + out + "</div>";
}

namespace {

std::string boxesTable(const AnalysisResult& result, Numbering& tables) {
    std::string rows;
    const auto add = [&](const AnalysisResult& of, std::size_t i, const std::string& study) {
        for (const SystemResult& system : of.systems) {
            const auto box = boxSummary(system.measures[i].by_participant);
            if (!box) continue;
            const auto score = [&](double value) { return scoreText(of.measures[i], value); };
            rows += fmt::format("<tr><th scope=\"row\">{}</th>{}<td class=\"text\">{}</td>{}</tr>",
                                escapeHtml(capitalised(of.measures[i].name)),
                                study.empty() ? "" : "<td class=\"text\">" + escapeHtml(study) + "</td>",
                                escapeHtml(system.system), boxCells(*box, score));
        }
    };
    for (std::size_t i = 0; i < result.measures.size(); ++i) {
        for (const AnalysisResult& one : result.by_study) add(one, i, one.table.study_name);
        add(result, i, result.by_study.empty() ? "" : pooled_studies);
    }
    if (rows.empty()) return "";
    return openTable(units::means,
                     "What the box plots draw: quantiles of the participants' means; no notch where it would "
                     "reach beyond its box. n counts participants.",
                     fmt::format("<th>Measure</th>{}<th class=\"text\">System</th>{}",
                                 result.by_study.empty() ? "" : "<th class=\"text\">Study</th>", box_columns),
                     tables) +
           rows + close_table;
}

std::string stepsTable(const AnalysisResult& result, std::size_t measure, const StepCounts& counts,
                       Numbering& tables) {
    std::string head;
    for (const int step : counts.steps) head += fmt::format("<th>{}</th>", step);
    std::string rows;
    for (std::size_t i = 0; i < result.systems.size(); ++i) {
        rows += fmt::format("<tr><th scope=\"row\">{}</th>", escapeHtml(result.systems[i].system));
        int all = 0;
        for (const int count : counts.counts[i]) all += count;
        for (const int count : counts.counts[i])
            rows += all > 0 ? fmt::format("<td>{} ({:.0f}&#160;%)</td>", count, 100.0 * count / all)
                            : fmt::format("<td>{}</td>", dash);
        rows += fmt::format("<td>{}</td></tr>", all);
    }
    return openTable(units::ratings,
                     escapeHtml(capitalised(result.measures[measure].name)) +
                         ": how often each step of the scale was chosen.",
                     "<th>System</th>" + head + "<th>n</th>", tables) +
           rows + close_table;
}

}  // namespace

std::string distributionsHtml(const AnalysisResult& result, Numbering& tables) {
    std::string out = result.participants > 1 ? boxesTable(result, tables) : std::string();
    for (std::size_t i = 0; i < result.measures.size(); ++i)
        if (const auto counts = stepCounts(result, i)) out += stepsTable(result, i, *counts, tables);
    return out;
}

}  // namespace deixis::results
