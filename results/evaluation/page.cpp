// The evaluation's page: what stands where.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "figures.hpp"
#include "page_tables.hpp"
#include "rays.hpp"
#include "results/evaluation/evaluation.hpp"
#include "results/outputs/observers_html.hpp"
#include "results/page/figure.hpp"
#include "results/page/page.hpp"
#include "results/statistics/descriptive.hpp"

namespace deixis::results {

std::string bandwidthWords(const Evaluation& evaluation) {
    std::string values;
    for (const double h : evaluation.bandwidths)
        values += fmt::format("{}{:.3f}", values.empty() ? "" : ", ", h);
    const std::string rule =
        evaluation.bandwidth_rule == "given" ? "given"
        : evaluation.bandwidth_rule == "normal-reference"
            ? "Scott&#8217;s rule as in statsmodels&#8217; KDEMultivariate, "
              "1.06&#160;&#963;&#160;n<sup>&#8722;1/7</sup>"
        : evaluation.bandwidth_rule == "scott"
            ? "Scott&#8217;s rule, &#963;&#160;n<sup>&#8722;1/7</sup>"
            : "Scott&#8217;s rule on the whole covariance, as in SciPy&#8217;s gaussian_kde";
    return fmt::format("[{}] m ({})", values, rule);
}

namespace {

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
            "{} {} made by formulas, or learned from demonstrations that were, not from people (marked * "
            "below). ",
            systems, systems.find(", ") == std::string::npos ? "is" : "are");
    if (training) out += "The training targets are those of this program's synthetic demonstrations.";
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
    std::string means = measured.size() == 1 ? "Mean accuracy of " + named(measured.front()) + "."
                                             : named(measured.front()) + " has the highest mean accuracy, " +
                                                   named(measured.back()) + " the lowest.";
    means += fmt::format(" That is the forearm's, Equation&#160;2, whose ceiling is {:.3f}.",
                         motion::highest_pointing_reward);
    // None is picked out: the strongest of several is no finding.
    std::string correlations;
    for (const auto& system : evaluation.systems)
        if (system.correlation.method != "undefined")
            correlations += fmt::format("{}<b>{}</b> {}", correlations.empty() ? "" : ", ",
                                        escapeHtml(system.system), fixedText(system.correlation.rho, 3));
    if (!correlations.empty())
        correlations =
            "Spearman's correlation of accuracy with the density of the training targets: " + correlations +
            "; the table has p and p after Holm's correction.";
    return "\n" +
           itemsHtml({observersFinding(evaluation.observers), means, raysFinding(evaluation), correlations});
}

std::string systemsSection(const Evaluation& evaluation, Numbering& figures, Numbering& tables) {
    std::string drawn = figureHtml(accuracyBoxes(evaluation, figures));
    const bool compared = std::any_of(evaluation.comparisons.begin(), evaluation.comparisons.end(),
                                      [](const auto& pair) { return !pair.differences.empty(); });
    if (compared) drawn += figureHtml(accuracyDifferences(evaluation, figures));
    std::string out = "\n<h2>Accuracy by system</h2>" + figuresPlaced(drawn);
    out += systemsHtml(evaluation, tables);
    out += raysHtml(evaluation, tables);
    out += accuracyBoxesHtml(evaluation, tables);
    return out + comparisonsHtml(evaluation, tables);
}

std::string observersSection(const Evaluation& evaluation, Numbering& tables) {
    if (!evaluation.input.study) return "";
    return fmt::format(
               "\n<h2>Read by observers</h2>\n<p class=\"small intro\">The games of the study {}: each clip "
               "with the balls of its target, seen from each layout&#8217;s place in a headset. {}</p>",
               escapeHtml(evaluation.input.study->name), nearestText(*evaluation.nearest)) +
           observersTable(evaluation.observers, "clips and places", tables);
}

std::string profilesSection(const Evaluation& evaluation, Numbering& figures, Numbering& tables) {
    std::string drawn;
    for (std::size_t i = 0; i < evaluation.systems.size(); ++i)
        for (const ProfileKind kind : {ProfileKind::reward, ProfileKind::speed})
            drawn += figureHtml(profileFigure(evaluation, i, kind, figures));
    return "\n<h2>Around the time of pointing</h2>\n<p class=\"small intro\">Reward and speed of the "
           "pointing hand, mean and band of one standard deviation over the clips of each hand (their number "
           "in brackets; the paper&#8217;s Figures 2 and 3). 0 is the time of pointing; steps that fewer "
           "than half of the clips have are left out. Dashed lines: the ceiling of the reward, and the "
           "speed below which a frame counts.</p>" +
           figuresPlaced(drawn) + profilesHtml(evaluation, tables);
}

