// Clip files of every kind that the program reads, and clips on the avatar.
#pragma once

#include <filesystem>
#include <string>

#include "assets/avatar.hpp"
#include "assets/bvh.hpp"
#include "core/error.hpp"
#include "motion/clip.hpp"

namespace deixis::app {

struct ClipFile {
    motion::Clip clip;        ///< metres, on the file's own skeleton
    std::string description;  ///< for people: format, unit, frames, rate
};

/// BVH (.bvh, .bvh.gz) or Kinect v2 joint positions (.csv).
[[nodiscard]] Result<ClipFile> readClipFile(const std::filesystem::path& path,
                                            const assets::BvhOptions& options);

/// The clip on the avatar's skeleton: its joints put in the avatar's order where it was made for this avatar
/// (same names and bone lengths), else retargeted. `name` stands for the clip in errors.
[[nodiscard]] Result<motion::Clip> clipOnAvatar(const motion::Clip& clip, const assets::Avatar& avatar,
                                                const std::string& name);

}  // namespace deixis::app
