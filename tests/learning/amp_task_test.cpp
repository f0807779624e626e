// What AMP rewards as its task, and demonstrations as ones for what they do point at: against the pointing
// geometry, the observers and hand-worked cases.
#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "hindsight_targets.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/skeleton/kinematics.hpp"
#include "small_trainings.hpp"
#include "studies/observers/observer.hpp"
#include "task_reward.hpp"

using namespace deixis;
using namespace deixis::learning;
using motion::PointingRay;

namespace {

/// A demonstration in the middle of its hold.
struct Held {
    explicit Held(const motion::Demonstration& demonstration)
        : one(demonstration),
          skeleton(one.gesture.clip.skeleton),
          map(motion::mapByVrmNames(skeleton)),
          world(motion::worldPose(skeleton, one.gesture.clip.frames[static_cast<std::size_t>(
                                                (one.gesture.peak_frame + one.gesture.hold_frame) / 2)])) {}

    [[nodiscard]] Ray ray(PointingRay kind) const {
        return motion::pointingRay(skeleton, map, world, one.gesture.hand, kind);
    }
    [[nodiscard]] double reward(AmpTask task, const std::vector<Vec3>& balls_m) const {
        return taskReward(task, skeleton, map, world, one.gesture.hand, balls_m);
    }

    const motion::Demonstration& one;
    const motion::Skeleton& skeleton;
    motion::HumanoidMap map;
    std::vector<Pose> world;
};

}  // namespace

TEST_SUITE("learning/amp_task") {
    TEST_CASE("the forearm's reward is Equation 2, and that of eye and fingertip the same of their line") {
        for (const motion::Demonstration& one : tests::fewDemonstrations().training) {
            const Held held(one);
            const auto& arm = motion::armBones(one.gesture.hand);
            const auto place = [&](motion::Bone bone) {
                return held.world[static_cast<std::size_t>(held.map[bone])].position;
            };
            CHECK(held.reward(AmpTask::forearm, {one.target}) ==
                  doctest::Approx(motion::pointingReward(place(arm.lower_arm), place(arm.hand), one.target)));
            // Half a radian beside the line: (exp(1 - .5/pi) - 1) / e.
            const Ray line = held.ray(PointingRay::eye_fingertip);
            const Vec3 across = studies::acrossRay(line.direction).right;
            const Vec3 beside = line.origin + 2.0 * (std::cos(0.5) * line.direction + std::sin(0.5) * across);
            CHECK(held.reward(AmpTask::eye_fingertip, {beside}) == doctest::Approx(0.484985).epsilon(1e-5));
            CHECK(held.reward(AmpTask::eye_fingertip, {line.origin + line.direction}) ==
                  doctest::Approx(motion::highest_pointing_reward).epsilon(1e-6));
        }
    }

    TEST_CASE("an observer is sure of what is pointed at, and not of what lies beside") {
        Random random(1, "balls");
        for (const motion::Demonstration& one : tests::fewDemonstrations().training) {
            const Held held(one);
            const Vec3 seen_m = held.ray(PointingRay::eye_fingertip).origin +
                                1.5 * held.ray(PointingRay::eye_fingertip).direction;
            const std::vector<Vec3> at{seen_m, seen_m + Vec3(0.4, 0, 0), seen_m + Vec3(0, 0, 0.4)};
            const std::vector<Vec3> beside{at[1], at[0], at[2]};
            const double sure = held.reward(AmpTask::observer, at),
                         unsure = held.reward(AmpTask::observer, beside);
            CHECK(sure > unsure);
            CHECK(unsure >= 0.0);
            CHECK(sure <= motion::highest_pointing_reward);
            // From both places: the chances of the three balls are all there is.
            CHECK(sure + unsure + held.reward(AmpTask::observer, {at[2], at[0], at[1]}) ==
                  doctest::Approx(motion::highest_pointing_reward).epsilon(1e-6));
        }
    }

    TEST_CASE("balls around a target are for an observer alone, 20 to 40 cm away") {
        Random random(2, "balls");
        const Vec3 target_m(0.3, 1.1, 1.9);
        CHECK(ballsAround(AmpTask::forearm, target_m, random) == std::vector{target_m});
        for (int i = 0; i < 200; ++i) {
            const auto balls_m = ballsAround(AmpTask::observer, target_m, random);
            REQUIRE(balls_m.size() == 3);
            CHECK(balls_m[0] == target_m);
            for (int other = 1; other < 3; ++other) {
                const double away_m = glm::distance(balls_m[static_cast<std::size_t>(other)], target_m);
                CHECK(away_m >= 0.2);
                CHECK(away_m <= 0.4);
            }
        }
    }

    TEST_CASE("in hindsight a demonstration was one for what its line points at") {
        const auto& given = tests::fewDemonstrations().training;
        for (const AmpTask task : {AmpTask::forearm, AmpTask::eye_fingertip}) {
            const auto changed = withHindsightTargets(given, task);
            REQUIRE(changed.size() == given.size());
            for (std::size_t i = 0; i < given.size(); ++i) {
                const Held held(changed[i]);
                CHECK(held.reward(task, {changed[i].target}) ==
                      doctest::Approx(motion::highest_pointing_reward).epsilon(1e-6));
                const Vec3 end_m = held.ray(*rayOf(task)).origin;
                CHECK(glm::distance(changed[i].target, end_m) ==
                      doctest::Approx(glm::distance(given[i].target, end_m)));
            }
        }
        const auto observed = withHindsightTargets(given, AmpTask::observer);
        for (std::size_t i = 0; i < given.size(); ++i) CHECK(observed[i].target == given[i].target);
    }
}
