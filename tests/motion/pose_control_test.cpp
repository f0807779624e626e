// Meeting poses, and motion through keyframes alone.
#include "motion/speech_gestures/pose_control.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

using namespace deixis;
using namespace deixis::motion;

namespace {

/// Forearms that swing, as gestures do.
UpperBodyMotion swinging(int frames) {
    UpperBodyMotion out;
    for (int f = 0; f < frames; ++f) {
        UpperBodyPose pose = relaxedUpperBody();
        const double a = 0.8 + 0.7 * std::sin(0.35 * f) + 0.3 * std::sin(0.11 * f + 1.0);
        const double b = 0.6 + 0.6 * std::sin(0.27 * f + 2.0);
        pose[UpperBone::left_forearm] = {0.3 * std::sin(a), -std::cos(a), std::sqrt(0.91) * std::sin(a)};
        pose[UpperBone::right_forearm] = {-std::sin(b) * 0.6, -std::cos(b), 0.8 * std::sin(b)};
        out.frames.push_back(pose);
    }
    return out;
}

UpperBodyPose raisedBy(UpperBodyPose pose, double angle_rad) {
    const Quat turn = glm::angleAxis(-angle_rad, Vec3(1.0, 0.0, 0.0));
    for (const UpperBone bone : {UpperBone::left_upper_arm, UpperBone::left_forearm})
        pose[bone] = turn * pose[bone];
    return pose;
}

double fastest(const UpperBodyMotion& motion, std::size_t f) {
    double out = 0.0;
    for (std::size_t b = 0; b < upper_bone_count; ++b)
        out = std::max(out, glm::length(motion.frames[f].directions[b] - motion.frames[f - 1].directions[b]));
    return out;
}
double hardest(const UpperBodyMotion& motion, std::size_t f) {
    double out = 0.0;
    for (std::size_t b = 0; b < upper_bone_count; ++b)
        out = std::max(out,
                       glm::length(motion.frames[f + 1].directions[b] - 2.0 * motion.frames[f].directions[b] +
                                   motion.frames[f - 1].directions[b]));
    return out;
}
double at99(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[(values.size() - 1) * 99 / 100];
}

/// First and last frame that differ.
std::pair<std::size_t, std::size_t> changedIn(const UpperBodyMotion& a, const UpperBodyMotion& b) {
    std::pair<std::size_t, std::size_t> out{a.frames.size(), 0};
    for (std::size_t f = 0; f < a.frames.size(); ++f)
        if (a.frames[f] != b.frames[f]) {
            out.first = std::min(out.first, f);
            out.second = f;
        }
    return out;
}

}  // namespace

TEST_SUITE("motion/meet_poses") {
    TEST_CASE("poses are met to the bit, within the motion's own speeds, over half a second or more") {
        const UpperBodyMotion given = swinging(300);
        std::vector<double> speeds, accelerations;
        for (std::size_t f = 1; f < 300; ++f) speeds.push_back(fastest(given, f));
        for (std::size_t f = 1; f < 299; ++f) accelerations.push_back(hardest(given, f));
        std::size_t shortest = 300, longest = 0;
        for (const double angle : {0.05, 0.3, 0.9})
            for (const int frame : {100, 117, 150, 171, 203}) {
                CAPTURE(angle);
                CAPTURE(frame);
                const auto at = static_cast<std::size_t>(frame);
                const UpperBodyPose pose = raisedBy(given.frames[at], angle);
                UpperBodyMotion met = given;
                meetPoses(met, {{frame, pose}});
                CHECK(met.frames[at] == pose);
                const auto [first, last] = changedIn(given, met);
                CHECK(first >= at - 30);
                CHECK(last <= at + 30);
                CHECK(first <= at - 3);
                CHECK(last >= at + 3);
                shortest = std::min(shortest, last - first);
                longest = std::max(longest, last - first);
                // Where a course ends, and where it leaves the pose.
                for (const std::size_t f : {first, last + 1, at, at + 1}) {
                    CHECK(fastest(met, f) <= at99(speeds) * 1.000001);
                    if (f != at)
                        CHECK(hardest(met, f == at + 1 ? f + 1 : f) <= at99(accelerations) * 1.000001);
                }
                for (const UpperBodyPose& one : met.frames)
                    for (const Vec3& direction : one.directions)
                        REQUIRE(glm::length(direction) == doctest::Approx(1.0).epsilon(1e-9));
            }
        CHECK(shortest <= 8);  // half a second
        CHECK(longest > 12);   // large differences take longer
    }

    TEST_CASE("a pose that is there already changes nothing, and none does nothing") {
        UpperBodyMotion motion = swinging(60);
        const UpperBodyMotion given = motion;
        meetPoses(motion, {{20, given.frames[20]}});
        CHECK(motion == given);
        meetPoses(motion, {});
        CHECK(motion == given);
    }

    TEST_CASE("poses near each other, runs of poses, and poses at the ends of the motion are all met") {
        const UpperBodyMotion given = swinging(90);
        std::vector<PoseControl> poses;
        for (const int frame : {0, 1, 2, 30, 34, 35, 36, 60, 89})
            poses.push_back(
                {frame, raisedBy(given.frames[static_cast<std::size_t>(frame)], 0.2 + 0.05 * (frame % 10))});
        std::vector<PoseControl> shuffled(poses.rbegin(), poses.rend());
        UpperBodyMotion met = given;
        meetPoses(met, shuffled);
        for (const PoseControl& one : poses)
            CHECK(met.frames[static_cast<std::size_t>(one.frame)] == one.pose);
        // Between 30 and 34 the difference goes from one to the other and not back to nothing.
        CHECK(angleBetween(met.frames[32][UpperBone::left_upper_arm],
                           given.frames[32][UpperBone::left_upper_arm]) > 0.2);
        // A run of which each pose is further off than the one before is left with that speed.
        UpperBodyMotion run = given;
        meetPoses(run, {poses[4], poses[5], poses[6]});
        const auto off = [&](std::size_t f) {
            return angleBetween(run.frames[f][UpperBone::left_upper_arm],
                                given.frames[f][UpperBone::left_upper_arm]);
        };
        CHECK(off(37) - off(36) > 0.5 * (off(36) - off(35)));
        CHECK(off(37) - off(36) < 1.1 * (off(36) - off(35)));
        UpperBodyMotion single{{relaxedUpperBody()}};
        meetPoses(single, {{0, raisedBy(relaxedUpperBody(), 1.0)}});
        CHECK(single.frames[0] == raisedBy(relaxedUpperBody(), 1.0));
    }
}

