// Text for the report: escaped for HTML, numbers rounded for reading.
#pragma once

#include <string>
#include <string_view>

#include "results/analysis.hpp"

namespace deixis::results {

/// Safe as text and as an attribute's value, in HTML and XML.
[[nodiscard]] std::string escapeHtml(std::string_view text);

/// "<0.001" or three decimals; escaped.
[[nodiscard]] std::string pText(double p);

/// A participant's mean, a mean or an SD of a measure: percent with one decimal, or scale points with two.
[[nodiscard]] std::string scoreText(const std::string& measure, double value);

/// The page's style sheet.
extern const char* const report_css;

/// One of the two box plots, as an SVG element. `measure` is "accuracy" or "naturalness".
[[nodiscard]] std::string boxPlotSvg(const AnalysisResult& result, const std::string& measure);

/// What stands at the head of the page: the main findings in a few sentences, HTML.
[[nodiscard]] std::string findingsHtml(const AnalysisResult& result);

/// How it was done, in plain language, HTML paragraphs.
[[nodiscard]] std::string methodsHtml(const AnalysisResult& result);

}  // namespace deixis::results
