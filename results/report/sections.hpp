// The report's sections of what stands beside the tests; private to the report. Sections without anything to
// say are empty.
#pragma once

#include <string>

#include "results/analysis/analysis.hpp"
#include "results/page/number_text.hpp"
#include "results/page/page.hpp"

namespace deixis::results {

/// Accuracy against chance, order, response times, items; empty where nothing of it is known.
[[nodiscard]] Section descriptivesSection(const AnalysisResult& result, Numbering& numbering);

/// The same comparisons of systems under other choices: zeros dropped or ranked, p exact or normal, with and
/// without exclusions, without doubtful answers.
[[nodiscard]] Section sensitivitySection(const AnalysisResult& result, Numbering& numbering);

/// Systems that no participant saw both of; empty where there are none. `where`: of several studies, which.
[[nodiscard]] std::string systemsApartHtml(const AnalysisResult& result, const std::string& where,
                                           Numbering& numbering);

/// Those, and groups by the between-participants factors; empty where there are none.
[[nodiscard]] Section betweenSection(const AnalysisResult& result, Numbering& numbering);

/// Questionnaires' scores; empty where there are none.
[[nodiscard]] Section scoresSection(const AnalysisResult& result, Numbering& numbering);

/// Ratings of scales with many steps, one by one; empty where there are none.
[[nodiscard]] std::string pooledHtml(const AnalysisResult& result, Numbering& numbering);

/// Confusion and the accuracy over target space; empty where the balls' positions are not known.
[[nodiscard]] Section choicesSection(const AnalysisResult& result, Numbering& figures, Numbering& numbering);

/// Answers beside the objective evaluation; empty without one.
[[nodiscard]] Section objectiveSection(const AnalysisResult& result, Numbering& numbering);

/// What was measured in a unit, over the targets' places; empty where nothing was.
[[nodiscard]] Section measuredSection(const AnalysisResult& result, Numbering& figures, Numbering& numbering);

/// Who answered how often on what; empty where every participant has as many answers under each system.
[[nodiscard]] Section presenceSection(const AnalysisResult& result, Numbering& numbering);

}  // namespace deixis::results
