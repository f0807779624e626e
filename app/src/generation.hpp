// Making a system's clips for a list of targets: BVH files and a manifest.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "assets/manifest.hpp"
#include "core/error.hpp"
#include "motion/generator.hpp"

namespace deixis::app {

using NamedTarget = std::pair<std::string, Vec3>;  ///< id, position in the avatar's frame

/// Writes one BVH file per target and, last, `manifest.csv`: where the manifest stands, all its clips do.
[[nodiscard]] Result<std::vector<assets::ManifestRow>> generateClips(const motion::Generator& generator,
                                                                     const std::vector<NamedTarget>& targets,
                                                                     std::uint64_t seed,
                                                                     const std::filesystem::path& folder);

/// Targets from a CSV file with the columns target_id, x, y and z (others are passed over), such as
/// `deixis targets` prints.
[[nodiscard]] Result<std::vector<NamedTarget>> readTargets(const std::filesystem::path& path);

}  // namespace deixis::app
