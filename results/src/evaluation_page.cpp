// The evaluation's page: what stands where.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "evaluation_figures.hpp"
#include "report_text.hpp"
#include "results/descriptive.hpp"
#include "results/evaluation.hpp"

namespace deixis::results {

namespace {

const char* const dash = "&#8211;";

const char* const evaluation_css = R"css(
:root { --c0: #0072b2; --c1: #c25b00; }
@media screen and (prefers-color-scheme: dark) { :root { --c0: #62b5ec; --c1: #f39c4a; } }
caption span { display: inline-block; position: sticky; left: 0; max-width: min(48rem, calc(100vw - 3rem)); }
.small { break-after: avoid; }
.one { max-width: 36rem; margin: 1rem 0; }
.plots { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 21rem), 1fr));
  gap: 1.6rem 1.4rem; margin: 1rem 0; }
.plots figure { max-width: 30rem; }
figure { margin: 0; break-inside: avoid; }
figcaption { margin: 0 0 .3rem; overflow-wrap: anywhere; }
figcaption b { color: var(--ink); font-size: 1rem; }
svg { width: 100%; height: auto; display: block; }
svg text { font: 13px "Source Sans 3", "Noto Sans", "DejaVu Sans", Helvetica, Arial, sans-serif; fill: currentColor; }
svg .strong { font-weight: 600; }
svg .halo { paint-order: stroke; stroke: var(--paper); stroke-width: 4px; stroke-linejoin: round; }
svg .grid { stroke: var(--thin); }
svg .axis { stroke: var(--soft); }
svg .limit { stroke: var(--soft); stroke-dasharray: 5 4; }
svg .c0 { color: var(--c0); } svg .c1 { color: var(--c1); }
svg .box { stroke: currentColor; stroke-width: 1.5; fill: none; }
svg .area { fill: currentColor; fill-opacity: .18; }
svg .dot { fill: currentColor; fill-opacity: .45; }
svg .dots circle { fill: currentColor; fill-opacity: .35; }
svg .median { stroke: var(--ink); stroke-width: 2.5; }
svg .diamond { fill: var(--paper); stroke: var(--ink); stroke-width: 1.5; }
svg .band { fill: currentColor; fill-opacity: .16; }
svg .curve { fill: none; stroke: currentColor; stroke-width: 2; }
svg .dashed { stroke-dasharray: 6 3; }
svg .nothing { fill: var(--shade); stroke: var(--rule); }
svg .ring { fill: none; stroke: #ffffff; stroke-width: 1.2; }
svg .balls circle { stroke: var(--paper); stroke-width: .4; }
@media print {
  .plots { display: grid; grid-template-columns: 1fr 1fr; }
  .plots figure, .one { max-width: none; }
  .one { width: 70%; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)css";

std::string fixed(double value, int decimals) {
    const std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
    const bool zero = digits.find_first_not_of("0.") == std::string::npos;
    return (value < 0.0 && !zero ? "&#8722;" : "") + digits;
}

std::string cell(bool known, double value, int decimals) {
    return "<td>" + (known ? fixed(value, decimals) : dash) + "</td>";
}

std::string nameCell(const SystemEvaluation& system) {
    return fmt::format("<th scope=\"row\">{}{}</th>", escapeHtml(system.system),
                       system.synthetic ? "&#160;*" : "");
}

/// `style`: "dense" for many columns.
std::string tableStart(int number, const std::string& caption, const std::string& head,
                       const char* style = "plain") {
    return fmt::format(
        "\n<div class=\"scroll\" tabindex=\"0\"><table class=\"{}\"><caption><span><b>Table {}.</b> "
        "{}</span></caption>"
        "<thead><tr>{}</tr></thead><tbody>",
        style, number, caption, head);
}
const char* const table_end = "</tbody></table></div>";

bool anySynthetic(const Evaluation& evaluation) {
    return std::any_of(evaluation.systems.begin(), evaluation.systems.end(),
                       [](const auto& system) { return system.synthetic; });
}

std::string syntheticNote(const Evaluation& evaluation) {
    std::string systems;
    for (const auto& system : evaluation.systems)
        if (system.synthetic) systems += (systems.empty() ? "" : ", ") + escapeHtml(system.system);
    const bool training = evaluation.input.training_synthetic;
    if (systems.empty() && !training) return "";
    std::string out = "\n<p class=\"synthetic\"><b>Synthetic:</b> ";
    if (!systems.empty())
        out += fmt::format(
            "{} {} built into this program, made by formulas and not learned from people (marked * below). ",
            systems, systems.find(", ") == std::string::npos ? "is a system" : "are systems");
    if (training)
        out +=
            "The training targets are those of this program's synthetic demonstrations; no learned system "
            "was trained on them.";
    return out + "</p>";
}

std::string findings(const Evaluation& evaluation) {
    std::vector<const SystemEvaluation*> measured;
    for (const auto& system : evaluation.systems)
        if (!system.rewards.empty()) measured.push_back(&system);
    if (measured.empty()) return "";
    std::stable_sort(measured.begin(), measured.end(),
                     [](const auto* a, const auto* b) { return mean(a->rewards) > mean(b->rewards); });
    const auto named = [](const SystemEvaluation* system) {
        return fmt::format("<b>{}</b> ({:.3f}; mean error {:.1f}&#176;)", escapeHtml(system->system),
                           mean(system->rewards), mean(system->errors_deg));
    };
    std::string out = "\n<ul class=\"findings\"><li>";
    out += measured.size() == 1 ? "Mean accuracy of " + named(measured.front()) + "."
                                : named(measured.front()) + " has the highest mean accuracy, " +
                                      named(measured.back()) + " the lowest.";
    out += fmt::format(" The ceiling of Equation&#160;2 is {:.3f}.</li>", reward_ceiling);
    const SystemEvaluation* strongest = nullptr;
    for (const auto& system : evaluation.systems)
        if (system.correlation.method != "undefined" &&
            (!strongest || std::abs(system.correlation.rho) > std::abs(strongest->correlation.rho)))
            strongest = &system;
    if (strongest)
        out += fmt::format(
            "<li>The correlation of accuracy with the density of the training targets is {} <b>{}</b>: "
            "Spearman's "
            "&#961; = {}, p {}{}.</li>",
            evaluation.systems.size() == 1 ? "for" : "strongest for", escapeHtml(strongest->system),
            fixed(strongest->correlation.rho, 3), strongest->correlation.p < 0.001 ? "" : "= ",
            pText(strongest->correlation.p));
    return out + "</ul>";
}

std::string systemsHtml(const Evaluation& evaluation) {
    std::string out = tableStart(
        1,
        "Accuracy (Equation 2, dimensionless) and the same as angle between forearm and target (degrees), "
        "over "
        "clips; SD with n &#8722; 1.",
        "<th>System</th><th>n</th><th>Mean</th><th>SD</th><th>Median</th><th>Mean (&#176;)</th><th>SD "
        "(&#176;)</th><th>Median (&#176;)</th><th>missing</th><th>left hand</th>");
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
    return out + table_end;
}

std::string correlationTable(const Evaluation& evaluation) {
    std::string out = tableStart(
        2,
        "Spearman's correlation of accuracy with the density of the training targets at the clip's target, "
        "two-sided (the paper's Table&#160;2).",
        "<th>System</th><th>n</th><th>&#961;</th><th>p</th><th class=\"text\">p by</th>");
    for (const auto& system : evaluation.systems) {
        const SpearmanTest& test = system.correlation;
        const bool known = test.method != "undefined";
        out += "<tr>" + nameCell(system) + fmt::format("<td>{}</td>", test.n) + cell(known, test.rho, 3) +
               fmt::format("<td>{}</td><td class=\"text\">{}</td></tr>", known ? pText(test.p) : dash,
                           !known                   ? "undefined"
                           : test.method == "exact" ? "all pairings"
                                                    : "Student&#8217;s t");
    }
    return out + table_end;
}

std::string clustersHtml(const Evaluation& evaluation) {
    std::string head =
        "<th>Cluster</th><th>x (m)</th><th>y (m)</th><th>z (m)</th><th>training targets</th><th>test "
        "points</th>";
    for (const auto& system : evaluation.systems) head += "<th>" + escapeHtml(system.system) + "</th>";
    std::string out = tableStart(
        3,
        fmt::format(
            "Clusters of the training targets (MeanShift, bandwidth {:.3g} m{}): centre, sizes, and the "
            "mean accuracy of each system at the test points whose nearest training target belongs to "
            "the cluster.",
            evaluation.mean_shift_bandwidth, evaluation.mean_shift_estimated ? ", estimated" : ""),
        head);
    for (std::size_t c = 0; c < evaluation.clusters.size(); ++c) {
        const TargetCluster& cluster = evaluation.clusters[c];
        out += fmt::format("<tr><th scope=\"row\">{}</th>", c + 1);
        for (int axis = 0; axis < 3; ++axis) out += cell(true, cluster.centre[axis], 2);
        out += fmt::format("<td>{}</td><td>{}</td>", cluster.training_targets, cluster.test_points);
        for (const auto& system : evaluation.systems)
            out += cell(system.cluster_means[c].has_value(), system.cluster_means[c].value_or(0.0), 3);
        out += "</tr>";
    }
    return out + table_end;
}

std::string comparisonsHtml(const Evaluation& evaluation) {
    if (evaluation.comparisons.empty()) return "";
    std::string out =
        "\n<h2>Systems compared</h2>" +
        tableStart(
            4,
            "Differences of accuracy, the first system&#8217;s minus the second&#8217;s, over the targets at "
            "which both have one. Typical: Hodges and Lehmann&#8217;s estimate with its interval of "
            "95&#160;%. r: "
            "rank-biserial correlation, 1 where the first is better at every target. p: Wilcoxon&#8217;s "
            "signed-rank test, two-sided; Holm: adjusted over all pairs of the table.",
            "<th>Systems</th><th>targets</th><th>Mean</th><th>SD</th><th>Mean "
            "(&#176;)</th><th>Typical [interval]</th><th>r</th><th>p</th><th>p (Holm)</th>",
            "dense");
    for (const SystemComparison& pair : evaluation.comparisons) {
        const SignedRankTest& test = pair.test;
        const bool any = test.n_pairs > 0;
        const auto optional = [](const std::optional<double>& value, int decimals) {
            return cell(value.has_value(), value.value_or(0.0), decimals);
        };
        const auto& shift = test.hodges_lehmann;
        const std::string typical = shift.estimate && shift.lower && shift.upper
                                        ? fmt::format("<td>{} [{}, {}]</td>", fixed(*shift.estimate, 3),
                                                      fixed(*shift.lower, 3), fixed(*shift.upper, 3))
                                        : fmt::format("<td>{}</td>", dash);
        const auto name = [&](std::size_t system) { return escapeHtml(evaluation.systems[system].system); };
        out += fmt::format("<tr><th scope=\"row\">{} &#8211; {}</th><td>{}</td>", name(pair.a), name(pair.b),
                           test.n_pairs) +
               cell(any, pair.mean_difference, 3) + cell(test.n_pairs > 1, pair.sd, 3) +
               cell(any, pair.mean_difference_deg, 1) + typical + optional(test.rank_biserial, 2) +
               fmt::format("<td>{}</td><td>{}</td></tr>", any ? pText(test.p_two_sided) : dash,
                           pair.p_holm ? pText(*pair.p_holm) : dash);
    }
    return out + table_end;
}

std::string figure(const std::string& caption, const std::string& svg, const char* style_class = "") {
    return fmt::format("\n<figure{}><figcaption>{}</figcaption>{}</figure>",
                       *style_class ? fmt::format(" class=\"{}\"", style_class) : "", caption, svg);
}

std::string bandwidthWords(const Evaluation& evaluation) {
    std::string values;
    for (const double h : evaluation.bandwidths)
        values += fmt::format("{}{:.3f}", values.empty() ? "" : ", ", h);
    const std::string rule =
        evaluation.bandwidth_rule == "given" ? "given"
        : evaluation.bandwidth_rule == "normal-reference"
            ? "Scott&#8217;s rule as statsmodels&#8217; KDEMultivariate has it, "
              "1.06&#160;&#963;&#160;n<sup>&#8722;1/7</sup>"
        : evaluation.bandwidth_rule == "scott"
            ? "Scott&#8217;s rule, &#963;&#160;n<sup>&#8722;1/7</sup>"
            : "Scott&#8217;s rule on the whole covariance, as SciPy&#8217;s gaussian_kde";
    return fmt::format("[{}] m ({})", values, rule);
}

std::string figures(const Evaluation& evaluation) {
    std::string out = "\n<h2>Accuracy by system</h2>";
    out += figure(
        "<b>Figure 1.</b> Accuracy of every clip (the paper&#8217;s Figure&#160;9). Box: quartiles; line: "
        "median; "
        "diamond: mean; whiskers: 5th and 95th percentile; points: beyond. Dashed: the ceiling.",
        accuracyBoxesSvg(evaluation), "one");
    out += systemsHtml(evaluation);
    out +=
        "\n<h2>Around the time of pointing</h2>\n<p class=\"small\"><b>Figure 2.</b> Reward and speed of the "
        "pointing hand, mean and one standard deviation over clips (the paper&#8217;s Figures 2 and 3). 0 is "
        "the time of pointing; steps that fewer than half of the clips have are left out. Dashed across: the "
        "ceiling of the reward, and the speed below which a frame counts.</p>\n<div class=\"plots\">";
    for (std::size_t i = 0; i < evaluation.systems.size(); ++i) {
        const std::string name = escapeHtml(evaluation.systems[i].system);
        out += figure("<b>" + name + "</b> &#183; reward", profileSvg(evaluation, i, ProfileKind::accuracy));
        out += figure("<b>" + name + "</b> &#183; hand speed", profileSvg(evaluation, i, ProfileKind::speed));
    }
    out += "</div>\n<h2>Accuracy and training targets</h2>";
    out += correlationTable(evaluation);
    out += figure(
        fmt::format("<b>Figure 3.</b> Density of {} training targets at {} test points (the paper&#8217;s "
                    "Figure&#160;8). Kernel bandwidths x, y, z: {}.",
                    evaluation.input.training.size(), evaluation.points.size(), bandwidthWords(evaluation)),
        densityGridSvg(evaluation), "one");
    out +=
        "\n<p class=\"small\"><b>Figure 4.</b> Accuracy against density, a point a clip (the paper&#8217;s "
        "Figure&#160;10&#160;A).</p>\n<div class=\"plots\">";
    for (std::size_t i = 0; i < evaluation.systems.size(); ++i) {
        const SpearmanTest& test = evaluation.systems[i].correlation;
        const std::string words = test.method == "undefined"
                                      ? "no correlation"
                                      : fmt::format("&#961; = {}, p {}{}", fixed(test.rho, 3),
                                                    test.p < 0.001 ? "" : "= ", pText(test.p));
        out += figure("<b>" + escapeHtml(evaluation.systems[i].system) + "</b> &#183; " + words,
                      densityScatterSvg(evaluation, i));
    }
    out +=
        "</div>\n<p class=\"small\"><b>Figure 5.</b> Seen from above, means over y: density with the "
        "training "
        "targets as rings, and accuracy (the paper&#8217;s Figure&#160;10 B and C). The agent stands at x = "
        "0, "
        "z = 0 and looks up the page. All maps of accuracy have one scale.</p>\n<div class=\"plots\">";
    out += figure("<b>Density of the training targets</b>", densityMapSvg(evaluation));
    for (std::size_t i = 0; i < evaluation.systems.size(); ++i)
        out += figure("<b>" + escapeHtml(evaluation.systems[i].system) + "</b> &#183; accuracy",
                      accuracyMapSvg(evaluation, i));
    return out + "</div>" + clustersHtml(evaluation) + comparisonsHtml(evaluation);
}

std::string methods(const Evaluation& evaluation) {
    const EvaluationInput& input = evaluation.input;
    return fmt::format(
        "\n<h2>Methods</h2>\n<p>After section 3.2 of Deichler, Wang, Alexanderson and Beskow (2023).</p>\n"
        "<p><b>Accuracy</b> of a clip is the greatest reward, Equation&#160;2: &#952; = 1 &#8722; angle(hand "
        "to "
        "target, elbow to hand)/&#960;, reward = (e<sup>&#952;</sup> &#8722; 1)/e, among the frames within "
        "{:g} s "
        "of the time of pointing to either side (a window of {:g} s) in which the hand moves slower than "
        "{:g} m/s. "
        "The time of pointing is the frame in which the pointing posture is reached, the manifest&#8217;s "
        "<i>peak</i>. Speed is that of the hand joint by central differences. A clip whose hand is never so "
        "slow "
        "there has no accuracy: it is counted as missing, and nothing is filled in. Clips are measured on "
        "their own skeletons. Only the forearm counts, as in the paper: an agent that brings eye, fingertip "
        "and "
        "target into line, as people do, scores lower than one whose forearm points.</p>\n"
        "<p><b>Density</b> is a Gaussian kernel estimate over the {} training targets, bandwidths {}. "
        "<b>Correlation</b> is Spearman&#8217;s, with mean ranks for ties; p is exact over all pairings up "
        "to nine "
        "clips, beyond that by Student&#8217;s t.</p>\n"
        "<p><b>Clusters</b> are those of MeanShift with a flat kernel, by scikit-learn&#8217;s conventions. "
        "A test "
        "point belongs to the cluster of its nearest training target, as in section 2.2.2 of the paper.</p>\n"
        "<p><b>Systems are compared</b> target by target (several clips of one system for one target count "
        "by their mean). The signed-rank test is exact up to 2,000 targets, ties among differences included; "
        "differences are rounded to 10<sup>&#8722;9</sup>, and those of zero left out of the ranking. "
        "Targets "
        "are a sample of places, not of people: p says how far the order of two systems hangs on the "
        "places.</p>",
        0.5 * input.rule.window_s, input.rule.window_s, input.rule.slower_than_m_s, input.training.size(),
        bandwidthWords(evaluation));
}

std::string provenance(const Evaluation& evaluation) {
    const EvaluationInput& input = evaluation.input;
    std::string out = "\n<h2>Where the numbers come from</h2><dl>";
    const auto entry = [&](const std::string& name, const std::string& html) {
        out += fmt::format("<dt>{}</dt><dd>{}</dd>", name, html);
    };
    entry("Program", escapeHtml(input.program));
    entry("Training targets", escapeHtml(input.training_source));
    for (const InputFile& file : input.files)
        entry("File", escapeHtml(file.path) + "<br/>SHA-256 " + escapeHtml(file.sha256));
    entry("Motion", fmt::format("{} clips; SHA-256 over the positions of elbow and hand {}",
                                input.clips.size(), escapeHtml(input.motion_digest)));
    entry("Bandwidths", bandwidthWords(evaluation));
    entry("MeanShift",
          fmt::format(
              "bandwidth {:.6g} m ({})", evaluation.mean_shift_bandwidth,
              evaluation.mean_shift_estimated ? "mean distance to the neighbour at quantile 0.3" : "given"));
    return out + "</dl>";
}

}  // namespace

std::string renderEvaluation(const Evaluation& evaluation) {
    std::string out = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n<meta "
        "charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
        "<title>Objective evaluation of pointing</title>\n<style>{}{}</style>\n</head>\n<body>\n"
        "<h1>Objective evaluation of pointing</h1>\n<p class=\"lead\">{} system{} &#183; {} clips &#183; {} "
        "test "
        "points &#183; {} training targets ({})</p>",
        report_css, evaluation_css, evaluation.systems.size(), evaluation.systems.size() == 1 ? "" : "s",
        evaluation.input.clips.size(), evaluation.points.size(), evaluation.input.training.size(),
        escapeHtml(evaluation.input.training_source));
    out += syntheticNote(evaluation);
    out += findings(evaluation);
    if (!evaluation.remarks.empty()) {
        out += "\n<h2>Remarks</h2><ul class=\"findings\">";
        for (const auto& remark : evaluation.remarks) out += "<li>" + escapeHtml(remark) + "</li>";
        out += "</ul>";
    }
    out += figures(evaluation);
    if (anySynthetic(evaluation))
        out +=
            "\n<p class=\"small\">* Built into this program and synthetic: a stand-in until learned systems "
            "come.</p>";
    return out + methods(evaluation) + provenance(evaluation) + "\n</body>\n</html>\n";
}

}  // namespace deixis::results
