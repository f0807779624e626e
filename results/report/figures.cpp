// Which figures stand at the report's head, and the tables of what only they draw.
#include "figures.hpp"

#include <fmt/core.h>

#include <numeric>

#include "results/analysis/several_studies.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/page/html_table.hpp"
#include "results/statistics/descriptive.hpp"
#include "studies.hpp"

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
    return figuresPlaced(out);
}

namespace {

std::string boxesTable(const AnalysisResult& result, Numbering& numbering) {
    Table table{"boxes",
                units::means,
                "",
                {{"measure", ColumnKind::text}, {"study", ColumnKind::text}, {"system", ColumnKind::text}}};
    const auto add = [&](const AnalysisResult& of, std::size_t i, const std::string& study) {
        const auto fields = boxFields([&](double value) { return scoreText(of.measures[i], value); });
        if (table.columns.size() == 3)
            for (const Column& column : columnsOf(fields)) table.columns.push_back(column);
        for (const SystemResult& system : of.systems)
            if (const auto box = boxSummary(system.measures[i].by_participant)) {
                Table::Row& row =
                    table.rows.emplace_back(Table::Row{{of.measures[i].name, study, system.system}});
                for (Cell& cell : cellsOf(fields, *box)) row.cells.push_back(std::move(cell));
            }
    };
    for (std::size_t i = 0; i < result.measures.size(); ++i) {
        for (const AnalysisResult& one : result.by_study) add(one, i, one.table.study_name);
        add(result, i, result.by_study.empty() ? "" : pooled_studies);
    }
    if (table.rows.empty()) return "";
    std::vector<Shown> shown{"measure", "system", "q05", "q25", "median", "q75", "q95", "notch", "n"};
    if (!result.by_study.empty()) shown.insert(shown.begin() + 1, "study");
    return tableHtml(table,
                     "What the box plots show: quantiles of the participants' means; no notch if it would "
                     "reach beyond its box. n counts participants.",
                     shown, numbering);
}

std::string stepsTable(const AnalysisResult& result, std::size_t measure, const StepCounts& counts,
                       Numbering& numbering) {
    Table table{"steps", units::ratings, "", {{"system", ColumnKind::text}}};
    for (const int step : counts.steps)
        table.columns.emplace_back(fmt::format("{}", step), ColumnKind::number);
    table.columns.emplace_back("n", ColumnKind::number);
    for (std::size_t i = 0; i < result.systems.size(); ++i) {
        Table::Row& row = table.rows.emplace_back(Table::Row{{result.systems[i].system}});
        const int all = std::accumulate(counts.counts[i].begin(), counts.counts[i].end(), 0);
        for (const int count : counts.counts[i])
            row.cells.push_back(all > 0 ? Cell(fmt::format("{} ({:.0f}\u00a0%)", count, 100.0 * count / all))
                                        : Cell());
        row.cells.emplace_back(all);
    }
    return tableHtml(
        table, capitalised(result.measures[measure].name) + ": how often each step of the scale was chosen.",
        numbering);
}

}  // namespace

std::string distributionsHtml(const AnalysisResult& result, Numbering& tables) {
    std::string out = result.participants > 1 ? boxesTable(result, tables) : std::string();
    for (std::size_t i = 0; i < result.measures.size(); ++i)
        if (const auto counts = stepCounts(result, i)) out += stepsTable(result, i, *counts, tables);
    return out;
}

}  // namespace deixis::results
