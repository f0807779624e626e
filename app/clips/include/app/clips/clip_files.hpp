// Clips of any format with their humanoid bones, and retargeted to the avatar.
#pragma once

#include <filesystem>
#include <string>

#include "assets/avatar/avatar.hpp"
#include "assets/joints/clip_import.hpp"
#include "assets/tables/manifest.hpp"
#include "core/error.hpp"
#include "motion/humanoid/mapping.hpp"
#include "motion/retarget/retarget.hpp"
#include "motion/skeleton/clip.hpp"

namespace deixis::app {

struct MappedClip {
    motion::Clip clip;  ///< metres, y up, on the file's own skeleton
    motion::HumanoidMap map;
};

/// Which joint of an imported clip plays which bone: as the file beside it says (assets/humanoid_file.hpp),
/// else the file itself, else as found. Fails on mistakes in the file beside it.
[[nodiscard]] Result<motion::HumanoidMapping> mapImported(const assets::ImportedClip& imported,
                                                          const std::filesystem::path& file);

/// Any file that assets::importClip() reads. Its bones are those that the file beside it says
/// (assets/humanoid_file.hpp), else the file itself, else those that are found.
[[nodiscard]] Result<MappedClip> readMappedClip(const std::filesystem::path& file,
                                                const assets::ImportOptions& options = {});

/// Moves a clip to the coordinates that a target is given in: where these are its figure's, so that it begins
/// at their origin.
void standByTarget(motion::Clip& clip, const motion::HumanoidMap& map, assets::TargetFrame frame);

/// The clip on the avatar's skeleton: its joints put in the avatar's order where it was made for this avatar
/// (same names and bone lengths), else retargeted, its bones as the file beside it says where there is one
/// (assets/humanoid_file.hpp). `file`: the clip's, which also stands for it in errors.
[[nodiscard]] Result<motion::Clip> clipOnAvatar(const assets::ImportedClip& imported, const std::string& file,
                                                const assets::Avatar& avatar,
                                                const motion::RetargetOptions& options = {},
                                                motion::RetargetReport* report = nullptr);

/// Whether a clip was made for the avatar, so that clipOnAvatar leaves its motion as it is.
[[nodiscard]] bool isOnAvatar(const motion::Clip& clip, const assets::Avatar& avatar);

}  // namespace deixis::app
