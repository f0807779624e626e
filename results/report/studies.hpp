// Several studies on the report's page; private to the report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/analysis/analysis.hpp"
#include "results/page/figure.hpp"
#include "results/page/number_text.hpp"
#include "results/page/page.hpp"

namespace deixis::results {

/// The section of what each study shows by itself, with the medians in order; empty of one study.
[[nodiscard]] Section studiesSection(const AnalysisResult& result, Numbering& numbering);

/// Participants' means of a measure by system, in each study and pooled: as Yoon et al. 2021, Figure 7.
[[nodiscard]] Figure studyBoxPlot(const AnalysisResult& result, std::size_t measure, Numbering& figures);

/// "Medians, highest first: a 56.00, b 54.00."; empty where none is known. `study`: or pooled_studies.
[[nodiscard]] std::string mediansSentence(const AnalysisResult& result, const std::string& study,
                                          const Measure& measure);

/// Where each study's answers come from, as entries of a list; empty of one study.
[[nodiscard]] std::vector<Fact> studyOrigins(const ResponseTable& table);

}  // namespace deixis::results
