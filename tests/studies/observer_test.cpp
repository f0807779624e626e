// How an observer reads a pointing arm: the model of docs/simulated-participant.md.
#include "studies/observers/observer.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

using namespace deixis;
using namespace deixis::studies;

namespace {

const Vec3 tip{0.0, 1.4, 0.6};

/// From the fingertip, so many degrees to the left (+x) of straight ahead and above level.
Ray line(double left_deg, double above_deg) {
    const double left = radiansFromDegrees(left_deg);
    const double above = radiansFromDegrees(above_deg);
    return {tip, {std::cos(above) * std::sin(left), std::sin(above), std::cos(above) * std::cos(left)}};
}

/// 1.5 m along that line.
Vec3 ball(double left_deg, double above_deg) {
    return tip + 1.5 * line(left_deg, above_deg).direction;
}

/// Seen from across, where the own view has no weight.
SeenArm seenFromAcross(const Ray& eye_line, const Ray& arm_line) {
    return {{eye_line, arm_line, eye_line}, {0.0, 1.65, 3.4}};
}

ObserverModel model(const char* ray, double noise_deg) {
    ObserverModel out;
    out.reading = *readingFromName(ray);
    out.noise_rad = radiansFromDegrees(noise_deg);
    out.lapse_rate = 0.0;
    return out;
}

/// The target straight ahead, and the others beside and above it.
const std::vector<Vec3> balls{ball(0, 0), ball(10, 0), ball(0, 10)};

}  // namespace

