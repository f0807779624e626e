// The reference humanoid's joints of the upper body: where they are on its bones, and measuring them; private
// to this room.
#pragma once

#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/skeleton/bone_index.hpp"
#include "motion/upper_body/upper_body.hpp"

namespace deixis::motion {

// In the head's frame, metres: between the eyes' and the jaw's joints, and at the figure's height.
inline const Vec3 nose_in_head{0.0, 0.060, 0.090};
inline const Vec3 top_in_head{0.0, 0.215, -0.005};

/// From the bone above, at rest.
[[nodiscard]] inline const Vec3& restOffset(Bone bone) {
    return referenceHumanoid().joints[indexOf(bone)].rest.position;
}

}  // namespace deixis::motion
