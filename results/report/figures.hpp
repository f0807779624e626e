// The report's figures; private to the report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/analysis/analysis.hpp"
#include "results/page/figure.hpp"
#include "results/page/number_text.hpp"
#include "results/page/page.hpp"

namespace deixis::results {

/// How often each step of a rating's scale was chosen.
struct StepCounts {
    std::vector<int> steps;                ///< lowest first
    std::vector<std::vector<int>> counts;  ///< [system][step], answers
};
/// None for a measure that is no rating, of more than ten steps, or with answers between the steps.
[[nodiscard]] std::optional<StepCounts> stepCounts(const AnalysisResult& result, std::size_t measure);

/// Participants' means of AnalysisResult::measures[measure] by system.
[[nodiscard]] Figure boxPlot(const AnalysisResult& result, std::size_t measure, Numbering& figures);
/// Of a measure's values: title, ticks at round numbers and at the scale's ends.
[[nodiscard]] FigureJson scaleAxis(const Measure& measure);
/// Means under the levels of a within-participants factor, a line for each system; none where fewer than two
/// levels have answers.
[[nodiscard]] std::optional<Figure> levelsFigure(const AnalysisResult& result, std::size_t measure,
                                                 const Factor& factor, Numbering& figures);
/// Shares of a rating's steps by system, the scale's middle at 0.
[[nodiscard]] Figure answersFigure(const AnalysisResult& result, std::size_t measure,
                                   const StepCounts& counts, Numbering& figures);
/// Answers for the one, for neither and for the other, a bar for each pair of systems.
[[nodiscard]] Figure preferencesFigure(const AnalysisResult& result, Numbering& figures);
/// Participants' differences between each pair of systems in a measure.
[[nodiscard]] Figure differencesFigure(const AnalysisResult& result, std::size_t measure, Numbering& figures);

/// Correct choices at each target's place. AnalysisResult::target_space is not empty.
[[nodiscard]] Figure placesFigure(const AnalysisResult& result, Numbering& figures);

/// Of the above what stands at the page's head.
[[nodiscard]] std::string figuresHtml(const AnalysisResult& result, Numbering& figures);
/// The differences of all measures, with their heading; empty where nothing is compared.
[[nodiscard]] Section differencesSection(const AnalysisResult& result, Numbering& figures);
/// Tables of what the figures draw and no other table holds: quantiles, and how often each step was chosen.
[[nodiscard]] std::string distributionsHtml(const AnalysisResult& result, Numbering& tables);

}  // namespace deixis::results
