// The place and facing of a figure in its clip.
#pragma once

#include "motion/skeleton/clip.hpp"

namespace deixis::motion {

/// Takes a clip's coordinates to those of its figure in a frame: origin on y = 0 below the hips, z ahead as
/// the hips face (told by the legs, else by the upper arms), x to its left. The identity if the figure has
/// no hips, or neither both legs nor both arms.
[[nodiscard]] Pose figureFromClip(const Clip& clip, const HumanoidMap& map, int frame);

/// The same in the first frame, with the origin on the floor that the figure stands on, by its lower ankle.
[[nodiscard]] Pose figureOnFloorFromClip(const Clip& clip, const HumanoidMap& map);

/// Whether the figure begins half a metre or more from the origin's vertical, or faces 30 degrees or more
/// away from +z: then it is not where an avatar points from.
[[nodiscard]] bool standsAway(const Clip& clip, const HumanoidMap& map);

}  // namespace deixis::motion
