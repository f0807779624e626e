// The choices of a database with the movements that they followed, watched again from their clips.
#pragma once

#include <filesystem>
#include <vector>

#include "core/error.hpp"
#include "results/answers/observers.hpp"

namespace deixis::app {

/// All scored choices that count; none if there is no game. Clips are looked for as RecordedClips::load()
/// does, `stimuli` its folder. Fails if a clip that was shown, or the avatar, is not available any more.
[[nodiscard]] Result<std::vector<results::ObservedChoice>> observedChoices(
    const std::filesystem::path& database, const std::filesystem::path& stimuli);

}  // namespace deixis::app
