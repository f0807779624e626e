#include "motion/unit_gestures/unit_gesture.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "assets/data/unit_gestures.hpp"
#include "motion/skeleton/minimum_jerk.hpp"
#include "motion/unit_gestures/gesture_variation.hpp"
#include "paths.hpp"

using namespace deixis;
using namespace deixis::motion;
using doctest::Approx;

namespace {

const GestureLibrary& shipped() {
    static const GestureLibrary library =
        assets::loadUnitGestures(tests::sourceDir() / "assets/data/unit_gestures.toml").value();
    return library;
}

Vec3 wristOf(const UpperBodyPose& pose, UpperJoint shoulder, UpperJoint wrist) {
    const UpperBodyJoints joints = jointsOf(pose);
    return joints[static_cast<std::size_t>(wrist)] - joints[static_cast<std::size_t>(shoulder)];
}

double farthest(const UpperBodyPose& a, const UpperBodyPose& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < upper_bone_count; ++i)
        most = std::max(most, degreesFromRadians(angleBetween(a.directions[i], b.directions[i])));
    return most;
}

UnitGesture lift() {
    UnitGesture gesture;
    gesture.id = gesture.name = gesture.meaning = "lift";
    gesture.keys.resize(4);
    const auto key = [&](std::size_t k, double t, GesturePhase phase, const ChannelValues& hand) {
        gesture.keys[k] = {t, phase, false, {}};
        gesture.keys[k].channels[indexOf(Channel::right_hand)] = hand;
    };
    key(1, 0.4, GesturePhase::preparation, {0.0, -0.5, 0.5, 0.0});
    key(2, 0.7, GesturePhase::stroke, {0.3, 0.2, 0.6, 20.0});
    gesture.keys[3] = {1.5, GesturePhase::retraction, false, {}};
    return gesture;
}

}  // namespace

