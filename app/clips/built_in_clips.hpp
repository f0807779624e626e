// The clips of a built-in system for a study's targets, made once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "assets/avatar/avatar.hpp"
#include "assets/tables/target_list.hpp"
#include "core/error.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::app {

/// The manifest of the clips, in a folder under `folder` that is named after all that they depend on, and
/// made there where it is not there yet. `maker` is Deixis's own avatar, for which they are made
/// whichever one the study shows. Several threads and programs may ask for the same clips at once.
[[nodiscard]] Result<std::filesystem::path> builtInManifest(const studies::SystemSource& system,
                                                            std::uint64_t seed,
                                                            const std::vector<assets::ListedTarget>& targets,
                                                            const assets::Avatar& maker,
                                                            const std::filesystem::path& folder);

}  // namespace deixis::app
