#include "motion/pointing/pointing_accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "motion/pointing/pointing.hpp"

namespace deixis::motion {

namespace {

/// The joints from the root to one of them, root first.
std::vector<int> chainTo(const Skeleton& skeleton, int joint) {
    std::vector<int> chain;
    for (; joint >= 0; joint = skeleton.joints[static_cast<std::size_t>(joint)].parent)
        chain.push_back(joint);
    std::reverse(chain.begin(), chain.end());
    return chain;
}

Vec3 jointPosition(const std::vector<int>& chain, const LocalPose& pose) {
    Pose world;
    for (const int joint : chain) world = world * pose.joints[static_cast<std::size_t>(joint)];
    return world.position;
}

std::string missingBones(const HumanoidMap& map, const ArmBones& arm) {
    std::string names;
    for (const Bone bone : {arm.lower_arm, arm.hand})
        if (!map.has(bone)) names += (names.empty() ? "" : " and ") + std::string(boneName(bone));
    return names;
}

}  // namespace

Result<ArmTrack> armTrack(const Clip& clip, const HumanoidMap& map, Side side, const Placement& placement) {
    const ArmBones bones = armBones(side);
    if (!map.has(bones.lower_arm) || !map.has(bones.hand))
        return fail("",
                    "no joint was found for " + missingBones(map, bones) + ", which pointing is measured by",
                    "Name the joints as one of the known schemes does");
    const std::vector<int> to_elbow = chainTo(clip.skeleton, map[bones.lower_arm]);
    const std::vector<int> to_hand = chainTo(clip.skeleton, map[bones.hand]);
    ArmTrack arm;
    arm.side = side;
    arm.frame_time_s = clip.frame_time_s;
    arm.elbow.reserve(clip.frames.size());
    arm.hand.reserve(clip.frames.size());
    for (const LocalPose& frame : clip.frames) {
        arm.elbow.push_back(transformPoint(placement.stage_from_clip, jointPosition(to_elbow, frame)));
        arm.hand.push_back(transformPoint(placement.stage_from_clip, jointPosition(to_hand, frame)));
        if (!(glm::length(arm.hand.back() - arm.elbow.back()) > 1e-6))
            return fail("", "the " + std::string(sideName(side)) + " forearm has no length in frame " +
                                std::to_string(arm.hand.size() - 1) + ": it points nowhere");
    }
    return arm;
}

namespace {

double sagittalDistance(const Vec3& a, const Vec3& b) {
    return std::hypot(a.y - b.y, a.z - b.z);
}

}  // namespace

int displacementPeak(const ArmTrack& arm) {
    const auto farthest =
        std::max_element(arm.hand.begin(), arm.hand.end(), [&](const Vec3& a, const Vec3& b) {
            return sagittalDistance(a, arm.hand.front()) < sagittalDistance(b, arm.hand.front());
        });
    return static_cast<int>(farthest - arm.hand.begin());
}

double peakDisplacement_m(const ArmTrack& arm) {
    return sagittalDistance(arm.hand[static_cast<std::size_t>(displacementPeak(arm))], arm.hand.front());
}

std::vector<double> handSpeeds(const ArmTrack& arm) {
    const std::size_t n = arm.hand.size();
    std::vector<double> speeds(n, 0.0);
    if (n < 2) return speeds;
    for (std::size_t f = 0; f < n; ++f) {
        const std::size_t before = f == 0 ? 0 : f - 1;
        const std::size_t after = std::min(f + 1, n - 1);
        speeds[f] = glm::length(arm.hand[after] - arm.hand[before]) /
                    (static_cast<double>(after - before) * arm.frame_time_s);
    }
    return speeds;
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
    const std::vector<double> speeds = handSpeeds(arm);
    // A frame that lies on the window's end by the numbers must not fall out by rounding.
    const int reach = static_cast<int>(std::floor(0.5 * rule.window_s / arm.frame_time_s + 1e-6));
    const int first = std::max(0, pointing_frame - reach);
    const int last = std::min(static_cast<int>(arm.hand.size()) - 1, pointing_frame + reach);
    std::optional<PointingAccuracy> best;
    for (int frame = first; frame <= last; ++frame) {
        const auto f = static_cast<std::size_t>(frame);
        if (!(speeds[f] < rule.slower_than_m_s)) continue;
        const double reward = pointingReward(arm.elbow[f], arm.hand[f], target);
        if (!best || reward > best->reward)
            best = PointingAccuracy{reward, angleBetween(target - arm.hand[f], arm.hand[f] - arm.elbow[f]),
                                    frame};
    }
    return best;
}

PointingProfile pointingProfile(const ArmTrack& arm, const Vec3& target, int pointing_frame, double from_s,
                                double to_s, double step_s) {
    const std::vector<double> speeds = handSpeeds(arm);
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
        profile.speed_m_s.push_back(between(speeds));
    }
    return profile;
}

}  // namespace deixis::motion
