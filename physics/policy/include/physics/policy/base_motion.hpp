// What a gesture does with joints that the simulated body does not have (shoulder girdle, the forearm's turn,
// wrist, fingers, eyes): as demonstrations do on average, by the phases of the gesture.
#pragma once

#include <vector>

#include "motion/skeleton/gesture_phases.hpp"
#include "motion/synthesis/demonstration_library.hpp"
#include "motion/synthesis/phase_trajectory.hpp"
#include "motion/synthesis/pose_features.hpp"

namespace deixis::physics {

class BaseMotion {
  public:
    /// The mean of demonstrations on that skeleton, those of the left hand mirrored. At least one.
    [[nodiscard]] static BaseMotion meanOf(const motion::PoseFeatures& features,
                                           const std::vector<motion::Demonstration>& demonstrations);
    /// `coefficients` as trajectoryAt() takes them, of a gesture with the right hand.
    BaseMotion(motion::PoseFeatures features, std::vector<double> coefficients);

    [[nodiscard]] const std::vector<double>& coefficients() const { return coefficients_; }
    /// The whole pose. Joints that the body has, too, are the mean's: applyAngles() replaces them.
    [[nodiscard]] motion::LocalPose pose(motion::Side hand, double time_s,
                                         const motion::PhaseDurations& durations) const;

  private:
    motion::PoseFeatures features_;
    std::vector<double> coefficients_;
    std::vector<int> partners_;
};

}  // namespace deixis::physics
