// What the directions of an arm leave open: the twist of its bones; private to this room.
#pragma once

#include "core/pose.hpp"
#include "motion/skeleton/humanoid.hpp"

namespace deixis::motion {

/// World rotations of the bones from their T pose; the hand relative to the forearm.
struct ArmTurns {
    Quat upper_arm{1.0, 0.0, 0.0, 0.0};
    Quat forearm{1.0, 0.0, 0.0, 0.0};
    Quat hand_in_forearm{1.0, 0.0, 0.0, 0.0};
};

/// `chest`: its world rotation from the T pose. `upper_arm` and `forearm`: unit directions in the world. Both
/// bones point so exactly.
[[nodiscard]] ArmTurns armTurns(Side side, const Quat& chest, const Vec3& upper_arm, const Vec3& forearm);

}  // namespace deixis::motion
