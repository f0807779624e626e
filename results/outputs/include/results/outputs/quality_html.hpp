// The quality of the data on the page.
#pragma once

#include "results/analysis/analysis.hpp"
#include "results/answers/data_quality.hpp"
#include "results/page/number_text.hpp"
#include "results/page/page.hpp"

namespace deixis::results {

/// A section: how far the ratings agree, whose answers stand out, and the study's rule.
[[nodiscard]] Section qualitySection(const AnalysisResult& result, Numbering& numbering);

// From where on a participant's answers are named on the page; nobody is left out for it.
inline constexpr double mostly_one_rating = 0.9;
inline constexpr double side_p = 0.01;
inline constexpr double many_odd_times = 0.1;

[[nodiscard]] bool standsOut(const ParticipantQuality& one);

}  // namespace deixis::results
