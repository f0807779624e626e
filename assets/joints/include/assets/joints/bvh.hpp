// BVH files <-> clips. docs/clip-format.md says what is read and what is written.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "assets/joints/clip_import.hpp"
#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"

namespace deixis::assets {

struct BvhOptions {
    /// Metres per file unit; none: detected from the figure's size (m, cm, inch, decimetre, cgspeed's 5.64
    /// cm).
    std::optional<double> metres_per_unit{};
    /// Frames a second, above 0; none: as the file says. What it says is then not looked at.
    std::optional<double> fps{};
};

struct BvhFile {
    motion::Clip clip;  ///< metres, the file's own axes
    FoundUnit unit{};
    std::vector<std::string> remarks{};  ///< what was unusual about the file and how it was taken
};

/// Reads a BVH file; a name ending in .gz is unpacked. Errors name the file and line.
[[nodiscard]] Result<BvhFile> readBvh(const std::filesystem::path& path, const BvhOptions& options = {});
/// The same from text; `name` stands for the file in errors.
/// Position channels replace the joint's OFFSET, axis by axis; only where those of all joints below the root
/// are close to 0 (less than a tenth of OFFSET) are they added to it, as Blender's exporter means them. A
/// joint name that stands twice gets "#2",
/// "#3", ... behind its later uses.
[[nodiscard]] Result<BvhFile> parseBvh(std::string_view text, const std::string& name,
                                       const BvhOptions& options = {});

/// The clip as BVH text in metres, 6 decimals, rotations as ZXY in degrees; joints in depth-first order. The
/// root has 6 channels, as has a joint whose position leaves its rest by more than 1e-6 m; others have 3.
/// Read again, no joint is more than 1e-5 m away. Rest rotations are not kept (a pose holds whole rotations,
/// so the motion is). Throws std::invalid_argument if the skeleton has not exactly one root.
[[nodiscard]] std::string writeBvh(const motion::Clip& clip);

}  // namespace deixis::assets
