// What an analysis tells besides its tests; private to the analysis.
#pragma once

#include "results/analysis.hpp"

namespace deixis::results {

/// Fills in chance, times, order, items and presence. Needs the measures.
void describeAnswers(AnalysisResult& result);

}  // namespace deixis::results
