// Paragraphs for a paper, from what was computed and from that alone; private to the report.
#pragma once

#include <string>
#include <vector>

#include "results/analysis/analysis.hpp"

namespace deixis::results {

/// "naturalness (rated from 1 to 5)" of each measure.
[[nodiscard]] std::vector<std::string> measureTexts(const ResponseTable& table);
/// The fewest and the most answers that a participant gave.
[[nodiscard]] std::pair<int, int> answersPerParticipant(const ResponseTable& table);
/// Whether anybody has answered under two systems.
[[nodiscard]] bool systemsMeetInParticipants(const ResponseTable& table);
/// "1 excluded and 2 withdrew"; empty where nobody is left out.
[[nodiscard]] std::string leftOutText(const AnalysisResult& result);

/// Who answered what, what was tested, and by which program.
[[nodiscard]] std::string methodsParagraph(const AnalysisResult& result);
/// Means, and n, W, p, r and interval of each comparison: a paragraph for each measure and factor, HTML.
[[nodiscard]] std::string resultsParagraphs(const AnalysisResult& result);
/// What the methods rest on, an item each, HTML.
[[nodiscard]] std::vector<std::string> references(const AnalysisResult& result);

}  // namespace deixis::results
