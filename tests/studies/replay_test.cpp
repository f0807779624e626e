#include "studies/session/replay.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include "motion/humanoid/reference_humanoid.hpp"
#include "studies/study_file/standing.hpp"

using namespace deixis;
using namespace deixis::studies;

namespace {

/// One clip for everything: the right hand's joint turns by one radian in a second.
class OneClip : public ClipSource {
  public:
    OneClip() : idle(motion::relaxedPose(motion::referenceHumanoid())) {
        clip_.skeleton = motion::referenceHumanoid();
        clip_.frame_time_s = 0.1;
        for (int i = 0; i <= 10; ++i) {
            clip_.frames.push_back(idle);
            clip_.frames.back().joints[0].position.y += 0.1 * i;
        }
    }
    [[nodiscard]] const motion::Clip& clip(const Stimulus&) const override { return clip_; }
    motion::LocalPose idle;

  private:
    motion::Clip clip_;
};

TrackingSample sampleAt(double time_s, const Vec3& head, const Ray& right, const Ray& left) {
    const auto aimed = [](const Ray& ray) {
        TrackedPose pose;
        pose.stage_from_device = {ray.origin, rotationBetween(Vec3(0.0, 0.0, -1.0), ray.direction)};
        pose.position_valid = pose.orientation_valid = pose.tracked = true;
        return pose;
    };
    TrackingSample sample;
    sample.display_time_s = time_s;
    sample.head = aimed({head, Vec3(0.0, 0.0, -1.0)});
    sample.aim = {aimed(left), aimed(right)};
    return sample;
}

/// Three balls in a row 2 m before the participant, who stands at (0, 3) and looks along -z. The clip plays
/// from 10 to 11 s, the answer (place 1) comes at 12 s. The left hand points at it, the right one hangs.
RecordedTrial game() {
    RecordedTrial recorded;
    recorded.trial.kind = StageKind::game;
    recorded.trial.stimuli = {{"direct", "T001"}};
    recorded.trial.target = {0.0, 1.0, 1.0};
    recorded.trial.distractors = {{-0.4, 1.0, 1.0}, {0.4, 1.0, 1.0}};
    recorded.trial.ball_order = {1, 0, 2};
    recorded.layout = {"across", 0.0, 3.0, 180.0};
    recorded.plays = {{0, 10.0, 11.0}};
    recorded.open_s = 11.0;
    recorded.answered_s = 12.0;
    recorded.values = {{"chosen_place", 1, {}}};
    recorded.pointer = Ray{{0.0, 1.0, 2.5}, {0.0, 0.0, -1.0}};
    const Ray hanging{{0.3, 0.8, 2.8}, {0.0, -1.0, 0.0}};
    for (int i = 0; i <= 30; ++i) {
        const double time_s = 9.5 + 0.1 * i;
        recorded.tracking.push_back(
            sampleAt(time_s, {0.01 * i, 1.6, 3.0}, hanging, Ray{{0.0, 1.0, 2.5}, {0.0, 0.0, -1.0}}));
    }
    return recorded;
}

}  // namespace

