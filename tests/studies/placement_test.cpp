#include "studies/design/placement.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/random.hpp"

using namespace deixis;
using namespace deixis::studies;

namespace {

constexpr double avatar_eyes_m = 1.62;

Quat pitchRotation(double angle_rad) {
    return {std::cos(angle_rad / 2.0), std::sin(angle_rad / 2.0), 0.0, 0.0};
}

Quat rollRotation(double angle_rad) {
    return {std::cos(angle_rad / 2.0), 0.0, 0.0, std::sin(angle_rad / 2.0)};
}

/// A person somewhere in the room who faces `heading_rad` (turned from -z towards -x), head tilted.
Pose someHead(Random& random, double heading_rad) {
    return {{random.uniform(-4.0, 4.0), random.uniform(0.6, 2.1), random.uniform(-4.0, 4.0)},
            yawRotation(heading_rad) * pitchRotation(random.uniform(-1.3, 1.3)) *
                rollRotation(random.uniform(-0.6, 0.6))};
}

Pose someViewer(Random& random) {
    return {{random.uniform(-4.0, 4.0), 0.0, random.uniform(-4.0, 4.0)},
            yawRotation(random.uniform(-pi, pi))};
}

Vec3 somePoint(Random& random) {
    return {random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0)};
}

Vec3 forwardOf(const Pose& pose) {
    return pose.orientation * Vec3(0.0, 0.0, -1.0);
}

bool near(const Vec3& a, const Vec3& b) {
    return glm::length(a - b) < 1e-9;
}

bool near(const Quat& a, const Quat& b) {
    return std::abs(glm::dot(a, b)) > 1.0 - 1e-12;
}

constexpr EyeLevel every_level[] = {EyeLevel::measured, EyeLevel::raise, EyeLevel::scale};

}  // namespace

