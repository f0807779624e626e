// The tables of the evaluation's page.
#include "evaluation_page_tables.hpp"

#include <fmt/format.h>
#include <limits>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "results/page/report_tables.hpp"
#include "results/statistics/descriptive.hpp"
#include "results/statistics/holm.hpp"

namespace deixis::results {

namespace {

std::string cell(bool known, double value, int decimals) {
    return "<td>" + (known ? fixedText(value, decimals) : dash) + "</td>";
}

std::string nameCell(const SystemEvaluation& system) {
    return fmt::format("<th scope=\"row\">{}{}</th>", escapeHtml(system.system),
                       system.synthetic ? "&#160;*" : "");
}

constexpr std::array profile_times_s{-1.0, -0.5, 0.0, 0.5, 1.0};

/// A row for each system and hand: mean and standard deviation at the times above.
std::string profileTable(const Evaluation& evaluation, bool reward, Numbering& tables) {
    std::string columns = "<th>System</th><th class=\"text\">hand</th><th>clips</th>";
    for (const double time : profile_times_s) columns += "<th>" + fixedText(time, 1) + " s</th>";
    std::string out =
        openTable(units::clips,
                  reward ? "Reward around the time of pointing, mean &#177; standard deviation over clips."
                         : "Speed of the pointing hand (m/s) around the time of pointing, mean &#177; "
                           "standard deviation over clips.",
                  columns, tables);
    for (const SystemEvaluation& system : evaluation.systems)
        for (const auto& [hand, profile] :
             {std::pair{"right", &system.right}, std::pair{"left", &system.left}}) {
            if (profile->clips == 0) continue;
            out += "<tr>" + nameCell(system) +
                   fmt::format("<td class=\"text\">{}</td><td>{}</td>", hand, profile->clips);
            for (const double time : profile_times_s) {
                const auto& points = profile->points;
                const auto at = std::find_if(points.begin(), points.end(), [&](const ProfilePoint& point) {
                    return std::abs(point.time_s - time) < 0.5 * profile_step_s;
                });
                if (at == points.end()) {
                    out += fmt::format("<td>{}</td>", dash);
                    continue;
                }
                const int decimals = reward ? 3 : 2;
                out += "<td>" + fixedText(reward ? at->reward_mean : at->speed_mean, decimals) +
                       (at->n > 1 ? " &#177; " + fixedText(reward ? at->reward_sd : at->speed_sd, decimals)
                                  : std::string()) +
                       "</td>";
            }
            out += "</tr>";
        }
    return out + close_table;
}

}  // namespace

std::string systemsHtml(const Evaluation& evaluation, Numbering& tables) {
    std::string out = openTable(
        units::clips,
        "Accuracy (Equation 2, dimensionless) and the same as angle between forearm and target (degrees), "
        "over clips; SD with n &#8722; 1.",
        "<th>System</th><th>n</th><th>Mean</th><th>SD</th><th>Median</th><th>Mean (&#176;)</th><th>SD "
        "(&#176;)</th><th>Median (&#176;)</th><th>missing</th><th>left hand</th>",
        tables);
    for (const auto& system : evaluation.systems) {
        out += "<tr>" + nameCell(system) + fmt::format("<td>{}</td>", system.rewards.size());
        for (const auto& [values, decimals] :
             {std::pair{&system.rewards, 3}, std::pair{&system.errors_deg, 1}}) {
            out += cell(!values->empty(), mean(*values), decimals);
            out += cell(values->size() > 1, sampleSd(*values), decimals);
            out += cell(!values->empty(), quantile(*values, 0.5), decimals);
        }
        out += fmt::format("<td>{}</td><td>{}</td></tr>", system.missing, system.left_hand);
    }
    return out + close_table;
}

std::string accuracyBoxesHtml(const Evaluation& evaluation, Numbering& tables) {
    std::string out = openTable(
        units::clips,
        "What the box plots draw: quantiles of the accuracy of a system&#8217;s clips; no notch where "
        "it would reach beyond its box.",
        std::string("<th>System</th>") + box_columns, tables);
    for (const auto& system : evaluation.systems)
        if (const auto box = boxSummary(system.rewards))
            out += "<tr>" + nameCell(system) +
                   boxCells(*box, [](double value) { return fixedText(value, 3); }) + "</tr>";
    return out + close_table;
}

std::string profilesHtml(const Evaluation& evaluation, Numbering& tables) {
    const std::string rewards = profileTable(evaluation, true, tables);
    return rewards + profileTable(evaluation, false, tables);
}

namespace {

/// Of the systems, in their order; NaN without a correlation.
std::vector<double> holmOfCorrelations(const Evaluation& evaluation) {
    std::vector<double> p;
    for (const auto& system : evaluation.systems)
        p.push_back(system.correlation.method == "undefined" ? std::numeric_limits<double>::quiet_NaN()
                                                             : system.correlation.p);
    return holm(p);
}

}  // namespace

std::string correlationTable(const Evaluation& evaluation, Numbering& tables) {
    std::string out = openTable(
        units::clips,
        "Spearman's correlation of accuracy with the density of the training targets at the clip's target, "
        "two-sided (the paper's Table&#160;2).",
        "<th>System</th><th>n</th><th>&#961;</th><th>p</th><th>p (Holm)</th><th class=\"text\">p by</th>",
        tables);
    const std::vector<double> adjusted = holmOfCorrelations(evaluation);
    std::size_t place = 0;
    for (const auto& system : evaluation.systems) {
        const SpearmanTest& test = system.correlation;
        const bool known = test.method != "undefined";
        out += "<tr>" + nameCell(system) + fmt::format("<td>{}</td>", test.n) + cell(known, test.rho, 3) +
               fmt::format("<td>{}</td><td>{}</td><td class=\"text\">{}</td></tr>",
                           known ? pText(test.p) : dash, known ? pText(adjusted[place]) : dash,
                           !known                   ? "undefined"
                           : test.method == "exact" ? "all pairings"
                                                    : "Student&#8217;s t");
        ++place;
    }
    return out + close_table;
}

std::string clustersHtml(const Evaluation& evaluation, Numbering& tables) {
    std::string head =
        "<th>Cluster</th><th>x (m)</th><th>y (m)</th><th>z (m)</th><th>training targets</th><th>test "
        "points</th>";
    for (const auto& system : evaluation.systems) head += "<th>" + escapeHtml(system.system) + "</th>";
    std::string out = openTable(
        units::clips,
        fmt::format("Clusters of the training targets (MeanShift, bandwidth {:.3g} m{}): centre, sizes, and "
                    "the mean accuracy of each system at the test points whose nearest training target "
                    "belongs to the cluster.",
                    evaluation.mean_shift_bandwidth, evaluation.mean_shift_estimated ? ", estimated" : ""),
        head, tables);
    for (std::size_t c = 0; c < evaluation.clusters.size(); ++c) {
        const TargetCluster& cluster = evaluation.clusters[c];
        out += fmt::format("<tr><th scope=\"row\">{}</th>", c + 1);
        for (int axis = 0; axis < 3; ++axis) out += cell(true, cluster.centre[axis], 2);
        out += fmt::format("<td>{}</td><td>{}</td>", cluster.training_targets, cluster.test_points);
        for (const auto& system : evaluation.systems)
            out += cell(system.cluster_means[c].has_value(), system.cluster_means[c].value_or(0.0), 3);
        out += "</tr>";
    }
    return out + close_table;
}

std::string comparisonsHtml(const Evaluation& evaluation, Numbering& tables) {
    if (evaluation.comparisons.empty()) return "";
    std::string out =
        "\n<h2>Systems compared</h2>" +
        openTable(
            units::targets,
            "Differences of accuracy, the first system&#8217;s minus the second&#8217;s, over the targets at "
            "which both have one. Typical: Hodges and Lehmann&#8217;s estimate with its interval of "
            "95&#160;%. r: rank-biserial correlation, 1 where the first is better at every target. p: "
            "Wilcoxon&#8217;s signed-rank test, two-sided; Holm: adjusted over all pairs of the table.",
            "<th>Systems</th><th>targets</th><th>Mean</th><th>SD</th><th>Mean (&#176;)</th><th>Typical "
            "[interval]</th><th>r</th><th>p</th><th>p (Holm)</th>",
            tables, TableWidth::dense);
    for (const SystemComparison& pair : evaluation.comparisons) {
        const SignedRankTest& test = pair.test;
        const bool any = test.n_pairs > 0;
        const auto optional = [](const std::optional<double>& value, int decimals) {
            return cell(value.has_value(), value.value_or(0.0), decimals);
        };
        const auto& shift = test.hodges_lehmann;
        const std::string typical =
            fmt::format("<td>{}</td>", shiftText(shift, [](double value) { return fixedText(value, 3); }));
        const auto name = [&](std::size_t system) { return escapeHtml(evaluation.systems[system].system); };
        out += fmt::format("<tr><th scope=\"row\">{} &#8211; {}</th><td>{}</td>", name(pair.a), name(pair.b),
                           test.n_pairs) +
               cell(any, pair.mean_difference, 3) + cell(test.n_pairs > 1, pair.sd, 3) +
               cell(any, pair.mean_difference_deg, 1) + typical + optional(test.rank_biserial, 2) +
               fmt::format("<td>{}</td><td>{}</td></tr>", any ? pText(test.p_two_sided) : dash,
                           pair.p_holm ? pText(*pair.p_holm) : dash);
    }
    return out + close_table;
}

}  // namespace deixis::results
