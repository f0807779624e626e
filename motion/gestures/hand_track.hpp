// One hand over a recording, as the cutting of it sees it.
#pragma once

#include <vector>

#include "motion/pointing/phases.hpp"

namespace deixis::motion {

/// Each vector has one entry for each frame.
struct HandTrack {
    double arm_length_m = 0.0;  ///< shoulder to elbow to wrist, mean over the frames
    /// Hand from the shoulder in the person's axes (x left along the shoulders, y up, z ahead), arm lengths.
    std::vector<Vec3> reach;
    HandTrajectory trajectory;  ///< of `reach`, metres a second; displacement is still empty
    /// Speed of the hand in the recording over the last thirtieth of a second, metres a second.
    std::vector<double> step_speed_m_s;
};

/// Both hands' tracks, by Side.
[[nodiscard]] std::vector<HandTrack> trackHands(const Clip& recording, const HumanoidMap& map);

}  // namespace deixis::motion
