// The report's tables of what stands beside the tests; private to the report.
#pragma once

#include <string>

#include "results/analysis/analysis.hpp"
#include "results/page/number_text.hpp"

namespace deixis::results {

/// Accuracy against chance, order, response times, items; empty where nothing of it is known.
[[nodiscard]] std::string descriptivesHtml(const AnalysisResult& result, Numbering& numbering);

/// The same comparisons of systems under other choices: zeros dropped or ranked, p exact or normal, with and
/// without exclusions, without doubtful answers.
[[nodiscard]] std::string sensitivityHtml(const AnalysisResult& result, Numbering& numbering);

/// Systems that no participant saw both of; empty where there are none. `where`: of several studies, which.
[[nodiscard]] std::string systemsApartHtml(const AnalysisResult& result, const std::string& where,
                                           Numbering& numbering);

/// Those, and groups by the between-participants factors; empty where there are none.
[[nodiscard]] std::string betweenHtml(const AnalysisResult& result, Numbering& numbering);

/// Questionnaires' scores; empty where there are none.
[[nodiscard]] std::string scoresHtml(const AnalysisResult& result, Numbering& numbering);

/// Ratings of scales with many steps, one by one; empty where there are none.
[[nodiscard]] std::string pooledHtml(const AnalysisResult& result, Numbering& numbering);

/// Confusion and the accuracy over target space; empty where the balls' positions are not known.
[[nodiscard]] std::string choicesHtml(const AnalysisResult& result, Numbering& figures, Numbering& numbering);

/// Answers beside the objective evaluation; empty without one.
[[nodiscard]] std::string objectiveHtml(const AnalysisResult& result, Numbering& numbering);

/// What was measured in a unit, over the targets' places; empty where nothing was.
[[nodiscard]] std::string measuredHtml(const AnalysisResult& result, Numbering& figures,
                                       Numbering& numbering);

/// Who answered how often on what; empty where every participant has as many answers under each system.
[[nodiscard]] std::string presenceHtml(const AnalysisResult& result, Numbering& numbering);

}  // namespace deixis::results