TEST_SUITE("studies/observer") {
    TEST_CASE("every reading has its name, and another is rejected with all of them") {
        for (const char* const name :
             {"two-cue", "arm-finger", "eye-fingertip", "forearm", "shoulder-hand"}) {
            const auto reading = readingFromName(name);
            REQUIRE(reading.has_value());
            CHECK(readingName(*reading) == name);
        }
        CHECK(*readingFromName("arm-finger") == *readingFromName("elbow-fingertip"));
        const auto none = readingFromName("nose");
        REQUIRE_FALSE(none.has_value());
        for (const char* const part : {"nose", "two-cue", "arm-finger", "head"})
            CHECK(none.error().text().find(part) != std::string::npos);
    }

    TEST_CASE("of two cues each is a reading: either line on the target is enough, their mean is not") {
        for (const double noise_deg : {3.0, 4.0}) {
            const ObserverModel both = model("two-cue", noise_deg);
            // The other line lies 20 degrees off: a mean of the two would pass by the ball at 10 degrees.
            CHECK(ballChance(both, seenFromAcross(line(0, 0), line(20, 0)), balls, 0) > 0.85);
            CHECK(ballChance(both, seenFromAcross(line(20, 0), line(0, 0)), balls, 0) > 0.85);
            const SeenArm mean = seenFromAcross(line(10, 0), line(10, 0));
            CHECK(ballChance(model("eye-fingertip", noise_deg), mean, balls, 0) < 0.1);
        }
    }

    TEST_CASE("the chance is that of the formula, worked by hand") {
        ObserverModel both = model("two-cue", 5.0);
        both.eye_line_share = 0.6;
        const SeenArm arm = seenFromAcross(line(0, 0), line(10, 0));
        const std::vector<Vec3> two{ball(0, 0), ball(10, 0)};
        // Each line meets one ball and misses the other by 10 degrees, two SDs: 0.6 + 0.4 e^-2 against
        // 0.4 + 0.6 e^-2.
        const double e = std::exp(-2.0);
        const double expected = (0.6 + 0.4 * e) / (1.0 + e);
        CHECK(ballChance(both, arm, two, 0) == doctest::Approx(expected).epsilon(1e-9));
        CHECK(ballChance(both, arm, two, 1) == doctest::Approx(1.0 - expected).epsilon(1e-9));
        both.lapse_rate = 0.1;
        CHECK(choiceChance(both, arm, two, 0) == doctest::Approx(0.9 * expected + 0.05).epsilon(1e-9));
        // In degrees: what one line would have to miss the ball by to speak for it as loudly.
        const double missed = 5.0 * std::sqrt(-2.0 * std::log(0.6 + 0.4 * e));
        CHECK(degreesFromRadians(misses(both, arm, two)[0]) == doctest::Approx(missed).epsilon(1e-9));
    }

    TEST_CASE("a line that passes near no ball says nothing") {
        const ObserverModel both = model("two-cue", 3.0);
        const double at_25 = ballChance(both, seenFromAcross(line(3, 0), line(-25, 0)), balls, 0);
        const double at_40 = ballChance(both, seenFromAcross(line(3, 0), line(-40, 0)), balls, 0);
        CHECK(at_25 == doctest::Approx(at_40).epsilon(1e-6));
    }

    TEST_CASE("the more the gaze runs along the arm, the more the finger's place in the view counts") {
        const ObserverModel both = model("two-cue", 3.0);
        double before = 1.0;
        for (const double around_deg : {0.0, 30.0, 60.0, 89.0, 120.0, 180.0}) {
            CAPTURE(around_deg);
            // The observer on a circle about the fingertip, from behind the arm to across.
            const double around = radiansFromDegrees(around_deg);
            SeenArm arm = seenFromAcross(line(0, 0), line(0, 0));
            arm.observer_eye = tip - 1.6 * Vec3(std::sin(around), 0.0, std::cos(around));
            const auto weights = cueWeights(both, arm);
            CHECK(weights[0] + weights[1] + weights[2] == doctest::Approx(1.0));
            CHECK(weights[0] == doctest::Approx(weights[1]));
            CHECK(weights[2] == doctest::Approx(both.visual_weight * std::max(0.0, std::cos(around))));
            CHECK(weights[2] <= before);
            before = weights[2];
        }
        CHECK(before == 0.0);
    }

    TEST_CASE(
        "who stands behind the pointer takes the ball behind the finger, from across it is not minded") {
        const ObserverModel both = model("two-cue", 3.0);
        // Both lines of the arm point between the balls at 0 and 10 degrees.
        SeenArm arm = seenFromAcross(line(5, 0), line(5, 0));
        arm.observer_eye = tip - 1.2 * line(0, 0).direction;  // sees the finger before the first ball
        CHECK(ballChance(both, arm, balls, 0) > 0.65);
        arm.observer_eye = tip - 1.2 * line(10, 0).direction;
        CHECK(ballChance(both, arm, balls, 1) > 0.65);
        arm.observer_eye = tip + 2.8 * line(0, 0).direction;
        CHECK(ballChance(both, arm, balls, 0) == doctest::Approx(ballChance(both, arm, balls, 1)));
    }

    TEST_CASE("without noise the nearest line decides, and no number breaks") {
        const ObserverModel exact = model("two-cue", 0.0);
        CHECK(ballChance(exact, seenFromAcross(line(1, 0), line(12, 0)), balls, 0) == doctest::Approx(1.0));
        CHECK(ballChance(exact, seenFromAcross(line(3, 0), line(12, 0)), balls, 1) == doctest::Approx(1.0));
        CHECK(ballChance(exact, seenFromAcross(line(100, 0), line(60, 0)), balls, 1) == doctest::Approx(1.0));
        const std::vector<Vec3> one{ball(50, 20)};
        CHECK(ballChance(exact, seenFromAcross(line(0, 0), line(0, 0)), one, 0) == doctest::Approx(1.0));
    }

    TEST_CASE("a bias raises every line by so much, up to straight up") {
        const ArmLines lines{line(20, 10), line(-30, -5), line(0, 80)};
        const ArmLines higher = raised(lines, radiansFromDegrees(8.0));
        CHECK(glm::length(higher.eye_line.direction - line(20, 18).direction) < 1e-12);
        CHECK(glm::length(higher.arm_line.direction - line(-30, 3).direction) < 1e-12);
        CHECK(glm::length(higher.line.direction - line(0, 88).direction) < 1e-12);
        CHECK(raised(lines, radiansFromDegrees(30.0)).line.direction.y == doctest::Approx(1.0));
        CHECK(raised(lines, 0.0).eye_line.direction == lines.eye_line.direction);
    }
}
