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
            ? "Scott\u2019s rule as in statsmodels\u2019 KDEMultivariate, 1.06\u00a0\u03c3\u00a0n^(\u22121/7)"
        : evaluation.bandwidth_rule == "scott"
            ? "Scott\u2019s rule, \u03c3\u00a0n^(\u22121/7)"
            : "Scott\u2019s rule on the whole covariance, as in SciPy\u2019s gaussian_kde";
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
    std::string out;
    if (!systems.empty())
        out = fmt::format(
            "{} {} made by formulas, or learned from demonstrations that were, not from people (marked * "
            "below). ",
            systems, systems.find(", ") == std::string::npos ? "is" : "are");
    if (training) out += "The training targets are those of this program's synthetic demonstrations.";
    return titledParagraph("Synthetic:", out, ParagraphLook::synthetic);
}

std::string findings(const Evaluation& evaluation) {
    std::vector<const SystemEvaluation*> measured;
    for (const auto& system : evaluation.systems)
        if (!system.rewards.empty()) measured.push_back(&system);
    if (measured.empty()) return "";
    std::stable_sort(measured.begin(), measured.end(),
                     [](const auto* a, const auto* b) { return mean(a->rewards) > mean(b->rewards); });
    const auto named = [](const SystemEvaluation* system) {
        return fmt::format("{} ({:.3f}; mean error {:.1f}\u00b0)", strongHtml(system->system),
                           mean(system->rewards), mean(system->errors_deg));
    };
    std::string means = measured.size() == 1 ? "Mean accuracy of " + named(measured.front()) + "."
                                             : named(measured.front()) + " has the highest mean accuracy, " +
                                                   named(measured.back()) + " the lowest.";
    means += fmt::format(" That is the forearm's, Equation\u00a02, whose ceiling is {:.3f}.",
                         motion::highest_pointing_reward);
    // None is picked out: the strongest of several is no finding.
    std::string correlations;
    for (const auto& system : evaluation.systems)
        if (system.correlation.method != "undefined")
            correlations += fmt::format("{}{} {}", correlations.empty() ? "" : ", ",
                                        strongHtml(system.system), fixedText(system.correlation.rho, 3));
    if (!correlations.empty())
        correlations =
            "Spearman's correlation of accuracy with the density of the training targets: " + correlations +
            "; the table has p and p after Holm's correction.";
    return itemsHtml({observersFinding(evaluation.observers), means, raysFinding(evaluation), correlations});
}

Section systemsSection(const Evaluation& evaluation, Numbering& figures, Numbering& tables) {
    std::string drawn = figureHtml(accuracyBoxes(evaluation, figures));
    const bool compared = std::any_of(evaluation.comparisons.begin(), evaluation.comparisons.end(),
                                      [](const auto& pair) { return !pair.differences.empty(); });
    if (compared) drawn += figureHtml(accuracyDifferences(evaluation, figures));
    std::string out = figuresPlaced(drawn);
    out += systemsHtml(evaluation, tables);
    out += raysHtml(evaluation, tables);
    return {"Accuracy by system", out + accuracyBoxesHtml(evaluation, tables)};
}

Section observersSection(const Evaluation& evaluation, Numbering& tables) {
    if (!evaluation.input.study) return {};
    return {
        "Read by observers",
        paragraphHtml(fmt::format("The games of the study {}: each clip with the balls of its target, seen "
                                  "from each layout\u2019s place in a headset. {}",
                                  escapeHtml(evaluation.input.study->name), nearestText(*evaluation.nearest)),
                      ParagraphLook::intro) +
            observersTable(evaluation.observers, "clips and places", tables)};
}

Section profilesSection(const Evaluation& evaluation, Numbering& figures, Numbering& tables) {
    std::string drawn;
    for (std::size_t i = 0; i < evaluation.systems.size(); ++i)
        for (const ProfileKind kind : {ProfileKind::reward, ProfileKind::speed})
            drawn += figureHtml(profileFigure(evaluation, i, kind, figures));
    return {
        "Around the time of pointing",
        paragraphHtml("Reward and speed of the pointing hand, mean and band of one standard deviation over "
                      "the clips of each hand (their number in brackets; the paper\u2019s Figures 2 and "
                      "3). 0 is the time of pointing; steps that fewer than half of the clips have are "
                      "left out. Dashed lines: the ceiling of the reward, and the speed below which a "
                      "frame counts.",
                      ParagraphLook::intro) +
            figuresPlaced(drawn) + profilesHtml(evaluation, tables)};
}

