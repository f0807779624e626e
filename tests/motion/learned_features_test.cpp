#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "motion/skeleton/minimum_jerk.hpp"
#include "motion/synthesis/demonstration_library.hpp"
#include "motion/synthesis/phase_trajectory.hpp"
#include "motion/synthesis/pose_features.hpp"
#include "pointing_checks.hpp"

using namespace deixis;
using namespace deixis::motion;
using namespace deixis::tests;
using doctest::Approx;

namespace {

const PoseFeatures& features() {
    static const PoseFeatures made = PoseFeatures::of(referenceHumanoid()).value();
    return made;
}

const std::vector<Demonstration>& demonstrations() {
    static const auto made = makeDemonstrations(referenceHumanoid(), {}).value();
    return made;
}

}  // namespace

TEST_SUITE("motion/pose_features") {
    TEST_CASE("rotation vectors are the angle about the axis, by hand, and go back") {
        const Vec3 quarter = rotationVector(Quat(std::sqrt(0.5), 0.0, std::sqrt(0.5), 0.0));
        CHECK(glm::length(quarter - Vec3(0.0, pi / 2.0, 0.0)) < 1e-12);
        CHECK(rotationVector(no_rotation) == Vec3(0.0));
        Random random(1);
        for (int i = 0; i < 200; ++i) {
            const Vec3 v(random.normal(), random.normal(), random.normal());
            const Vec3 back = rotationVector(rotationBy(v));
            CHECK(glm::length(back - v) < 1e-9);
        }
    }

    TEST_CASE("at ease all numbers are 0, and 0 is at ease") {
        const LocalPose at_ease = relaxedPose(referenceHumanoid());
        for (const double number : features().encode(at_ease, {})) CHECK(std::abs(number) < 1e-12);
        CHECK(maxTurn(features().decode(std::vector<double>(features().size(), 0.0)), at_ease) < 1e-7);
        CHECK(features().size() == 53);
        CHECK(features().names().ends_with("rightIndexProximal leftFingers rightFingers"));
    }

    TEST_CASE("numbers become a pose and the same numbers again") {
        Random random(2);
        for (int i = 0; i < 50; ++i) {
            std::vector<double> numbers;
            for (std::size_t d = 0; d < features().size(); ++d) numbers.push_back(random.uniform(-1.0, 1.0));
            const auto again = features().encode(features().decode(numbers), {});
            for (std::size_t d = 0; d < numbers.size(); ++d)
                CHECK(again[d] == Approx(numbers[d]).epsilon(1e-9));
        }
    }

    TEST_CASE("a joint that turns on beyond a half turn is followed, never wrapped") {
        const auto bone = static_cast<std::size_t>(Bone::rightUpperArm);
        std::vector<double> previous;
        for (double angle = 0.0; angle < 6.0; angle += 0.2) {
            LocalPose pose = relaxedPose(referenceHumanoid());
            pose.joints[bone].orientation = pose.joints[bone].orientation * rotationBy({0.0, 0.0, angle});
            const auto numbers = features().encode(pose, previous);
            double squares = 0.0;
            for (const double number : numbers) squares += number * number;
            CHECK(std::sqrt(squares) == Approx(angle));
            previous = numbers;
        }
    }

    TEST_CASE("the demonstrations keep their fingertip within 3 mm of their own hips") {
        for (std::size_t i = 0; i < demonstrations().size(); i += 7) {
            GeneratedClip made = demonstrations()[i].gesture;
            const auto numbers = features().encode(made.clip);
            GeneratedClip again = made;
            for (std::size_t f = 0; f < numbers.size(); ++f)
                again.clip.frames[f] = features().decode(numbers[f]);
            for (int f = 0; f < made.clip.frameCount(); ++f) {
                const Vec3 hips = joint(worldAt(made.clip, f), Bone::hips);
                const Vec3 hips_again = joint(worldAt(again.clip, f), Bone::hips);
                CHECK(glm::length(fingertipAt(made, f) - hips - fingertipAt(again, f) + hips_again) < 0.003);
            }
        }
    }

    TEST_CASE("an avatar without an arm is rejected by the bone's name") {
        Skeleton avatar = referenceHumanoid();
        avatar.joints[static_cast<std::size_t>(Bone::leftHand)].name = "hook";
        const auto made = PoseFeatures::of(avatar);
        REQUIRE_FALSE(made.has_value());
        CHECK(made.error().text().find("leftHand") != std::string::npos);
    }
}

