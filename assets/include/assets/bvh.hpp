// BVH files <-> clips.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "motion/clip.hpp"

namespace deixis::assets {

struct BvhOptions {
    /// Metres per file unit; none: detected from the figure's size (m, cm, inch, decimetre, cgspeed's 5.64
    /// cm).
    std::optional<double> metres_per_unit{};
};

struct BvhFile {
    motion::Clip clip;             ///< metres
    double metres_per_unit = 1.0;  ///< what was used
    std::string unit;              ///< in words, such as "centimetre (detected)"
};

/// Reads a BVH file; a name ending in .gz is unpacked. Errors name the file and line.
[[nodiscard]] Result<BvhFile> readBvh(const std::filesystem::path& path, const BvhOptions& options = {});
/// The same from text; `name` stands for the file in errors.
[[nodiscard]] Result<BvhFile> parseBvh(std::string_view text, const std::string& name,
                                       const BvhOptions& options = {});

/// The clip as BVH text in metres: ZXY rotations in degrees with 6 decimals; root with 6 channels, others
/// with 3. Requires joints without rest rotations.
[[nodiscard]] std::string writeBvh(const motion::Clip& clip);

}  // namespace deixis::assets
