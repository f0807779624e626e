// Poses that a motion must have at some frames: meeting them exactly, and motion from nothing else.
#pragma once

#include <span>
#include <vector>

#include "core/error.hpp"
#include "motion/upper_body/upper_body.hpp"

namespace deixis::motion {

struct PoseControl {
    int frame = 0;
    UpperBodyPose pose;
};

/// The first problem of poses for a motion of `frames` frames: a frame outside of it, two for one frame, a
/// direction that is not of unit length (within 1 %).
[[nodiscard]] Result<void> checkPoses(std::span<const PoseControl> poses, std::size_t frames);

/// Brings the motion to the poses, which it then has to the bit. Each bone's rotation from the motion to the
/// pose is spread over neighbouring frames: from nothing at both sides it grows along a minimum-jerk course,
/// which begins and ends with the speed that it has among the poses themselves, and no acceleration. That
/// takes a quarter of a second on either side, and longer, up to two seconds, until speed and acceleration of
/// the bones in it stay under the 99th percentile of the motion that was given. Between poses whose courses
/// would meet one course leads from one to the next: there, and at poses that follow each other at once, both
/// can be faster. Elsewhere the motion stays as it is, to the bit. The poses must have passed checkPoses().
void meetPoses(UpperBodyMotion& motion, std::vector<PoseControl> poses);

/// The condition MANUAL of Yoon et al. (2021, section 7): through the keyframes a cubic spline for each
/// number of the directions, with no slope at its ends, at which stands `ends` unless there are keyframes;
/// each direction is then made unit length, so that bones keep their length. The keyframes must have passed
/// checkPoses().
[[nodiscard]] UpperBodyMotion motionThroughKeyframes(std::vector<PoseControl> keyframes, std::size_t frames,
                                                     const UpperBodyPose& ends);

}  // namespace deixis::motion