std::string trainingSection(const Evaluation& evaluation, Numbering& figures, Numbering& tables) {
    std::string out =
        "\n<h2>Accuracy and training targets</h2>\n<p class=\"small intro\">In the maps a cell is a mean "
        "over y (from above) or over z (from behind); the agent stands at x = 0, z = 0, and its left is on "
        "the left.</p>";
    out += figuresPlaced(figureHtml(densitySpace(evaluation, figures)), FigurePlace::single);
    out += figuresPlaced(figureHtml(densityMap(evaluation, figures)));
    out += correlationTable(evaluation, tables);
    out +=
        "\n<p class=\"small intro\">Accuracy against density, one point per clip (the paper&#8217;s "
        "Figure&#160;10&#160;A). Diamonds, with at least fifty clips: medians of tenths of the clips, by "
        "density.</p>";
    std::string drawn;
    for (std::size_t i = 0; i < evaluation.systems.size(); ++i)
        drawn += figureHtml(densityScatter(evaluation, i, figures));
    out += figuresPlaced(drawn);
    out += figuresPlaced(figureHtml(accuracyMaps(evaluation, figures)));
    return out + clustersHtml(evaluation, tables);
}

std::string methods(const Evaluation& evaluation) {
    const EvaluationInput& input = evaluation.input;
    return fmt::format(
        "\n<h2>Methods</h2>\n<p>The methods follow section 3.2 of Deichler, Wang, Alexanderson and Beskow "
        "(2023).</p>\n<p><b>Accuracy</b> of a clip is the highest reward, Equation&#160;2: &#952; = 1 "
        "&#8722; angle(hand to target, elbow to hand)/&#960;, reward = (e<sup>&#952;</sup> &#8722; 1)/e, "
        "among the frames within {:g} s of the time of pointing on either side (a window of {:g} s) in which "
        "the hand moves slower than {:g} m/s. The time of pointing is the frame in which the pointing "
        "posture is reached, the manifest&#8217;s <i>peak</i>. Speed is that of the hand joint by central "
        "differences. A clip whose hand is never that slow there has no accuracy: it is counted as missing, "
        "and nothing is imputed. Clips are measured on their own skeletons. Only the forearm counts, as in "
        "the paper: an agent that aligns eye, fingertip and target, as people do, scores lower than one "
        "whose forearm points.</p>\n<p><b>Density</b> is a Gaussian kernel estimate over the "
        "{} "
        "training targets, bandwidths {}. <b>Correlation</b> is Spearman&#8217;s, with mean ranks for ties; "
        "p is exact over all pairings up to nine clips, beyond that by Student&#8217;s "
        "t.</p>\n<p><b>Clusters</b> are those of MeanShift with a flat kernel, with scikit-learn&#8217;s "
        "conventions. A test point belongs to the cluster of its nearest training target, as in section "
        "2.2.2 of the paper.</p>\n<p><b>Systems are compared</b> target by target (several clips of one "
        "system for one target count by their mean). The signed-rank test is exact up to 2,000 targets, ties "
        "among differences included; differences are rounded to 10<sup>&#8722;9</sup>, and zeros are left "
        "out of the ranking. Targets are a sample of places, not of people: p says how far the order of two "
        "systems depends on the places.</p>",
        0.5 * input.rule.window_s, input.rule.window_s, input.rule.slower_than_m_s, input.training.size(),
        bandwidthWords(evaluation));
}

std::string provenance(const Evaluation& evaluation) {
    const EvaluationInput& input = evaluation.input;
    std::vector<Fact> facts;
    const auto entry = [&](const std::string& name, const std::string& html) {
        facts.push_back({name, html});
    };
    entry("Program", escapeHtml(input.program));
    for (const auto& [name, value] : input.build) entry(propertyLabel(name), escapeHtml(value));
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
    return "\n<h2>Where the numbers come from</h2>" + factsHtml(facts);
}

}  // namespace

std::string renderEvaluation(const Evaluation& evaluation) {
    std::string out = pageStart("Objective evaluation of pointing", "Objective evaluation of pointing") +
                      fmt::format(
                          "<p class=\"lead\">{} system{} &#183; {} clips &#183; {} test points &#183; {} "
                          "training targets ({})</p>",
                          evaluation.systems.size(), evaluation.systems.size() == 1 ? "" : "s",
                          evaluation.input.clips.size(), evaluation.points.size(),
                          evaluation.input.training.size(), escapeHtml(evaluation.input.training_source));
    const std::string lead = out + syntheticNote(evaluation) + findings(evaluation);
    out = remarksHtml(evaluation.remarks);
    Numbering figures("Figure");
    Numbering tables;
    out += observersSection(evaluation, tables);
    out += systemsSection(evaluation, figures, tables);
    out += profilesSection(evaluation, figures, tables);
    out += trainingSection(evaluation, figures, tables);
    if (anySynthetic(evaluation))
        out +=
            "\n<p class=\"small\">* Synthetic: made by formulas, or learned from demonstrations that "
            "were.</p>";
    return withContents(lead, out + methods(evaluation) + provenance(evaluation)) +
           pageEnd(
               "The tables summarise their numbers; deixis evaluate --csv writes them clip by clip, step by "
               "step and place by place.");
}

}  // namespace deixis::results
