// Text for the report: escaped for HTML, numbers rounded for reading.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "results/analysis.hpp"

namespace deixis::results {

/// Safe as text and as an attribute's value, in HTML and XML.
[[nodiscard]] std::string escapeHtml(std::string_view text);

/// "<0.001" or three decimals; escaped.
[[nodiscard]] std::string pText(double p);

/// A participant's mean, a mean or an SD of a measure: percent with one decimal, or scale points with two.
[[nodiscard]] std::string scoreText(const Measure& measure, double value);

/// "Accuracy", "Human-likeness".
[[nodiscard]] std::string capitalised(std::string_view text);

/// The page's style sheet.
extern const char* const report_css;

/// Box plot of one of AnalysisResult::measures, as an SVG element.
[[nodiscard]] std::string boxPlotSvg(const AnalysisResult& result, std::size_t measure);

/// Preferences as stacked bars, one a pair of systems, as an SVG element.
[[nodiscard]] std::string preferencesSvg(const AnalysisResult& result);

/// What stands at the head of the page: the main findings in a few sentences, HTML.
[[nodiscard]] std::string findingsHtml(const AnalysisResult& result);

/// How it was done, in plain language, HTML paragraphs.
[[nodiscard]] std::string methodsHtml(const AnalysisResult& result);

}  // namespace deixis::results