TEST_SUITE("motion/unit_gesture") {
    TEST_CASE("A wrist is where it is asked for, on either side; the relaxed target is the relaxed pose") {
        CHECK(farthest(poseOf(relaxedTarget()), relaxedUpperBody()) < 0.01);
        BodyTarget target = relaxedTarget();
        target[indexOf(Channel::right_hand)] = {0.3, 0.2, 0.6, 20.0};
        target[indexOf(Channel::left_hand)] = {0.1, -0.4, 0.5, -10.0};
        const UpperBodyPose pose = poseOf(target);
        const Vec3 right = wristOf(pose, UpperJoint::right_shoulder, UpperJoint::right_wrist);
        CHECK(glm::length(right - 0.69 * Vec3(-0.3, 0.2, 0.6)) < 1e-6);
        const Vec3 left = wristOf(pose, UpperJoint::left_shoulder, UpperJoint::left_wrist);
        CHECK(glm::length(left - 0.69 * Vec3(0.1, -0.4, 0.5)) < 1e-6);
    }

    TEST_CASE("The swivel takes the elbow out and up, and leaves the wrist") {
        BodyTarget target = relaxedTarget();
        auto& hand = target[indexOf(Channel::right_hand)];
        hand = {0.0, -0.3, 0.55, 0.0};
        const UpperBodyPose low = poseOf(target);
        hand[3] = 60.0;
        const UpperBodyPose high = poseOf(target);
        const Vec3 a = low[UpperBone::right_upper_arm], b = high[UpperBone::right_upper_arm];
        CHECK(b.y > a.y + 0.2);
        CHECK(b.x < a.x - 0.2);
        CHECK(glm::length(wristOf(low, UpperJoint::right_shoulder, UpperJoint::right_wrist) -
                          wristOf(high, UpperJoint::right_shoulder, UpperJoint::right_wrist)) < 1e-6);
    }

    TEST_CASE("Head and trunk turn as they are told, shoulders rise") {
        BodyTarget target = relaxedTarget();
        target[indexOf(Channel::head)] = {30.0, 0.0, 0.0, 0.0};
        CHECK(poseOf(target)[UpperBone::nose].x > 0.2);
        target[indexOf(Channel::head)] = {0.0, 20.0, 0.0, 0.0};
        CHECK(poseOf(target)[UpperBone::nose].y < relaxedUpperBody()[UpperBone::nose].y - 0.1);
        target = relaxedTarget();
        target[indexOf(Channel::trunk)] = {0.0, 20.0, 0.0, 15.0};
        const UpperBodyPose pose = poseOf(target);
        CHECK(degreesFromRadians(angleBetween(pose[UpperBone::neck], relaxedUpperBody()[UpperBone::neck])) ==
              Approx(20.0));
        CHECK(pose[UpperBone::neck].z > 0.3);
        CHECK(pose[UpperBone::left_shoulder].y > relaxedUpperBody()[UpperBone::left_shoulder].y + 0.1);
    }

    TEST_CASE("Between keys a channel goes by minimum jerk; through a key it does not stop") {
        const ChannelKeys keys{{1.0, {0, 0, 0, 0}, false}, {2.0, {1, 2, 0, 0}, false}};
        CHECK(valuesAt(keys, 0.0) == keys[0].values);
        CHECK(valuesAt(keys, 9.0) == keys[1].values);
        for (const double u : {0.1, 0.5, 0.8})
            CHECK(valuesAt(keys, 1.0 + u)[1] == Approx(2.0 * minimumJerk(u)));
        ChannelKeys three{{0.0, {0}, false}, {1.0, {1}, true}, {2.0, {2}, false}};
        const auto speedAt = [&](double t) {
            return (valuesAt(three, t + 1e-4)[0] - valuesAt(three, t - 1e-4)[0]) / 2e-4;
        };
        CHECK(valuesAt(three, 1.0)[0] == 1.0);
        CHECK(speedAt(0.9999) == Approx(1.0).epsilon(0.01));
        CHECK(speedAt(1.0001) == Approx(1.0).epsilon(0.01));
        three[1].through = false;
        CHECK(std::abs(speedAt(1.0)) < 0.01);
    }

    TEST_CASE("What is no gesture is refused, the key named") {
        CHECK(checkGesture(lift()).has_value());
        auto gesture = lift();
        gesture.keys[2].time_s = 0.3;
        CHECK(checkGesture(gesture).error().where == "key 2");
        gesture = lift();
        gesture.keys[1].channels[0] = ChannelValues{0.9, 0.9, 0.0, 0.0};
        CHECK(checkGesture(gesture).error().message.find("1.27 arm lengths") != std::string::npos);
        gesture = lift();
        gesture.keys[1].channels[indexOf(Channel::head)] = ChannelValues{150.0, 0.0, 0.0, 0.0};
        CHECK(checkGesture(gesture).error().message.find("150 degrees") != std::string::npos);
        gesture = lift();
        gesture.keys[3].channels = gesture.keys[2].channels;
        CHECK(checkGesture(gesture).error().where == "key 3");
        gesture.blended = true;
        CHECK(checkGesture(gesture).has_value());
        gesture = lift();
        gesture.keys[2].phase = GesturePhase::hold;
        CHECK(checkGesture(gesture).error().message.find("no stroke") != std::string::npos);
        gesture.keys.clear();
        CHECK_FALSE(checkGesture(gesture).has_value());
    }

    TEST_CASE("The shipped library has the gestures of every class that the design names") {
        CHECK(shipped().size() >= 33);
        std::array<int, gesture_class_count> count{};
        for (const UnitGesture& gesture : shipped()) ++count[static_cast<std::size_t>(gesture.gesture_class)];
        for (const int of_class : count) CHECK(of_class >= 5);
        for (const char* id : {"raise_both", "point_right", "frame", "shrug", "nod"})
            CHECK(findGesture(shipped(), id) != nullptr);
        CHECK(findGesture(shipped(), "sing") == nullptr);
    }

    TEST_CASE("Every gesture begins and ends relaxed, unless it is to be blended, and no hand is too fast") {
        for (const UnitGesture& gesture : shipped()) {
            CAPTURE(gesture.id);
            const UpperBodyMotion motion = motionOf(gesture);
            CHECK(std::abs(static_cast<double>(motion.frames.size() - 1) / 15.0 - gesture.duration_s()) <
                  0.04);
            if (!gesture.blended) {
                CHECK(farthest(motion.frames.front(), relaxedUpperBody()) < 0.01);
                CHECK(farthest(motion.frames.back(), relaxedUpperBody()) < 0.01);
            }
            double fastest = 0.0, moved = 0.0;
            for (std::size_t f = 1; f < motion.frames.size(); ++f) {
                const UpperBodyJoints a = jointsOf(motion.frames[f - 1]), b = jointsOf(motion.frames[f]);
                for (const std::size_t wrist : {6, 9})
                    fastest = std::max(fastest, 15.0 * glm::length(b[wrist] - a[wrist]));
                moved = std::max(moved, farthest(motion.frames[f], relaxedUpperBody()));
                for (const Vec3& d : motion.frames[f].directions)
                    CHECK(glm::length(d) == Approx(1.0).epsilon(1e-12));
            }
            CHECK(fastest < 3.0);
            CHECK(moved > 8.0);
            CHECK(gesture.strokeBegin_s() < gesture.apex_s());
            CHECK(gesture.apex_s() <= gesture.strokeEnd_s());
        }
    }

    TEST_CASE("Faster gestures go through the same postures, in fewer frames") {
        for (const UnitGesture& gesture : shipped()) {
            const BodyTrack track = trackOf(gesture);
            const UpperBodyMotion motion = motionOf(gesture, 3.0);
            CHECK(std::abs(static_cast<double>(motion.frames.size() - 1) / 5.0 - gesture.duration_s()) <
                  0.11);
            const std::size_t middle = motion.frames.size() / 2;
            const double time_s = gesture.duration_s() * static_cast<double>(middle) /
                                  static_cast<double>(motion.frames.size() - 1);
            CHECK(farthest(motion.frames[middle], poseOf(targetAt(track, time_s))) < 1e-6);
        }
    }

    TEST_CASE("A gesture for the other hand is the mirror image") {
        for (const UnitGesture& gesture : shipped()) {
            const UpperBodyMotion expected = mirrored(motionOf(gesture));
            const UpperBodyMotion found = motionOf(mirrored(gesture));
            for (std::size_t f = 0; f < expected.frames.size(); ++f)
                CHECK(farthest(found.frames[f], expected.frames[f]) < 1e-6);
        }
        CHECK(mirrored(lift()).uses(Channel::left_hand));
        CHECK_FALSE(mirrored(lift()).uses(Channel::right_hand));
    }

    TEST_CASE("A variation is larger about its own middle and moved, within the arm's reach") {
        const UnitGesture other = varied(lift(), 2.0, Vec3(0.0, 0.1, 0.0));
        const ChannelValues first = *other.keys[1].channels[0];
        CHECK(first[0] == Approx(-0.15));
        CHECK(first[1] == Approx(-0.75));
        CHECK(first[2] == Approx(0.45));
        const ChannelValues wide = *varied(lift(), 8.0, Vec3(0.0)).keys[2].channels[0];
        CHECK(std::hypot(wide[0], wide[1], wide[2]) == Approx(0.985));
        CHECK(checkGesture(smallNod(5.0)).has_value());
    }
}
