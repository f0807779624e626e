// How much of a study's balls participants can see, as text.
#pragma once

#include <string>

#include "app/clips/study_setup.hpp"

namespace deixis::app {

/// A line for each place from which a game is played: of how many sets of balls all are seen past the avatar
/// that the study shows, at rest and pointing, and which are not. Empty if no game is played.
[[nodiscard]] std::string visibilityText(const StudySetup& setup, const assets::Avatar& avatar);

}  // namespace deixis::app