TEST_SUITE("studies/placement") {
    TEST_CASE("The anchor is the floor below the head, facing where the person looks.") {
        // At (1, 1.7, 2), turned a quarter to the left: looks along -x.
        const Anchor anchor = anchorFromHead({{1.0, 1.7, 2.0}, yawRotation(pi / 2.0)});
        CHECK(near(anchor.tracking_from_anchor.position, Vec3(1.0, 0.0, 2.0)));
        CHECK(near(forwardOf(anchor.tracking_from_anchor), Vec3(-1.0, 0.0, 0.0)));
        CHECK(anchor.eye_height_m == 1.7);
    }

    TEST_CASE("Pitch and roll of the head leave its heading as it is.") {
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            CAPTURE(seed);
            Random random(seed, "anchor");
            const double heading_rad = random.uniform(-pi, pi);
            const Anchor anchor = anchorFromHead(someHead(random, heading_rad));
            CHECK(near(anchor.tracking_from_anchor.orientation, yawRotation(heading_rad)));
            CHECK(anchor.tracking_from_anchor.position.y == 0.0);
        }
    }

    TEST_CASE("Looking straight down or up, or a little beyond, the person still faces the same way.") {
        for (const double degrees : {-95.0, -90.0, -87.0, 87.0, 90.0, 95.0}) {
            for (const double heading_rad : {0.0, 1.0, -2.5}) {
                CAPTURE(degrees);
                CAPTURE(heading_rad);
                const Quat head = yawRotation(heading_rad) * pitchRotation(radiansFromDegrees(degrees));
                const Anchor anchor = anchorFromHead({{0.0, 1.6, 0.0}, head});
                CHECK(near(anchor.tracking_from_anchor.orientation, yawRotation(heading_rad)));
            }
        }
    }

    TEST_CASE("Worked by hand: somebody who faces -x in the room stands across from the avatar.") {
        const Anchor anchor = anchorFromHead({{1.0, 1.8, 2.0}, yawRotation(pi / 2.0)});
        const Pose across{{0.0, 0.0, 3.4}, no_rotation};  // looks along -z, back at the avatar
        const Placement placement = placementFor(anchor, across, EyeLevel::measured, avatar_eyes_m);
        CHECK(placement.scale == 1.0);
        // One metre ahead in the room is one metre nearer to the avatar; half a metre to the right (-z in the
        // room) is half a metre to the right (+x on the stage).
        const Pose ahead = placement.toStage({{0.0, 1.8, 2.0}, yawRotation(pi / 2.0)});
        CHECK(near(ahead.position, Vec3(0.0, 1.8, 2.4)));
        CHECK(near(ahead.orientation, no_rotation));
        const Pose right = placement.toStage({{1.0, 0.3, 1.5}, no_rotation});
        CHECK(near(right.position, Vec3(0.5, 0.3, 3.4)));
        CHECK(near(forwardOf(right), Vec3(1.0, 0.0, 0.0)));
        // The avatar's place lies 3.4 m ahead.
        CHECK(near(placement.toTracking({{0.0, 0.0, 0.0}, no_rotation}).position, Vec3(-2.4, 0.0, 2.0)));
    }

    TEST_CASE("The anchor lands on the layout's place and heading, up stays up and floor stays level.") {
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            CAPTURE(seed);
            Random random(seed, "placement");
            const Anchor anchor = anchorFromHead(someHead(random, random.uniform(-pi, pi)));
            const Pose viewer = someViewer(random);
            for (const EyeLevel level : every_level) {
                CAPTURE(static_cast<int>(level));
                const Placement placement = placementFor(anchor, viewer, level, avatar_eyes_m);
                const Pose stood = placement.toStage(anchor.tracking_from_anchor);
                CHECK(std::abs(stood.position.x - viewer.position.x) < 1e-9);
                CHECK(std::abs(stood.position.z - viewer.position.z) < 1e-9);
                CHECK(near(stood.orientation, viewer.orientation));
                CHECK(near(placement.turn_and_shift.orientation * up, up));
                // A horizontal plane of the room is one of the stage: the floor where nothing was raised.
                const Vec3 point = somePoint(random);
                const Vec3 on_floor = placement.toStage({{point.x, 0.0, point.z}, no_rotation}).position;
                if (level == EyeLevel::raise)
                    CHECK(on_floor.y == doctest::Approx(avatar_eyes_m - anchor.eye_height_m));
                else
                    CHECK(std::abs(on_floor.y) < 1e-12);
            }
        }
    }

    TEST_CASE("Raised or scaled, the avatar's eyes are level with the person's; measured, nothing moves.") {
        for (const double eyes_m : {1.1, 1.45, 1.62, 1.95}) {
            CAPTURE(eyes_m);
            const Pose head{{0.4, eyes_m, -1.0}, yawRotation(0.3)};
            const Anchor anchor = anchorFromHead(head);
            const Pose viewer{{0.7, 0.0, -0.2}, yawRotation(pi)};
            const auto eyesOnStage = [&](EyeLevel level) {
                return placementFor(anchor, viewer, level, avatar_eyes_m).toStage(head).position.y;
            };
            CHECK(eyesOnStage(EyeLevel::measured) == doctest::Approx(eyes_m));
            CHECK(eyesOnStage(EyeLevel::raise) == doctest::Approx(avatar_eyes_m));
            CHECK(eyesOnStage(EyeLevel::scale) == doctest::Approx(avatar_eyes_m));
            // Lengths on the stage keep their size but where it is scaled.
            const Placement scaled = placementFor(anchor, viewer, EyeLevel::scale, avatar_eyes_m);
            CHECK(scaled.scale == doctest::Approx(avatar_eyes_m / eyes_m));
            CHECK(placementFor(anchor, viewer, EyeLevel::raise, avatar_eyes_m).scale == 1.0);
        }
    }

    TEST_CASE("The scale stays within a half and two, also where the head lies on the floor.") {
        const Pose viewer{{0.0, 0.0, 3.4}, no_rotation};
        for (const double eyes_m : {-0.2, 0.0, 0.05, 0.4})
            CHECK(placementFor({{}, eyes_m}, viewer, EyeLevel::scale, avatar_eyes_m).scale == 2.0);
        CHECK(placementFor({{}, 4.0}, viewer, EyeLevel::scale, avatar_eyes_m).scale == 0.5);
    }

    TEST_CASE("To the stage and back is where one began, at every eye level.") {
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            CAPTURE(seed);
            Random random(seed, "round trip");
            const Anchor anchor = anchorFromHead(someHead(random, random.uniform(-pi, pi)));
            const Pose viewer = someViewer(random);
            const Pose hand = someHead(random, random.uniform(-pi, pi));
            for (const EyeLevel level : every_level) {
                const Placement placement = placementFor(anchor, viewer, level, avatar_eyes_m);
                const Pose back = placement.toTracking(placement.toStage(hand));
                CHECK(near(back.position, hand.position));
                CHECK(near(back.orientation, hand.orientation));
                const Pose there = placement.toStage(placement.toTracking(hand));
                CHECK(near(there.position, hand.position));
                CHECK(near(there.orientation, hand.orientation));
            }
        }
    }

    TEST_CASE("A ray keeps its unit length and goes on pointing at the same thing.") {
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            CAPTURE(seed);
            Random random(seed, "rays");
            const Anchor anchor = anchorFromHead(someHead(random, random.uniform(-pi, pi)));
            const Pose viewer = someViewer(random);
            const Vec3 hand = somePoint(random);
            const Vec3 thing = somePoint(random);
            for (const EyeLevel level : every_level) {
                const Placement placement = placementFor(anchor, viewer, level, avatar_eyes_m);
                const Ray ray = placement.toStage(Ray{hand, glm::normalize(thing - hand)});
                const Vec3 there = placement.toStage(Pose{thing, no_rotation}).position;
                CHECK(glm::length(ray.direction) == doctest::Approx(1.0).epsilon(1e-12));
                CHECK(angleBetween(ray.direction, there - ray.origin) < 1e-9);
            }
        }
    }

    TEST_CASE("The distance from the place is measured along the floor.") {
        const Anchor anchor = anchorFromHead({{1.0, 1.7, 2.0}, no_rotation});
        CHECK(distanceFromPlace(anchor, {{1.0, 0.4, 2.0}, no_rotation}) == 0.0);
        CHECK(distanceFromPlace(anchor, {{1.3, 1.7, 1.6}, no_rotation}) == doctest::Approx(0.5));
    }
}
