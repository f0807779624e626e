// The avatar of the motion tests: the product's own skeleton.
#pragma once

#include <vector>

#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/skeleton/clip.hpp"
#include "motion/skeleton/skeleton.hpp"

namespace deixis::tests {

inline const motion::Skeleton& avatar() {
    return motion::referenceHumanoid();
}

inline const motion::HumanoidMap& avatarMap() {
    static const motion::HumanoidMap map = motion::mapByVrmNames(avatar());
    return map;
}

inline std::vector<Pose> worldOf(const motion::Clip& clip, std::size_t frame) {
    return motion::worldPose(clip.skeleton, clip.frames[frame]);
}

}  // namespace deixis::tests
