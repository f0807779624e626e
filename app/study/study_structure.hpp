// What a database's answers hang on in a study.
#pragma once

#include <string>

#include "studies/study_file/study.hpp"

namespace deixis::app {

/// How the second study would not fit answers to the first, the first such thing in words; empty: it fits.
/// Names and kinds of stages, what is asked on which scale, systems with their levels, layouts, distances and
/// groups must be the same; wording, clips, timing, languages and numbers of items may differ.
[[nodiscard]] std::string structureDifference(const studies::Study& before, const studies::Study& now);

}  // namespace deixis::app
