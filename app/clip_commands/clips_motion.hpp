// What `deixis clips` tells of how clips move: `measure` and `statistics`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assets/tables/manifest.hpp"
#include "core/error.hpp"

namespace deixis::app {

/// A clip file that was named on the command line or by a manifest.
struct NamedClip {
    std::filesystem::path file;
    std::string system;     ///< empty without a manifest
    std::string target_id;  ///< likewise
    std::optional<Vec3> target{};
    assets::TargetFrame target_frame = assets::TargetFrame::clip;
    std::optional<motion::GesturePhases> phases{};
};
/// The clips of files and manifests, in the order given. A .csv file is a manifest where its first line has
/// the column `clip`, else a clip.
[[nodiscard]] Result<std::vector<NamedClip>> namedClips(const std::vector<std::string>& files);

}  // namespace deixis::app