TEST_SUITE("motion/keyframes") {
    TEST_CASE("between keyframes runs SciPy's clamped cubic spline, its directions unit length") {
        // SciPy 1.10.1: CubicSpline([0, 7, 12, 20, 29], [0, .5, -.3, .8, .1], bc_type='clamped') at 3, 9, 15,
        // 26
        const double expected[] = {0.254516854037, 0.189459811634, -0.068292589462, 0.327832080811};
        const int at[] = {3, 9, 15, 26};
        const auto pose = [](double y) {
            UpperBodyPose out = relaxedUpperBody();
            out[UpperBone::left_forearm] = Vec3(std::sqrt(1.0 - y * y), y, 0.0);
            return out;
        };
        const auto motion = motionThroughKeyframes(
            {{7, pose(0.5)}, {0, pose(0.0)}, {12, pose(-0.3)}, {20, pose(0.8)}, {29, pose(0.1)}}, 30,
            relaxedUpperBody());
        REQUIRE(motion.frames.size() == 30);
        CHECK(motion.frames[12] == pose(-0.3));
        // The spline of x likewise, so that the ratio is that before the length was set.
        // SciPy: [1, .866025403784, .953939201417, .6, .994987437107] likewise
        const double x[] = {0.942373696252, 0.907102353633, 0.829782468159, 0.891774597735};
        for (int i = 0; i < 4; ++i) {
            const Vec3 found = motion.frames[static_cast<std::size_t>(at[i])][UpperBone::left_forearm];
            CHECK(glm::length(found) == doctest::Approx(1.0));
            CHECK(found.y / found.x == doctest::Approx(expected[i] / x[i]).epsilon(1e-9));
        }
    }

    TEST_CASE("without keyframes at the ends the given pose stands there, and nothing else moves") {
        const UpperBodyPose rest = relaxedUpperBody();
        const auto still = motionThroughKeyframes({}, 10, rest);
        REQUIRE(still.frames.size() == 10);
        for (const UpperBodyPose& pose : still.frames)
            for (std::size_t b = 0; b < upper_bone_count; ++b)
                CHECK(glm::length(pose.directions[b] - rest.directions[b]) < 1e-12);
        const auto one = motionThroughKeyframes({{20, raisedBy(rest, 1.0)}}, 41, rest);
        CHECK(one.frames.front() == rest);
        CHECK(one.frames.back() == rest);
        CHECK(one.frames[20] == raisedBy(rest, 1.0));
        CHECK(angleBetween(one.frames[1][UpperBone::left_forearm], rest[UpperBone::left_forearm]) <
              0.02);  // no slope
        CHECK(motionThroughKeyframes({{0, raisedBy(rest, 1.0)}}, 1, rest).frames.front() ==
              raisedBy(rest, 1.0));
        CHECK(motionThroughKeyframes({}, 0, rest).frames.empty());
        // From a direction to its opposite there is one frame without any.
        UpperBodyPose down = rest, up = rest;
        down[UpperBone::left_forearm] = {0.0, -1.0, 0.0};
        up[UpperBone::left_forearm] = {0.0, 1.0, 0.0};
        for (const UpperBodyPose& pose : motionThroughKeyframes({{0, down}, {10, up}}, 11, rest).frames)
            CHECK(glm::length(pose[UpperBone::left_forearm]) == doctest::Approx(1.0));
    }

    TEST_CASE("poses that cannot be are named") {
        const UpperBodyPose rest = relaxedUpperBody();
        const auto error = [](const std::vector<PoseControl>& poses) {
            return checkPoses(poses, 10).error().message;
        };
        CHECK(error({{10, rest}}).find("found a pose at frame 10, expected frames from 0 to 9") !=
              std::string::npos);
        CHECK(error({{-1, rest}}).find("frame -1") != std::string::npos);
        CHECK(error({{3, rest}, {2, rest}, {3, rest}}).find("two poses for frame 3") != std::string::npos);
        UpperBodyPose broken = rest;
        broken[UpperBone::nose] = {0.0, 0.0, NAN};
        CHECK(error({{3, broken}}).find("length") != std::string::npos);
        CHECK(checkPoses(std::vector<PoseControl>{{3, rest}, {4, rest}}, 10).has_value());
    }
}
