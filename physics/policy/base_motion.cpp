#include "physics/policy/base_motion.hpp"

#include <utility>

#include "motion/skeleton/clip_edit.hpp"

namespace deixis::physics {

BaseMotion::BaseMotion(motion::PoseFeatures features, std::vector<double> coefficients)
    : features_(std::move(features)),
      coefficients_(std::move(coefficients)),
      partners_(motion::mirrorPartners(features_.skeleton())) {}

BaseMotion BaseMotion::meanOf(const motion::PoseFeatures& features,
                              const std::vector<motion::Demonstration>& demonstrations) {
    std::vector<double> sum(features.size() * motion::PhaseTrajectory::coefficient_count, 0.0);
    for (const motion::Demonstration& given : demonstrations) {
        const motion::Demonstration one =
            given.gesture.hand == motion::Side::right ? given : motion::mirrored(given);
        const motion::Clip& clip = one.gesture.clip;
        const auto fit =
            motion::fitTrajectory(features.encode(clip), clip.frame_time_s,
                                  motion::durationsOf(one.gesture, clip.frameCount(), clip.frame_time_s));
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += fit[i] / static_cast<double>(demonstrations.size());
    }
    return {features, std::move(sum)};
}

motion::LocalPose BaseMotion::pose(motion::Side hand, double time_s,
                                   const motion::PhaseDurations& durations) const {
    motion::LocalPose out = features_.decode(
        motion::trajectoryAt(coefficients_, motion::PhaseTrajectory::aligned(time_s, durations)));
    if (hand == motion::Side::left) out = motion::mirrored(features_.skeleton(), partners_, out);
    return out;
}

}  // namespace deixis::physics
