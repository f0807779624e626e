// The report's tests of single ratings, and of authors' trials; private to the report.
#pragma once

#include <string>

#include "results/analysis/analysis.hpp"
#include "results/page/number_text.hpp"

namespace deixis::results {

// `where`: of several studies, " in STUDY" or ", all studies pooled".

/// Pairs of systems in one measure; empty where none was asked for or can be compared.
[[nodiscard]] std::string ratingPairsHtml(const AnalysisResult& result, const Measure& measure,
                                          const std::string& where, Numbering& numbering);

/// By single ratings and by participants' means; empty where the answers do not carry two trials.
[[nodiscard]] std::string authorTrialsHtml(const AnalysisResult& result, const std::string& where,
                                           Numbering& numbering);

/// What is to be copied of both in one measure, HTML paragraphs.
[[nodiscard]] std::string ratingResults(const AnalysisResult& result, const std::string& where,
                                        const Measure& measure);

}  // namespace deixis::results
