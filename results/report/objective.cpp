// Answers beside the objective evaluation of the same clips.
#include <fmt/core.h>

#include <algorithm>

#include "results/outputs/analysis_tables.hpp"
#include "results/page/html_table.hpp"
#include "sections.hpp"

namespace deixis::results {

namespace {

/// The systems of one measure, from the highest to the lowest.
std::string order(const Table& means, const char* by) {
    std::vector<std::pair<double, std::string>> systems;
    for (const Table::Row& row : means.rows)
        systems.emplace_back(*row.cells[means.at(by)].as<double>(), row.cells[means.at("system")].text());
    std::stable_sort(systems.begin(), systems.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::string out;
    for (const auto& [mean, system] : systems) out += (out.empty() ? "" : " > ") + system;
    return out;
}

}  // namespace

Section objectiveSection(const AnalysisResult& result, Numbering& numbering) {
    if (result.objective.correlations.empty()) return {};
    const Table means = tables::objectiveMeans(result);
    std::vector<std::string> orders;
    for (const Measure& measure : result.measures) {
        const Table of = means.where("measure", measure.name);
        if (of.rows.size() < 2) continue;
        const std::string objective = order(of, "equation_2"), answers = order(of, "mean");
        orders.push_back(
            objective == answers
                ? fmt::format("Equation 2 and {} have the systems in the same order: {}.", measure.name,
                              objective)
                : fmt::format("By Equation 2: {}; by {}: {}.", objective, measure.name, answers));
    }
    // One after another: the tables count.
    std::string out = listHtml(orders);
    out += tableHtml(means,
                     "Systems by the mean of Equation 2 (Deichler et al. 2023) over their clips, and by the "
                     "mean answer over participants.",
                     numbering);
    out +=
        tableHtml(tables::objectiveCorrelations(result),
                  "Spearman\u2019s rank correlation of mean answers with Equation 2: over the systems, and "
                  "for each system over its targets. A target\u2019s mean is over few answers; systems are "
                  "few. Not corrected for several tests.",
                  numbering);
    return {"Beside the objective evaluation", out};
}

}  // namespace deixis::results
