// Text for the report: escaped for HTML, numbers rounded for reading.
#pragma once

#include <fmt/core.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "results/analysis.hpp"

namespace deixis::results {

/// Stands where a number is not defined.
constexpr const char* dash = "&#8211;";

/// Tables are numbered in the order in which they stand.
class Numbering {
  public:
    std::string next() { return fmt::format("<b>Table {}.</b>", ++last_); }

  private:
    int last_ = 0;
};

/// Safe as text and as an attribute's value, in HTML and XML.
[[nodiscard]] std::string escapeHtml(std::string_view text);

/// "<0.001" or three decimals; escaped.
[[nodiscard]] std::string pText(double p);
[[nodiscard]] std::string pText(const std::optional<double>& p);  ///< a dash where there is none

/// A participant's mean, a mean or an SD of a measure: percent with one decimal, or scale points with two.
[[nodiscard]] std::string scoreText(const Measure& measure, double value);

/// "[1.20, 2.31]", both as scoreText has them.
[[nodiscard]] std::string intervalText(const Measure& measure, double lower, double upper);

/// A formatted number with a proper minus sign.
[[nodiscard]] std::string signedText(std::string_view number);

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