Section trainingSection(const Evaluation& evaluation, Numbering& figures, Numbering& tables) {
    std::string out = paragraphHtml(
        "In the maps a cell is a mean over y (from above) or over z (from behind); the agent stands at x = 0 "
        "and z = 0, and its left is on the left.",
        ParagraphLook::intro);
    out += figuresPlaced(figureHtml(densitySpace(evaluation, figures)), FigurePlace::single);
    out += figuresPlaced(figureHtml(densityMap(evaluation, figures)));
    out += correlationTable(evaluation, tables);
    out += paragraphHtml(
        "Accuracy against density, one point per clip (the paper\u2019s Figure\u00a010\u00a0A). Diamonds, "
        "with at least fifty clips: medians of tenths of the clips, by density.",
        ParagraphLook::intro);
    std::string drawn;
    for (std::size_t i = 0; i < evaluation.systems.size(); ++i)
        drawn += figureHtml(densityScatter(evaluation, i, figures));
    out += figuresPlaced(drawn);
    out += figuresPlaced(figureHtml(accuracyMaps(evaluation, figures)));
    out += clustersHtml(evaluation, tables);
    if (anySynthetic(evaluation))
        out += noteHtml("* Synthetic: made by formulas, or learned from demonstrations that were.");
    return {"Accuracy and training targets", out};
}

Section methods(const Evaluation& evaluation) {
    const EvaluationInput& input = evaluation.input;
    const auto plain = [](double value) { return fmt::format("{:g}", value); };
    return {"Methods",
            filled("evaluation_methods.mustache", {{"half_window_s", plain(0.5 * input.rule.window_s)},
                                                   {"window_s", plain(input.rule.window_s)},
                                                   {"slower_than_m_s", plain(input.rule.slower_than_m_s)},
                                                   {"training_targets", input.training.size()},
                                                   {"bandwidths", bandwidthWords(evaluation)}})};
}

Section provenance(const Evaluation& evaluation) {
    const EvaluationInput& input = evaluation.input;
    std::vector<Fact> facts;
    const auto entry = [&](const std::string& name, const std::string& html) {
        facts.push_back({name, html});
    };
    entry("Program", escapeHtml(input.program));
    for (const auto& [name, value] : input.build) entry(propertyLabel(name), escapeHtml(value));
    entry("Training targets", escapeHtml(input.training_source));
    for (const InputFile& file : input.files)
        entry("File", escapeHtml(file.path + ", SHA-256 " + file.sha256));
    entry("Motion", fmt::format("{} clips; SHA-256 over the positions of elbow and hand {}",
                                input.clips.size(), escapeHtml(input.motion_digest)));
    entry("Bandwidths", bandwidthWords(evaluation));
    entry("MeanShift",
          fmt::format(
              "bandwidth {:.6g} m ({})", evaluation.mean_shift_bandwidth,
              evaluation.mean_shift_estimated ? "mean distance to the neighbour at quantile 0.3" : "given"));
    return {"Where the numbers come from", factsHtml(facts)};
}

}  // namespace

std::string renderEvaluation(const Evaluation& evaluation) {
    const EvaluationInput& input = evaluation.input;
    const std::string title = "Objective evaluation of pointing";
    const std::string lead =
        pageStart(title, title) +
        paragraphHtml(fmt::format("{} \u00b7 {} clips \u00b7 {} test points \u00b7 {} training targets ({})",
                                  counted(static_cast<int>(evaluation.systems.size()), "system", "systems"),
                                  input.clips.size(), evaluation.points.size(), input.training.size(),
                                  escapeHtml(input.training_source)),
                      ParagraphLook::lead) +
        syntheticNote(evaluation) + findings(evaluation);
    Numbering figures("Figure");
    Numbering tables;
    // Figures and tables count: braces, from the first to the last.
    std::vector<Section> sections{remarksSection(evaluation.remarks),
                                  observersSection(evaluation, tables),
                                  systemsSection(evaluation, figures, tables),
                                  comparisonsSection(evaluation, tables),
                                  profilesSection(evaluation, figures, tables),
                                  trainingSection(evaluation, figures, tables),
                                  methods(evaluation),
                                  provenance(evaluation)};
    return withContents(lead, std::move(sections)) +
           pageEnd(
               "The tables summarise their numbers; deixis evaluate --csv writes them clip by clip, step by "
               "step and place by place.");
}

}  // namespace deixis::results
