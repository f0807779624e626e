#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "learning/training/training.hpp"
#include "motion/pointing/accuracy.hpp"
#include "motion/pointing/phases.hpp"
#include "motion/skeleton/kinematics.hpp"

namespace deixis::learning {

namespace {

using motion::Demonstration;
using motion::GeneratedClip;
using motion::HumanoidMap;

/// A clip with what is measured of it.
struct Played {
    explicit Played(const GeneratedClip& clip)
        : made(clip), map(motion::mapByVrmNames(clip.clip.skeleton)), world(motion::worldPoses(clip.clip)) {}

    [[nodiscard]] const Vec3& place(motion::Bone bone, std::size_t frame) const {
        return world[frame][static_cast<std::size_t>(map[bone])].position;
    }
    [[nodiscard]] double jerk() const {
        const auto values =
            motion::magnitudes(motion::jointTrajectory(world, map[motion::armBones(made.hand).hand]),
                               made.clip.frame_time_s, motion::Derivative::jerk);
        return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    }
    /// How much higher a hand is at the end than when it began.
    [[nodiscard]] double endHeight_m(motion::Bone hand) const {
        return place(hand, world.size() - 1).y - place(hand, 0).y;
    }
    [[nodiscard]] bool endsAtRest() const {
        constexpr double near_m = 0.03;
        return std::abs(endHeight_m(motion::Bone::leftHand)) < near_m &&
               std::abs(endHeight_m(motion::Bone::rightHand)) < near_m;
    }

    const GeneratedClip& made;
    HumanoidMap map;
    std::vector<std::vector<Pose>> world;
};

/// Over the frames that both have.
double armError_m(const Played& made, const Played& demonstrated) {
    const auto& arm = motion::armBones(demonstrated.made.hand);
    const std::size_t frames = std::min(made.world.size(), demonstrated.world.size());
    double sum_m = 0.0;
    for (std::size_t f = 0; f < frames; ++f)
        for (const motion::Bone bone : {arm.lower_arm, arm.hand})
            sum_m += glm::distance(made.place(bone, f), demonstrated.place(bone, f));
    return sum_m / (2.0 * static_cast<double>(frames));
}

/// Sums over clips.
class Sums {
  public:
    explicit Sums(const PoseReward& reward) : reward_(reward) {}

    void add(const Played& clip, const Vec3& target_m) {
        const auto& made = clip.made;
        const int peak = made.peak_frame;
        if (reward_)
            sum_.reward += reward_(made.clip.skeleton, clip.map, clip.world[static_cast<std::size_t>(peak)],
                                   made.hand, target_m);
        if (const auto arm = motion::armTrack(clip.world, clip.map, made.hand, made.clip.frame_time_s))
            if (const auto accuracy = motion::pointingAccuracy(*arm, target_m, peak, {})) {
                if (!reward_) sum_.reward += accuracy->reward;
                sum_.error_rad += accuracy->error_rad;
                ++pointing_;
            }
        sum_.at_rest += clip.endsAtRest() ? 1.0 : 0.0;
        sum_.end_height_m += clip.endHeight_m(motion::armBones(made.hand).hand);
        sum_.jerk_ratio += clip.jerk();
        ++clips_;
    }
    void addArmError(double error_m) { sum_.arm_error_m += error_m; }

    [[nodiscard]] ClipMeasures means(double demonstrated_jerk) const {
        ClipMeasures out = sum_;
        for (double* of_all :
             {&out.reward, &out.at_rest, &out.end_height_m, &out.jerk_ratio, &out.arm_error_m})
            *of_all /= clips_;
        out.error_rad /= std::max(1.0, pointing_);
        out.jerk_ratio /= demonstrated_jerk;
        return out;
    }

  private:
    const PoseReward& reward_;
    ClipMeasures sum_;
    double clips_ = 0.0;
    double pointing_ = 0.0;
};

}  // namespace

double ClipMeasures::score(bool can_know_end) const {
    return reward - (can_know_end ? 0.3 * (1.0 - at_rest) : 0.0) - 0.05 * std::max(0.0, jerk_ratio - 1.5);
}

ClipMeasures measureGenerated(const motion::Generator& system,
                              const std::vector<Demonstration>& demonstrations, std::uint64_t seed,
                              const PoseReward& reward) {
    Sums sums(reward);
    for (const Demonstration& one : demonstrations) {
        const GeneratedClip made = system.generate({"", one.target, seed++, {}});
        const Played played(made);
        sums.add(played, one.target);
        sums.addArmError(armError_m(played, Played(one.gesture)));
    }
    return sums.means(meanJerk(demonstrations));
}

ClipMeasures measureAtTargets(const motion::Generator& system, const std::vector<Vec3>& targets_m,
                              double demonstrated_jerk, std::uint64_t seed, const PoseReward& reward) {
    Sums sums(reward);
    for (const Vec3& target_m : targets_m) {
        const GeneratedClip made = system.generate({"", target_m, seed++, {}});
        sums.add(Played(made), target_m);
    }
    return sums.means(demonstrated_jerk);
}

double meanJerk(const std::vector<Demonstration>& demonstrations) {
    double sum = 0.0;
    for (const Demonstration& one : demonstrations) sum += Played(one.gesture).jerk();
    return sum / static_cast<double>(demonstrations.size());
}

}  // namespace deixis::learning
