// Clips of humanoids <-> the motion of an upper body.
#pragma once

#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"
#include "motion/upper_body/upper_body.hpp"

namespace deixis::motion {

/// The upper body of any humanoid's clip (metres, y up), 15 frames a second from its first frame on. It is
/// retargeted to referenceHumanoid() first, so that rest poses and proportions do not matter. In each frame
/// the hips face +z: walking about and turning is left out, leaning is kept. Fails as retarget() does, naming
/// the bones that are missing.
[[nodiscard]] Result<UpperBodyMotion> upperBodyOf(const Clip& clip, const HumanoidMap& map);
/// The upper body of a pose of referenceHumanoid(), its hips turned to face +z.
[[nodiscard]] UpperBodyPose upperBodyOf(const LocalPose& pose);

/// The pose in which referenceHumanoid() has these directions (within 0.01 degrees where a body can have
/// them, else near). Hips and legs stand at rest; shoulders rise and draw forward as asked. Elbows bend about
/// their hinge; the twist of a nearly straight arm, which directions do not tell, is a natural one. Forearms
/// roll as people's do: palm inward before the body, up where the forearm points out, forward where it is
/// raised. Fingers are relaxed. It changes little where the directions change little; and does not depend on
/// other frames.
[[nodiscard]] LocalPose avatarPose(const UpperBodyPose& pose);
/// The same for each frame, on referenceHumanoid(), at 15 frames a second; retarget() takes it to other
/// avatars. At least one frame is needed. Without `relaxed_fingers` they are stretched.
[[nodiscard]] Clip avatarClip(const UpperBodyMotion& motion, bool relaxed_fingers = true);

/// As long as a sound: the last frame is held to the first multiple of a frame's time that is not before the
/// sound's end, which in a file that knows whole frames only is its last one's time.
[[nodiscard]] Clip heldFor(const Clip& clip, double duration_s);

}  // namespace deixis::motion
