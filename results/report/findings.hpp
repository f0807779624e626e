// What the report says in sentences of its own: the findings at its head, and how everything was done.
#pragma once

#include <string>

#include "results/analysis/analysis.hpp"

namespace deixis::results {

/// What stands at the head of the page: the main findings in a few sentences, HTML.
[[nodiscard]] std::string findingsHtml(const AnalysisResult& result);

/// How it was done, in plain language, HTML paragraphs.
[[nodiscard]] std::string methodsHtml(const AnalysisResult& result);

}  // namespace deixis::results
