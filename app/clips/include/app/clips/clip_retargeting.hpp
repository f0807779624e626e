// A folder of clips, listed in a manifest, retargeted to an avatar.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "assets/avatar/avatar.hpp"
#include "assets/joints/clip_import.hpp"
#include "assets/tables/manifest.hpp"
#include "core/error.hpp"
#include "motion/retarget/retarget.hpp"

namespace deixis::app {

/// How clips are brought to the avatar.
struct RetargetSettings {
    motion::Keep keep = motion::Keep::joint_angles;
    bool close_hand = false;  ///< hands without fingers close with the index finger out while they point
    bool plant_feet = true;
};

/// The gesture of a manifest's row; none if the row has no phases.
[[nodiscard]] std::optional<motion::PointingGesture> gestureOf(const assets::ManifestRow& row);

/// A row's clip on the avatar, where its target is. The row's pointing errors, which the source and the
/// avatar make, are filled in. Fails if the target is given in the clip's coordinates and the figure does
/// not stand at their origin, as an avatar does.
[[nodiscard]] Result<motion::Clip> retargetRow(assets::ImportedClip clip, const std::string& file,
                                               const assets::Avatar& avatar, const RetargetSettings& settings,
                                               assets::ManifestRow& row,
                                               motion::RetargetReport* report = nullptr);

/// Every clip of a manifest as BVH under `folder`, by the name that it has beside its manifest, and a
/// manifest of them, all or none. `each` is told of every clip. Files that are there already are replaced
/// only where `force` says so.
[[nodiscard]] Result<std::vector<assets::ManifestRow>> retargetClips(
    const assets::Manifest& manifest, const assets::Avatar& avatar, const RetargetSettings& settings,
    const std::filesystem::path& folder, bool force,
    const std::function<void(const assets::ManifestRow&, const motion::RetargetReport&)>& each);

}  // namespace deixis::app
