// The index of a bone in tables with an entry for each bone.
#pragma once

#include <cstddef>

#include "motion/skeleton/humanoid.hpp"

namespace deixis::motion {

constexpr std::size_t indexOf(Bone bone) {
    return static_cast<std::size_t>(bone);
}

}  // namespace deixis::motion
