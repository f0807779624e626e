#include "task_reward.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "studies/observers/observer.hpp"

namespace deixis::learning {

namespace {

/// The layouts "across" and "side-by-side" of pointing2023, and a standing participant's eyes.
constexpr std::array observers_m{Vec3(0.0, 1.65, 3.4), Vec3(-1.2, 1.65, 0.0)};

constexpr double nearest_ball_m = 0.2;
constexpr double farthest_ball_m = 0.4;
constexpr int other_balls = 2;

}  // namespace

std::optional<motion::PointingRay> rayOf(AmpTask task) {
    if (task == AmpTask::observer) return std::nullopt;
    return task == AmpTask::forearm ? motion::PointingRay::forearm : motion::PointingRay::eye_fingertip;
}

std::string rewardName(AmpTask task) {
    const std::string name(taskName(task));
    if (task == AmpTask::forearm) return "Eq. 2";
    return rayOf(task) ? "Eq. 2 by " + name : name;
}

std::vector<Vec3> ballsAround(AmpTask task, const Vec3& target_m, Random& random) {
    std::vector<Vec3> out{target_m};
    if (task != AmpTask::observer) return out;
    while (static_cast<int>(out.size()) <= other_balls) {
        Vec3 away_m;
        for (int axis = 0; axis < 3; ++axis) away_m[axis] = random.uniform(-farthest_ball_m, farthest_ball_m);
        const double distance_m = glm::length(away_m);
        if (distance_m >= nearest_ball_m && distance_m <= farthest_ball_m) out.push_back(target_m + away_m);
    }
    return out;
}

double taskReward(AmpTask task, const motion::Skeleton& skeleton, const motion::HumanoidMap& map,
                  const std::vector<Pose>& world, motion::Side hand, const std::vector<Vec3>& balls_m) {
    if (const auto ray = rayOf(task))
        return motion::pointingReward(motion::pointingRay(skeleton, map, world, hand, *ray), balls_m.front());
    const studies::ObserverModel two_cues;
    studies::SeenArm seen{studies::armLines(skeleton, map, world, hand, two_cues.reading), {}};
    double chance = 0.0;
    for (const Vec3& eye_m : observers_m) {
        seen.observer_eye = eye_m;
        chance += studies::ballChance(two_cues, seen, balls_m, 0) / observers_m.size();
    }
    return motion::highest_pointing_reward * chance;
}

}  // namespace deixis::learning
