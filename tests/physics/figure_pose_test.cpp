// Poses of the avatar as angles of the body, and back.
#include <glm/gtc/quaternion.hpp>

#include "bodies.hpp"
#include "motion/skeleton/axes.hpp"
#include "motion/skeleton/clip_edit.hpp"

using namespace deixis;
using namespace deixis::physics;
using namespace deixis::tests;
using motion::Bone;
using motion::LocalPose;

namespace {

double largestDistance(const motion::Skeleton& skeleton, const LocalPose& a, const LocalPose& b) {
    const auto from = motion::worldPose(skeleton, a), to = motion::worldPose(skeleton, b);
    double largest = 0.0;
    for (std::size_t j = 0; j < from.size(); ++j)
        largest = std::max(largest, glm::distance(from[j].position, to[j].position));
    return largest;
}

void turn(LocalPose& pose, Bone bone, double degrees, const Vec3& axis) {
    auto& joint = pose.joints[static_cast<std::size_t>(bone)];
    joint.orientation = glm::angleAxis(radiansFromDegrees(degrees), axis) * joint.orientation;
}

}  // namespace

TEST_SUITE("physics/figure_pose") {
    TEST_CASE(
        "angles put into a pose are read from it again, and turn it as the body's segments are turned") {
        const Figure figure = figureOf(Stance::free);
        Random random(3, "angles");
        for (int i = 0; i < 200; ++i) {
            LocalPose pose = motion::relaxedPose(figure.skeleton);
            const std::vector<double> angles = drawAngles(figure, random);
            applyAngles(figure, angles, pose);
            const PoseFit fit = fitPose(figure, pose);
            for (std::size_t h = 0; h < angles.size(); ++h) {
                CAPTURE(figure.hinges[h].name);
                CHECK(fit.angles_rad[h] == doctest::Approx(angles[h]).epsilon(1e-9));
            }
            CHECK(fit.beyond_rad == 0.0);
            // Of elbow and knee the hinge alone: the relaxed forearm has no other turn.
            const auto world = motion::worldPose(figure.skeleton, pose);
            const auto body = segmentPoses(figure, rootOf(figure, pose), angles);
            for (std::size_t s = 0; s < body.size(); ++s) {
                if (figure.segments[s].name.ends_with("hand")) continue;
                const Quat& q = world[figure.segments[s].bone].orientation;
                CHECK(std::abs(glm::dot(q, body[s].orientation)) == doctest::Approx(1.0).epsilon(1e-12));
            }
        }
    }

    TEST_CASE("poses of the body come back from their angles to a millionth of a metre") {
        const Figure figure = figureOf(Stance::pinned);
        Random random(4, "angles");
        LocalPose base = motion::restPose(figure.skeleton);
        for (int i = 0; i < 50; ++i) {
            LocalPose pose = base;
            std::vector<double> angles = drawAngles(figure, random);
            for (std::size_t h = 0; h < 3; ++h) angles[h] = 0.0;  // a turned trunk bends in three places
            applyAngles(figure, angles, pose);
            LocalPose again = base;
            const PoseFit fit = fitPose(figure, pose);
            applyAngles(figure, fit.angles_rad, again);
            CHECK(largestDistance(figure.skeleton, pose, again) < 1e-6);
            CHECK(fit.distance_m < 1e-9);
        }
    }

    TEST_CASE(
        "a demonstration's poses are within the limits, unchanged by their own angles, and 2.5 cm off") {
        const Figure figure = figureOf(Stance::free);
        double farthest_m = 0.0;
        for (std::size_t d = 0; d < demonstrations().size(); d += 4)
            for (const LocalPose& pose : demonstrations()[d].gesture.clip.frames) {
                const PoseFit fit = fitPose(figure, pose);
                LocalPose again = pose;
                applyAngles(figure, fit.angles_rad, again);
                REQUIRE(largestDistance(figure.skeleton, pose, again) < 1e-6);
                REQUIRE(fit.beyond_rad == 0.0);
                farthest_m = std::max(farthest_m, fit.distance_m);
            }
        // The body has no shoulder girdle, and one joint for the trunk's three.
        CHECK(farthest_m < 0.025);
        CHECK(farthest_m > 0.005);
    }

    TEST_CASE("angles of an arm that points straight ahead, worked out by hand") {
        // The first axis is (0, cos 30, sin 30) from the shoulder: an arm along z is 30 degrees above its
        // plane, and in it a quarter turn before the arm at rest, along x.
        const Figure figure = figureOf(Stance::pinned);
        LocalPose pose = motion::restPose(figure.skeleton);
        turn(pose, Bone::leftUpperArm, -90.0, motion::y_axis);
        turn(pose, Bone::leftLowerArm, -40.0, motion::y_axis);
        const PoseFit fit = fitPose(figure, pose);
        const auto degrees = [&](const char* name) {
            return degreesFromRadians(fit.angles_rad[figure.hinge(name)]);
        };
        CHECK(degrees("left shoulder swing") == doctest::Approx(90.0));
        CHECK(degrees("left shoulder raise") == doctest::Approx(30.0));
        CHECK(degrees("left elbow flexion") == doctest::Approx(40.0));
        CHECK(degrees("right shoulder swing") == doctest::Approx(0.0));
        CHECK(degrees("right elbow flexion") == doctest::Approx(0.0));
        CHECK(fit.distance_m < 1e-12);
    }

    TEST_CASE("a mirrored pose has the other side's angles") {
        const Figure figure = figureOf(Stance::free);
        const auto partners = motion::mirrorPartners(figure.skeleton);
        Random random(5, "angles");
        for (int i = 0; i < 20; ++i) {
            LocalPose pose = motion::relaxedPose(figure.skeleton);
            applyAngles(figure, drawAngles(figure, random), pose);
            const auto given = fitPose(figure, pose).angles_rad;
            const auto seen = fitPose(figure, motion::mirrored(figure.skeleton, partners, pose)).angles_rad;
            for (std::size_t h = 0; h < given.size(); ++h) {
                const std::string& name = figure.hinges[h].name;
                CAPTURE(name);
                if (name.starts_with("left"))
                    CHECK(seen[figure.hinge("right" + name.substr(4))] ==
                          doctest::Approx(given[h]).epsilon(1e-9));
                else if (name.ends_with("flexion") && !name.starts_with("right"))
                    CHECK(seen[h] == doctest::Approx(given[h]).epsilon(1e-9));
                else if (!name.starts_with("right"))
                    CHECK(seen[h] == doctest::Approx(-given[h]).epsilon(1e-9));
            }
        }
    }

    TEST_CASE("what is beyond a limit is cut off there, and how far it was is said") {
        const Figure figure = figureOf(Stance::pinned);
        LocalPose pose = motion::restPose(figure.skeleton);
        turn(pose, Bone::rightLowerArm, 165.0, motion::y_axis);
        const PoseFit fit = fitPose(figure, pose);
        CHECK(figure.hinges[fit.beyond_hinge].name == "right elbow flexion");
        CHECK(degreesFromRadians(fit.beyond_rad) == doctest::Approx(15.0));
        CHECK(degreesFromRadians(fit.angles_rad[fit.beyond_hinge]) == doctest::Approx(150.0));
        // The wrist moves on a circle of the forearm's length, 0.255 m: its chord over 15 degrees.
        CHECK(fit.distance_m == doctest::Approx(2.0 * 0.255 * std::sin(radiansFromDegrees(7.5))));
    }

    TEST_CASE("the hips go where the root is said to be") {
        const Figure figure = figureOf(Stance::free);
        LocalPose pose = motion::relaxedPose(figure.skeleton);
        const Pose root{{0.1, 0.8, -0.2}, yawRotation(0.4)};
        applyRoot(figure, root, pose);
        CHECK(glm::distance(rootOf(figure, pose).position, root.position) < 1e-12);
        CHECK(std::abs(glm::dot(rootOf(figure, pose).orientation, root.orientation)) == doctest::Approx(1.0));
    }
}
