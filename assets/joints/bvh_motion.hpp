// The lines of numbers of a BVH file -> poses; private to its reader.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"

namespace deixis::assets {

struct BvhChannel {
    bool rotation;
    int axis;  ///< 0 x, 1 y, 2 z
};
/// Of each joint, in file order.
using BvhChannels = std::vector<std::vector<BvhChannel>>;

/// The lines of motion, which begin in line `first_line` of the file `name`.
struct BvhMotionText {
    std::string_view text;
    int first_line;
    const std::string& name;
    std::size_t frame_count;  ///< as the file declares it
};

/// Appends one pose to clip.frames for each line, in file units: positions replace the rest's, axis by axis;
/// rotations are applied in the order of the channels. clip.skeleton is there already.
[[nodiscard]] Result<void> readBvhMotion(const BvhMotionText& motion, const BvhChannels& channels,
                                         motion::Clip& clip);

}  // namespace deixis::assets