TEST_SUITE("studies/replay") {
    TEST_CASE("A ray gives the ball that it meets first, and none where it meets none") {
        RecordedTrial recorded = game();
        const auto from = [](double x) { return Ray{{x, 1.0, 3.0}, {0.0, 0.0, -1.0}}; };
        CHECK(ballMetBy(recorded, from(-0.4)) == 0);
        CHECK(ballMetBy(recorded, from(0.0)) == 1);
        CHECK(ballMetBy(recorded, from(0.4)) == 2);
        CHECK(ballMetBy(recorded, from(0.2)) == -1);
        CHECK(ballMetBy(recorded, {{0.0, 1.0, 3.0}, {0.0, 0.0, 1.0}}) == -1);
        // From the side all three stand in one line: the nearest is met.
        CHECK(ballMetBy(recorded, {{2.0, 1.0, 1.0}, {-1.0, 0.0, 0.0}}) == 2);
        CHECK(ballMetBy(recorded, {{-2.0, 1.0, 1.0}, {1.0, 0.0, 0.0}}) == 0);
        // However far away they are.
        CHECK(ballMetBy(recorded, {{0.0, 1.0, 12.0}, {0.0, 0.0, -1.0}}) == 1);
    }

    TEST_CASE("A ray is drawn up to the ball that it meets, and five metres where it meets none") {
        const OneClip clips;
        const motion::Skeleton avatar = motion::referenceHumanoid();
        for (const bool meets : {true, false}) {
            RecordedTrial recorded = game();
            for (TrackingSample& sample : recorded.tracking)
                sample.aim[0].stage_from_device.position = {meets ? 0.0 : 0.2, 1.0, 9.0};
            recorded.pointer = Ray{{0.0, 1.0, 9.0}, {0.0, 0.0, -1.0}};
            const PresentedFrame frame = TrialReplay(recorded, clips, avatar, clips.idle).at(11.5);
            REQUIRE(frame.ray.has_value());
            CHECK(frame.ray->length_m == doctest::Approx(meets ? 7.95 : 5.0));
            CHECK(frame.balls[1].look == (meets ? BallLook::hovered : BallLook::selectable));
        }
    }

    TEST_CASE("Balls look as they did: black, then white, lit by the hand that pointed, then chosen") {
        const OneClip clips;
        const RecordedTrial recorded = game();
        const motion::Skeleton avatar = motion::referenceHumanoid();
        const TrialReplay replay(recorded, clips, avatar, clips.idle);
        CHECK(replay.begin_s() <= 9.5);
        CHECK(replay.end_s() > 12.0);
        const auto looks = [&](double time_s) {
            std::vector<BallLook> out;
            for (const BallView& ball : replay.at(time_s).balls) out.push_back(ball.look);
            return out;
        };
        using enum BallLook;
        CHECK(looks(10.5) == std::vector{waiting, waiting, waiting});
        CHECK(looks(11.5) == std::vector{selectable, hovered, selectable});
        CHECK(looks(12.1) == std::vector{selectable, chosen, selectable});
        CHECK_FALSE(replay.at(10.5).ray.has_value());
        REQUIRE(replay.at(11.5).ray.has_value());
        CHECK(replay.at(11.5).ray->length_m == doctest::Approx(2.5 - 1.0 - 0.05));
        CHECK(replay.at(11.5).stage_from_viewer.position == Vec3(0.0, 0.0, 3.0));
    }

    TEST_CASE("The avatar is at ease before its clip, plays it in its own time, and holds the end") {
        const OneClip clips;
        const RecordedTrial recorded = game();
        const motion::Skeleton avatar = motion::referenceHumanoid();
        const TrialReplay replay(recorded, clips, avatar, clips.idle);
        const auto lifted = [&](double time_s) {
            return replay.at(time_s).avatar_joints[0].position.y - replay.at(8.0).avatar_joints[0].position.y;
        };
        CHECK(lifted(9.5) == doctest::Approx(0.0));
        CHECK(lifted(10.35) == doctest::Approx(0.35));
        CHECK(lifted(10.9) == doctest::Approx(0.9));
        CHECK(lifted(11.7) == doctest::Approx(1.0));
    }

    TEST_CASE("Head and hand lie between the samples around them, and are nowhere where there are none") {
        const OneClip clips;
        RecordedTrial recorded = game();
        const motion::Skeleton avatar = motion::referenceHumanoid();
        recorded.tracking.erase(recorded.tracking.begin() + 10, recorded.tracking.begin() + 15);
        recorded.tracking[3].head.position_valid = false;
        const TrialReplay replay(recorded, clips, avatar, clips.idle);
        REQUIRE(replay.head(9.55).has_value());
        CHECK(replay.head(9.55)->position.x == doctest::Approx(0.005));
        CHECK_FALSE(replay.head(9.0).has_value());
        CHECK_FALSE(replay.head(13.0).has_value());
        CHECK_FALSE(replay.head(9.75).has_value());        // beside a sample that was not tracked
        CHECK_FALSE(replay.head(10.7).has_value());        // in a gap of 0.6 s
        CHECK(replay.headTrail(10.35, 0.55).size() == 5);  // 9.8 is not tracked, 9.9 to 10.3 are five
        CHECK(replay.handTrail(12.4, 0.35).size() == 4);
    }

    TEST_CASE("A tracked hand still meets the small ball that it met, though its rotation was rounded") {
        // A choice of a session at the desktop: the ray passes the ball's centre by 5 mm, and the rotation as
        // it was kept is a few parts in 100,000 too short.
        const OneClip clips;
        RecordedTrial recorded = game();
        recorded.ball_diameter_m = 0.07;
        recorded.trial.target = {1.2261, 0.2970, 1.8032};
        recorded.trial.distractors = {{1.4335, 0.2798, 1.2846}, {1.3351, 0.5028, 1.3880}};
        recorded.trial.ball_order = {0, 1, 2};
        recorded.pointer = Ray{{-0.6561004, 1.37, -0.6727767}, {0.5728889, -0.3250020, 0.7524441}};
        TrackedPose& right = recorded.tracking[25].aim[1];
        right.stage_from_device = {{-0.656097412109375, 1.3699951171875, -0.6727752685546875},
                                   {-0.315277099609375, 0.05267333984375, 0.9345703125, 0.156097412109375}};
        const double at_s = recorded.tracking[25].display_time_s;
        recorded.answered_s = at_s;
        const motion::Skeleton avatar = motion::referenceHumanoid();
        const auto ray = TrialReplay(recorded, clips, avatar, clips.idle).pointer(at_s);
        REQUIRE(ray.has_value());
        CHECK(ballMetBy(recorded, *recorded.pointer) == 0);
        CHECK(ballMetBy(recorded, *ray) == 0);
    }

    TEST_CASE("Of a pair each avatar stands on its side and moves with its own plays") {
        const OneClip clips;
        RecordedTrial recorded = game();
        recorded.trial.kind = StageKind::pairwise;
        recorded.trial.stimuli = {{"direct", "T001"}, {"stiff", "T001"}};
        recorded.trial.ball_order.clear();
        recorded.plays = {{0, 10.0, 11.0}, {1, 11.5, 12.5}};
        recorded.answered_s = 14.0;
        const motion::Skeleton avatar = motion::referenceHumanoid();
        const TrialReplay replay(recorded, clips, avatar, clips.idle);
        const auto frame = replay.at(11.2);
        REQUIRE(frame.right_avatar_joints.size() == frame.avatar_joints.size());
        // The participant looks along -z from +z: their right is +x.
        CHECK(frame.right_avatar_joints[0].position.x - frame.avatar_joints[0].position.x ==
              doctest::Approx(1.2));
        CHECK(frame.avatar_joints[0].position.y - frame.right_avatar_joints[0].position.y ==
              doctest::Approx(1.0));
        const auto later = replay.at(12.0);
        CHECK(later.right_avatar_joints[0].position.y - frame.right_avatar_joints[0].position.y ==
              doctest::Approx(0.5));
    }

    TEST_CASE("A play of a stimulus that the trial lacks is rejected") {
        const OneClip clips;
        RecordedTrial recorded = game();
        recorded.plays.push_back({3, 11.0, {}});
        const motion::Skeleton avatar = motion::referenceHumanoid();
        CHECK_THROWS_AS(TrialReplay(recorded, clips, avatar, clips.idle), std::invalid_argument);
    }

    TEST_CASE("A layout's place looks where its heading says, and a pair stands across that line") {
        const Pose across = viewerPose({"across", 0.5, 3.0, 180.0});
        CHECK(across.position == Vec3(0.5, 0.0, 3.0));
        const Vec3 forward = across.orientation * Vec3(0.0, 0.0, -1.0);
        CHECK(glm::length(forward - Vec3(0.0, 0.0, -1.0)) < 1e-9);
        const Pose beside = viewerPose({"beside", -0.6, -0.95, 15.0});
        const Vec3 ahead = beside.orientation * Vec3(0.0, 0.0, -1.0);
        CHECK(degreesFromRadians(std::atan2(ahead.x, ahead.z)) == doctest::Approx(15.0));
        const auto places = pairPlaces(across);
        CHECK(glm::length(places[1] - Vec3(0.6, 0.0, 0.0)) < 1e-9);
        CHECK(glm::length(places[0] + places[1]) < 1e-9);
    }
}
