// Angles between targets and distractors, as text for check and targets.
#pragma once

#include <string>

#include "app/clips/study_setup.hpp"

namespace deixis::app {

/// A line for the avatar's eyes and one for each place of a game; empty without a game.
[[nodiscard]] std::string anglesText(const StudySetup& setup);

}  // namespace deixis::app
