#include <algorithm>
#include <cmath>
#include <numeric>

#include "learning/moglow/training.hpp"
#include "motion/pointing/accuracy.hpp"
#include "motion/pointing/phases.hpp"
#include "motion/skeleton/kinematics.hpp"

namespace deixis::learning {

namespace {

using motion::Demonstration;
using motion::GeneratedClip;
using motion::HumanoidMap;
using World = std::vector<std::vector<Pose>>;

double meanJerk(const World& world, const HumanoidMap& map, const GeneratedClip& made) {
    const auto values =
        motion::magnitudes(motion::jointTrajectory(world, map[motion::armBones(made.hand).hand]),
                           made.clip.frame_time_s, motion::Derivative::jerk);
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double rewardOf(const World& world, const HumanoidMap& map, const GeneratedClip& made, const Vec3& target) {
    const auto arm = motion::armTrack(world, map, made.hand, made.clip.frame_time_s);
    if (!arm) return 0.0;
    const auto accuracy = motion::pointingAccuracy(*arm, target, (made.peak_frame + made.hold_frame) / 2, {});
    return accuracy ? accuracy->reward : 0.0;
}

bool endsAtRest(const World& world, const HumanoidMap& map) {
    constexpr double near_m = 0.03;
    return std::ranges::all_of(
        std::array{motion::Bone::leftHand, motion::Bone::rightHand}, [&](motion::Bone bone) {
            const auto joint = static_cast<std::size_t>(map[bone]);
            return std::abs(world.back()[joint].position.y - world.front()[joint].position.y) < near_m;
        });
}

}  // namespace

double MoglowMeasures::score() const {
    return reward - 0.1 * (1.0 - at_rest) - 0.02 * std::max(0.0, jerk_ratio - 1.5);
}

MoglowMeasures measureGenerated(const motion::Generator& system,
                                const std::vector<Demonstration>& demonstrations, std::uint64_t seed) {
    MoglowMeasures out;
    double jerk = 0.0, demonstrated_jerk = 0.0;
    const auto share = 1.0 / static_cast<double>(demonstrations.size());
    for (const Demonstration& one : demonstrations) {
        const GeneratedClip made = system.generate({"", one.target, seed++, {}});
        const HumanoidMap map = motion::mapByVrmNames(made.clip.skeleton);
        const World world = motion::worldPoses(made.clip);
        out.reward += share * rewardOf(world, map, made, one.target);
        out.at_rest += endsAtRest(world, map) ? share : 0.0;
        jerk += meanJerk(world, map, made);
        demonstrated_jerk += meanJerk(motion::worldPoses(one.gesture.clip), map, one.gesture);
    }
    out.jerk_ratio = jerk / demonstrated_jerk;
    return out;
}

}  // namespace deixis::learning
