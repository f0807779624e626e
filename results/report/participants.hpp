// Who took part, how long, and their questionnaires, on the report's page; private to it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "results/analysis/analysis.hpp"
#include "results/page/number_text.hpp"

namespace deixis::results {

/// "age: median 31 (20 to 60), n = 24", "gender: f 12, m 11", and the time of sessions by group: a name and a
/// text each, HTML.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> participantEntries(
    const AnalysisResult& result);

/// Tests of questionnaires' scores, before against after and between groups; empty where there are none.
[[nodiscard]] std::string scoreTestsHtml(const AnalysisResult& result, Numbering& numbering);

/// Tests of response times, between systems and groups; likewise.
[[nodiscard]] std::string timeTestsHtml(const AnalysisResult& result, Numbering& numbering);

/// "median 31 (20 to 60), n = 24" or "f 12, m 11", HTML.
[[nodiscard]] std::string fieldText(const FieldResult& field);

}  // namespace deixis::results
