// From where on a participant's answers are named on the page; nobody is left out for it.
#pragma once

#include "results/answers/data_quality.hpp"

namespace deixis::results {

inline constexpr double mostly_one_rating = 0.9;
inline constexpr double side_p = 0.01;
inline constexpr double many_odd_times = 0.1;

[[nodiscard]] bool standsOut(const ParticipantQuality& one);

}  // namespace deixis::results
