// Systems that a study shows, but does not compare.
#include <algorithm>
#include <iterator>
#include <utility>

#include "results/analysis/analysis_steps.hpp"

namespace deixis::results {

void setAside(AnalysisResult& result) {
    ResponseTable& table = result.table;
    if (table.not_compared.empty()) return;
    const auto aside = [&](const std::string& system) { return table.not_compared.contains(system); };
    const auto isAside = [&](const ResponseRow& row) { return aside(row.system) || aside(row.other_system); };
    std::vector<std::string> systems;
    for (const std::string& system : table.systems)
        if (aside(system)) systems.push_back(system);
    std::erase_if(table.systems, aside);
    const auto first = std::stable_partition(table.rows.begin(), table.rows.end(),
                                             [&](const ResponseRow& row) { return !isAside(row); });
    table.aside_rows.insert(table.aside_rows.end(), std::make_move_iterator(first),
                            std::make_move_iterator(table.rows.end()));
    table.rows.erase(first, table.rows.end());
    std::erase_if(table.left_out_rows, isAside);
    std::erase_if(table.skipped_rows, isAside);
    std::erase_if(table.choices, [&](const ChoiceRow& one) { return aside(one.system); });
    std::erase_if(table.watched, [&](const ObservedChoice& one) { return aside(one.seen.system); });

    // Who prefers what to such a system ranks it: of that there is no number.
    const CellsByMeasure cells = cellsOf(pointersTo(table.aside_rows));
    const Cells none;
    for (const std::string& system : systems) {
        SystemResult& row = result.not_compared.emplace_back(SystemResult{system, {}});
        for (const Measure& measure : result.measures) {
            const auto of_measure = cells.find(measure.name);
            row.measures.push_back(summarise(of_measure == cells.end() ? none : of_measure->second, system));
        }
    }
    if (result.level <= 0.0) return;
    std::vector<Summary*> summaries;
    for (SystemResult& row : result.not_compared)
        for (Summary& one : row.measures) summaries.push_back(&one);
    addIntervals(summaries, {result.options.resamples, result.options.seed, result.level});
}

}  // namespace deixis::results
