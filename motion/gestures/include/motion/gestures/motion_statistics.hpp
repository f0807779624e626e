// Speed, acceleration and jerk of a body over many clips, as in the GENEA challenges' numerical
// evaluations (Kucherenko et al. 2021; github.com/genea-workshop/genea_numerical_evaluations). Pure
// functions.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"
#include "motion/skeleton/kinematics.hpp"

namespace deixis::motion {

/// Trajectories of a body's joints relative to the hips, metres: [joint][frame].
struct JointTrajectories {
    double frame_time_s = 1.0 / 30.0;
    std::vector<Bone> joints;
    std::vector<std::vector<Vec3>> positions;
};
/// Of the bones asked for, those that the map has, in the order given. The map has hips.
[[nodiscard]] JointTrajectories jointTrajectories(const Clip& clip, const HumanoidMap& map,
                                                  const std::vector<Bone>& bones);
/// Neck, head, and both arms from shoulder joint to hand: what the comparison looks at. Trunk and legs hardly
/// move relative to the hips, fingers are not in every skeleton.
[[nodiscard]] const std::vector<Bone>& comparedBones();

[[nodiscard]] std::string_view derivativeName(Derivative derivative);  ///< "speed", ...

/// Counts in bins of equal width from 0 on; what lies beyond the last bin is counted in it.
struct Histogram {
    double bin_width = 1.0;
    std::vector<double> counts;
};
/// 300 bins of 1 cm/s (GENEA's width), 0.1 m/s^2 or 5 m/s^3.
[[nodiscard]] Histogram emptyHistogram(Derivative derivative);
void count(Histogram& histogram, const std::vector<double>& values);

/// Hellinger distance sqrt(1 - sum sqrt(p q)) of two histograms with the same bins, normalised: 0 equal, 1
/// without a bin in common. Both hold something.
[[nodiscard]] double hellingerDistance(const Histogram& a, const Histogram& b);

/// Mean and standard deviation (over n, as GENEA's) of the clips' means; a clip's mean is over its joints'
/// means over its frames.
struct OverClips {
    double mean = 0.0;
    double sd = 0.0;
};

struct MotionStatistics {
    std::vector<Bone> joints;
    std::array<OverClips, derivative_count> average{};  ///< by Derivative, m/s, m/s^2, m/s^3
    /// By Derivative, then by joint: every frame of every clip.
    std::array<std::vector<Histogram>, derivative_count> histograms;
};
/// Fails without clips, where a clip has fewer than 4 frames, or where clips differ in joints or frame rate;
/// the message counts clips from 1.
[[nodiscard]] Result<MotionStatistics> motionStatistics(const std::vector<JointTrajectories>& clips);

/// Hellinger distances of two sets of clips with the same joints.
struct MotionDistance {
    double pooled = 0.0;  ///< of the histograms summed over joints: GENEA's figure
    double mean = 0.0;    ///< mean over joints of each joint's distance
};
[[nodiscard]] Result<std::array<MotionDistance, derivative_count>> motionDistances(const MotionStatistics& a,
                                                                                   const MotionStatistics& b);

}  // namespace deixis::motion
