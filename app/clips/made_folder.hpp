// Folders of clips that are made once.
#pragma once

#include <filesystem>
#include <functional>

#include "core/error.hpp"

namespace deixis::app {

/// The manifest of the folder `clips`, which `make` fills where it is not there yet, last of all with its
/// manifest.csv. Whole, or not there: whoever makes the same clips at the same time finds those of whoever
/// was first.
[[nodiscard]] Result<std::filesystem::path> madeOnce(
    const std::filesystem::path& clips,
    const std::function<Result<void>(const std::filesystem::path& making)>& make);

}  // namespace deixis::app
