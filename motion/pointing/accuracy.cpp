#include "motion/pointing/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "motion/pointing/phases.hpp"
#include "motion/pointing/rays.hpp"
#include "motion/skeleton/kinematics.hpp"

namespace deixis::motion {

Result<ArmTrack> armTrack(const std::vector<std::vector<Pose>>& world, const HumanoidMap& map, Side side,
                          double frame_time_s) {
    const ArmBones bones = armBones(side);
    ArmTrack arm{side, frame_time_s, jointTrajectory(world, map[bones.lower_arm]),
                 jointTrajectory(world, map[bones.hand])};
    for (std::size_t f = 0; f < arm.hand.size(); ++f)
        if (!(glm::length(arm.hand[f] - arm.elbow[f]) > 1e-6))
            return fail("", "the " + std::string(sideName(side)) + " forearm has no length in frame " +
                                std::to_string(f) + ": it points nowhere");
    return arm;
}

std::vector<double> pointingRewards(const ArmTrack& arm, const Vec3& target) {
    std::vector<double> rewards;
    rewards.reserve(arm.hand.size());
    for (std::size_t f = 0; f < arm.hand.size(); ++f)
        rewards.push_back(pointingReward(arm.elbow[f], arm.hand[f], target));
    return rewards;
}

std::optional<PointingAccuracy> pointingAccuracy(const ArmTrack& arm, const Vec3& target, int pointing_frame,
                                                 const AccuracyRule& rule) {
    const std::vector<double> speed = speeds(arm.hand, arm.frame_time_s);
    // A frame that lies on the window's end by the numbers must not fall out by rounding.
    const int reach = static_cast<int>(std::floor(0.5 * rule.window_s / arm.frame_time_s + 1e-6));
    const int first = std::max(0, pointing_frame - reach);
    const int last = std::min(static_cast<int>(arm.hand.size()) - 1, pointing_frame + reach);
    std::optional<PointingAccuracy> best;
    for (int frame = first; frame <= last; ++frame) {
        const auto f = static_cast<std::size_t>(frame);
        if (!(speed[f] < rule.slower_than_m_s)) continue;
        const double reward = pointingReward(arm.elbow[f], arm.hand[f], target);
        if (!best || reward > best->reward)
            best = PointingAccuracy{reward, angleBetween(target - arm.hand[f], arm.hand[f] - arm.elbow[f]),
                                    frame};
    }
    return best;
}

PointingProfile pointingProfile(const ArmTrack& arm, const Vec3& target, int pointing_frame, double from_s,
                                double to_s, double step_s) {
    const std::vector<double> speed = speeds(arm.hand, arm.frame_time_s);
    const std::vector<double> rewards = pointingRewards(arm, target);
    const auto last_frame = static_cast<double>(arm.hand.size() - 1);
    PointingProfile profile;
    const int last_step = static_cast<int>(std::floor(to_s / step_s + 1e-9));
    for (int step = static_cast<int>(std::ceil(from_s / step_s - 1e-9)); step <= last_step; ++step) {
        const double at = pointing_frame + step * step_s / arm.frame_time_s;
        if (at < -1e-9 || at > last_frame + 1e-9) continue;
        if (profile.reward.empty()) profile.first_step = step;
        const double within = std::clamp(at, 0.0, last_frame);
        const auto below = static_cast<std::size_t>(within);
        const std::size_t above = std::min(below + 1, arm.hand.size() - 1);
        const double share = within - static_cast<double>(below);
        const auto between = [&](const std::vector<double>& values) {
            return values[below] + share * (values[above] - values[below]);
        };
        profile.reward.push_back(between(rewards));
        profile.speed_m_s.push_back(between(speed));
    }
    return profile;
}

}  // namespace deixis::motion
