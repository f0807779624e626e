// The tables of the evaluation's page.
#include "page_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "results/page/html_table.hpp"
#include "results/statistics/holm.hpp"
#include "tables.hpp"

namespace deixis::results {

namespace {

/// Synthetic systems have a star.
std::string starred(const SystemEvaluation& system) {
    return system.system + (system.synthetic ? "\u00a0*" : "");
}

/// With the systems' starred names in the place of their names; a row for each system.
Table starred(Table table, const Evaluation& evaluation) {
    const std::size_t place = table.at("system");
    for (std::size_t i = 0; i < table.rows.size(); ++i)
        table.rows[i].cells[place] = starred(evaluation.systems[i]);
    return table;
}

constexpr std::array profile_times_s{-1.0, -0.5, 0.0, 0.5, 1.0};

/// A row for each system and hand: mean and standard deviation at the times above.
std::string profileTable(const Evaluation& evaluation, bool reward, Numbering& numbering) {
    Table table{"profiles",
                units::clips,
                "",
                {{"system", ColumnKind::text}, {"hand", ColumnKind::text}, {"clips", ColumnKind::number}}};
    for (const double time : profile_times_s)
        table.columns.emplace_back(fixedText(time, 1) + " s", ColumnKind::number);
    const int decimals = reward ? 3 : 2;
    for (const SystemEvaluation& system : evaluation.systems)
        for (const auto& [hand, profile] :
             {std::pair{"right", &system.right}, std::pair{"left", &system.left}}) {
            if (profile->clips == 0) continue;
            Table::Row& row = table.rows.emplace_back(Table::Row{{starred(system), hand, profile->clips}});
            for (const double time : profile_times_s) {
                Cell& cell = row.cells.emplace_back();
                const auto& points = profile->points;
                const auto at = std::find_if(points.begin(), points.end(), [&](const ProfilePoint& point) {
                    return std::abs(point.time_s - time) < 0.5 * profile_step_s;
                });
                if (at == points.end()) continue;
                std::string text = fixedText(reward ? at->reward_mean : at->speed_mean, decimals);
                if (at->n > 1)
                    text += " \u00b1 " + fixedText(reward ? at->reward_sd : at->speed_sd, decimals);
                cell = text;
            }
        }
    return tableHtml(table,
                     reward ? "Reward around the time of pointing, mean \u00b1 standard deviation over clips."
                            : "Speed of the pointing hand (m/s) around the time of pointing, mean \u00b1 "
                              "standard deviation over clips.",
                     numbering);
}

}  // namespace

std::string systemsHtml(const Evaluation& evaluation, Numbering& numbering) {
    return tableHtml(starred(systemsTable(evaluation), evaluation),
                     "Accuracy (Equation 2, dimensionless) and the same as angle between forearm and target "
                     "(degrees), over clips; SD "
                     "with n \u2212 1.",
                     {"system", "n", "accuracy_mean", "accuracy_sd", "accuracy_median", "error_deg_mean",
                      "error_deg_sd", "error_deg_median", "missing", "left_hand"},
                     numbering);
}

std::string accuracyBoxesHtml(const Evaluation& evaluation, Numbering& numbering) {
    const auto fields = boxFields([](double value) { return fixedText(value, 3); });
    Table table{"boxes", units::clips, "", {{"system", ColumnKind::text}}};
    for (const Column& column : columnsOf(fields)) table.columns.push_back(column);
    for (const SystemEvaluation& system : evaluation.systems)
        if (const auto box = boxSummary(system.rewards)) {
            Table::Row& row = table.rows.emplace_back(Table::Row{{starred(system)}});
            for (Cell& cell : cellsOf(fields, *box)) row.cells.push_back(std::move(cell));
        }
    return tableHtml(table,
                     "What the box plots show: quantiles of the accuracy of a system\u2019s clips; no notch "
                     "if it would reach beyond its box.",
                     numbering);
}

std::string profilesHtml(const Evaluation& evaluation, Numbering& numbering) {
    const std::string rewards = profileTable(evaluation, true, numbering);
    return rewards + profileTable(evaluation, false, numbering);
}

std::string correlationTable(const Evaluation& evaluation, Numbering& numbering) {
    std::vector<double> p;
    for (const auto& system : evaluation.systems)
        p.push_back(system.correlation.method == "undefined" ? std::numeric_limits<double>::quiet_NaN()
                                                             : system.correlation.p);
    const std::vector<double> adjusted = holm(p);
    Table table = starred(systemsTable(evaluation), evaluation);
    table.columns.push_back({"p_holm", ColumnKind::number});
    table.columns.push_back({"by", ColumnKind::text, {.label = "p by"}});
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const SpearmanTest& test = evaluation.systems[i].correlation;
        const bool defined = test.method != "undefined";
        auto& cells = table.rows[i].cells;
        cells[table.at("n")] = test.n;
        cells.push_back(known(defined, adjusted[i]));
        cells.emplace_back(!defined                 ? "undefined"
                           : test.method == "exact" ? "all pairings"
                                                    : "Student\u2019s t");
    }
    return tableHtml(
        table,
        "Spearman's correlation of accuracy with the density of the training targets at the clip's target, "
        "two-sided (the paper's Table\u00a02).",
        {"system", "n", "density_rho", "density_p", "p_holm", "by"}, numbering);
}

std::string clustersHtml(const Evaluation& evaluation, Numbering& numbering) {
    const Table table = clustersTable(evaluation);
    std::vector<Shown> shown;
    for (const Column& column : table.columns)
        if (column.name != "centre") shown.emplace_back(column.name.c_str());
    return tableHtml(
        table,
        fmt::format(
            "Clusters of the training targets (MeanShift, bandwidth {:.3g} m{}): centre, sizes, and each "
            "system's mean accuracy at the test points whose nearest training target is in the cluster.",
            evaluation.mean_shift_bandwidth, evaluation.mean_shift_estimated ? ", estimated" : ""),
        shown, numbering);
}

Section comparisonsSection(const Evaluation& evaluation, Numbering& numbering) {
    if (evaluation.comparisons.empty()) return {};
    return {"Systems compared",
            tableHtml(comparisonsTable(evaluation),
                      "Differences of accuracy, the first system\u2019s minus the second\u2019s, over the "
                      "targets at which both have "
                      "one. Typical: Hodges and Lehmann\u2019s estimate with its interval of 95\u00a0%. r: "
                      "rank-biserial "
                      "correlation, 1 if the first is better at every target. p: Wilcoxon\u2019s "
                      "signed-rank test, two-sided; "
                      "Holm: adjusted over all pairs of the table.",
                      {"pair", "targets", "mean_difference", "sd", "mean_difference_deg", "typical",
                       "rank_biserial", "p", "p_holm"},
                      numbering, dense_table)};
}

}  // namespace deixis::results