TEST_SUITE("motion/phase_trajectory") {
    TEST_CASE("phases of any duration begin and end at the same aligned times") {
        const PhaseDurations durations{0.3, 0.8, 1.1, 0.9, 0.2};
        double time_s = 0.0;
        const std::array<double, 6> borders{0.0, 3.0, 11.0, 17.0, 25.0, 28.0};
        for (std::size_t i = 0; i < 5; ++i) {
            CHECK(PhaseTrajectory::aligned(time_s, durations) == Approx(borders[i]));
            CHECK(PhaseTrajectory::aligned(time_s + 0.5 * durations[i], durations) ==
                  Approx(0.5 * (borders[i] + borders[i + 1])));
            time_s += durations[i];
        }
        CHECK(PhaseTrajectory::aligned(time_s, durations) == Approx(28.0));
        CHECK(PhaseTrajectory::aligned(99.0, durations) == 28.0);
        CHECK(PhaseTrajectory::aligned(-1.0, durations) == 0.0);
    }

    TEST_CASE("durations are those of a clip's frames") {
        GesturePhases phases;
        phases.onset_frame = 9;
        phases.peak_frame = 33;
        phases.hold_frame = 63;
        phases.end_frame = 90;
        const auto durations = durationsOf(phases, 100, 1.0 / 30.0);
        CHECK(durations[0] == Approx(0.3));
        CHECK(durations[1] == Approx(0.8));
        CHECK(durations[2] == Approx(1.0));
        CHECK(durations[3] == Approx(0.9));
        CHECK(durations[4] == Approx(0.3));
    }

    TEST_CASE("the splines sum to one away from the ends, and vanish at them with their slope") {
        for (double t = 5.0; t <= 23.0; t += 0.37) {
            const auto basis = PhaseTrajectory::basis(t);
            CHECK(std::accumulate(basis.begin(), basis.end(), 0.0) == Approx(1.0));
        }
        for (const double end : {0.0, 28.0})
            for (const double value : PhaseTrajectory::basis(end)) CHECK(value == 0.0);
        for (const double value : PhaseTrajectory::basis(0.01)) CHECK(std::abs(value) < 1e-6);
    }

    TEST_CASE("what the splines describe is found again from its frames") {
        Random random(4);
        std::vector<double> coefficients;
        for (std::size_t i = 0; i < 2 * PhaseTrajectory::coefficient_count; ++i)
            coefficients.push_back(random.normal());
        const PhaseDurations durations{0.25, 0.7, 0.9, 0.75, 0.3};
        std::vector<std::vector<double>> frames;
        for (int f = 0; f <= 87; ++f)
            frames.push_back(trajectoryAt(coefficients, PhaseTrajectory::aligned(f / 30.0, durations)));
        const auto found = fitTrajectory(frames, 1.0 / 30.0, durations);
        REQUIRE(found.size() == coefficients.size());
        for (std::size_t i = 0; i < found.size(); ++i) CHECK(std::abs(found[i] - coefficients[i]) < 1e-3);
    }

    TEST_CASE("a minimum-jerk raise and return is fitted to a thousandth") {
        const PhaseDurations durations{0.3, 0.8, 1.0, 0.9, 0.3};
        std::vector<std::vector<double>> frames;
        for (int f = 0; f <= 99; ++f)
            frames.push_back({minimumJerk((f / 30.0 - 0.3) / 0.8) - minimumJerk((f / 30.0 - 2.1) / 0.9)});
        const auto coefficients = fitTrajectory(frames, 1.0 / 30.0, durations);
        for (int f = 0; f <= 99; ++f) {
            const auto value = trajectoryAt(coefficients, PhaseTrajectory::aligned(f / 30.0, durations));
            CHECK(std::abs(value[0] - frames[static_cast<std::size_t>(f)][0]) < 1e-3);
        }
    }

    TEST_CASE("a clip without rest leaves the coefficients there at 0") {
        std::vector<std::vector<double>> frames(60, {0.5});
        const auto coefficients = fitTrajectory(frames, 1.0 / 30.0, {1e-4, 0.7, 0.5, 0.7, 1e-4});
        for (const double coefficient : coefficients) CHECK(std::abs(coefficient) < 2.0);
    }
}
