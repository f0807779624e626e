// What a reader of an analysis must know besides the numbers; private to the analysis.
#pragma once

#include "results/analysis/analysis.hpp"

namespace deixis::results {

/// Adds what is to be told of the answers: missing, interrupted, simulated ones.
void remarkAnswers(AnalysisResult& result);

/// Adds what is to be told of the tests: who is left out of them, what cannot be significant, what depends on
/// how zeros are treated.
void remarkTests(AnalysisResult& result);

}  // namespace deixis::results
