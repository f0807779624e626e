#include "motion/skeleton/kinematics.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <sstream>
#include <string>

#include "core/files.hpp"
#include "core/random.hpp"
#include "motion/skeleton/minimum_jerk.hpp"
#include "paths.hpp"

using namespace deixis;
using namespace deixis::motion;
using doctest::Approx;

namespace {

/// A minimum-jerk reach over `way` in `duration_s`, both ends included.
std::vector<Vec3> reach(const Vec3& way, double duration_s, double fps) {
    std::vector<Vec3> out;
    const int last = static_cast<int>(std::lround(duration_s * fps));
    for (int i = 0; i <= last; ++i) out.push_back(minimumJerk(i / static_cast<double>(last)) * way);
    return out;
}

}  // namespace

TEST_SUITE("motion/kinematics") {
    TEST_CASE("a minimum-jerk reach is fastest in its middle, at 1.875 ways a time") {
        const auto positions = reach({0.3, 0.4, 0.0}, 0.8, 240.0);
        const auto speed = speeds(positions, 1.0 / 240.0);
        const auto fastest = std::max_element(speed.begin(), speed.end());
        CHECK(*fastest == Approx(1.875 * 0.5 / 0.8).epsilon(0.005));
        CHECK(fastest - speed.begin() == 96);
        CHECK(speed.front() < 0.02);
    }

    TEST_CASE("a time has the whole number of frames that is nearest, at least one") {
        CHECK(framesIn(0.1, 1.0 / 30.0) == 3);
        CHECK(framesIn(0.1, 0.0333334) == 3);
        CHECK(framesIn(0.1, 1.0 / 24.0) == 2);
        CHECK(framesIn(0.0, 1.0 / 30.0) == 1);
        CHECK(framesIn(1.0, 1e-9) == 1'000'000);
    }

    TEST_CASE("a velocity looks back as far as it is told to, and samples may stand at times of their own") {
        // x = t^2: from t - h to t it goes at 2t - h, whatever stands after.
        const std::vector<double> times{0.0, 0.1, 0.3, 0.3, 0.7};
        std::vector<Vec3> uneven, even;
        for (const double t : times) uneven.emplace_back(t * t, 0.0, 0.0);
        for (int i = 0; i < 8; ++i) even.emplace_back(0.01 * i * i, 0.0, 0.0);
        const auto at = speedsAt(times, uneven);
        const std::vector<double> expected{0.0, 0.1, 0.4, 0.0, 1.0};
        REQUIRE(at.size() == expected.size());
        for (std::size_t i = 0; i < at.size(); ++i) CHECK(at[i] == Approx(expected[i]));
        const auto back = speeds(even, 0.1, {.before_s = 0.2});
        REQUIRE(back.size() == even.size());
        CHECK(back[0] == 0.0);
        CHECK(back[1] == Approx(0.1));  // cut off at the first sample
        for (std::size_t i = 2; i < back.size(); ++i)
            CHECK(back[i] == Approx(0.2 * static_cast<double>(i) - 0.2));
    }

    TEST_CASE("a steady movement has the same velocity everywhere, its ends too, at any rate") {
        for (const double fps : {24.0, 30.0, 100.0, 120.0}) {
            std::vector<Vec3> positions;
            for (int i = 0; i < 20; ++i) positions.push_back(i / fps * Vec3(0.5, -1.0, 0.25));
            for (const Vec3& v : velocities(positions, 1.0 / fps))
                CHECK(glm::length(v - Vec3(0.5, -1.0, 0.25)) < 1e-12);
        }
        CHECK(speeds({Vec3(1.0)}, 0.1) == std::vector<double>{0.0});
    }

    TEST_CASE(
        "the log dimensionless jerk of a minimum-jerk reach is -ln 204.8, whatever way, time and rate") {
        // integral of jerk^2 = 720 D^2/T^5 and v_peak = 1.875 D/T, so T^3/v^2 times it is 720/1.875^2 =
        // 204.8.
        for (const double fps : {240.0, 1000.0})
            for (const double duration : {0.5, 2.0})
                for (const double way : {0.1, 3.0}) {
                    const auto j = logDimensionlessJerk(reach({way, 0, 0}, duration, fps), 1.0 / fps);
                    REQUIRE(j.has_value());
                    CHECK(*j == Approx(-std::log(204.8)).epsilon(fps > 500.0 ? 0.005 : 0.02));
                }
    }

    TEST_CASE("both measures give the values that their authors print for exp(-5 t^2) at 100 Hz") {
        std::vector<double> speed;
        std::vector<Vec3> positions{Vec3(0.0)};
        for (int i = 0; i < 200; ++i) {
            const double t = -1.0 + 0.01 * i;
            speed.push_back(std::exp(-5.0 * t * t));
            positions.push_back(positions.back() + 0.01 * speed.back() * Vec3(0, 0, 1));
        }
        CHECK(spectralArcLength(speed, 0.01).value() == Approx(-1.41403).epsilon(5e-6));
        CHECK(logDimensionlessJerk(positions, 0.01).value() == Approx(-5.81636).epsilon(2e-6));
    }

    TEST_CASE("they agree with NumPy on other movements") {
        const auto file = readFile(deixis::tests::sourceDir() / "tests/motion/reference/smoothness.csv");
        REQUIRE(file.has_value());
        std::istringstream lines{std::string(file->begin(), file->end())};
        int cases = 0;
        for (std::string line; std::getline(lines, line); ++cases) {
            std::istringstream cells(line);
            std::string name, cell;
            std::getline(cells, name, ',');
            std::vector<double> values;
            while (std::getline(cells, cell, ',')) values.push_back(std::stod(cell));
            INFO(name);
            std::vector<Vec3> positions;
            for (std::size_t i = 3; i + 2 < values.size(); i += 3)
                positions.emplace_back(values[i], values[i + 1], values[i + 2]);
            const double dt = 1.0 / values[0];
            CHECK(logDimensionlessJerk(positions, dt).value() == Approx(values[1]).epsilon(1e-7));
            // At 15 frames a second the reference, too, ends at half the rate.
            CHECK(spectralArcLength(speeds(positions, dt), dt).value() == Approx(values[2]).epsilon(1e-7));
        }
        CHECK(cases == 4);
    }

    TEST_CASE("smoothness is the same for a movement that is turned, moved, larger or slower") {
        auto positions = reach({0.2, 0.3, 0.4}, 0.7, 60.0);
        Random random(5);
        for (Vec3& p : positions) p += 0.01 * Vec3(random.normal(), random.normal(), random.normal());
        const double jerk = logDimensionlessJerk(positions, 1.0 / 60.0).value();
        const double arc = spectralArcLength(speeds(positions, 1.0 / 60.0), 1.0 / 60.0).value();
        std::vector<Vec3> turned;
        const Quat turn = glm::angleAxis(1.1, glm::normalize(Vec3(1, 2, -1)));
        for (const Vec3& p : positions) turned.push_back(turn * p + Vec3(4, 5, 6));
        CHECK(logDimensionlessJerk(turned, 1.0 / 60.0).value() == Approx(jerk));
        CHECK(spectralArcLength(speeds(turned, 1.0 / 60.0), 1.0 / 60.0).value() == Approx(arc));
        for (Vec3& p : turned) p = 3.0 * Vec3(-p.x, p.y, p.z);  // mirrored and larger
        CHECK(logDimensionlessJerk(turned, 1.0 / 60.0).value() == Approx(jerk));
        CHECK(spectralArcLength(speeds(turned, 1.0 / 60.0), 1.0 / 60.0).value() == Approx(arc));
        CHECK(logDimensionlessJerk(positions, 1.0 / 30.0).value() == Approx(jerk));  // half as fast
        // A smoother movement stands nearer to 0 in both.
        const auto smooth = reach({0.2, 0.3, 0.4}, 0.7, 60.0);
        CHECK(logDimensionlessJerk(smooth, 1.0 / 60.0).value() > jerk);
        CHECK(spectralArcLength(speeds(smooth, 1.0 / 60.0), 1.0 / 60.0).value() > arc);
    }

    TEST_CASE("what does not move, or is too short, has no smoothness") {
        CHECK_FALSE(logDimensionlessJerk(std::vector<Vec3>(9, Vec3(1.0)), 0.1).has_value());
        CHECK_FALSE(logDimensionlessJerk({Vec3(0.0), Vec3(1.0), Vec3(3.0)}, 0.1).has_value());
        CHECK_FALSE(spectralArcLength(std::vector<double>(9, 0.0), 0.1).has_value());
        CHECK_FALSE(spectralArcLength({1.0}, 0.1).has_value());
    }

    TEST_CASE("steadiness parts a drift from the jitter about it") {
        // 2 cm/s along x; 1 cm up and down by turns, which an even line cannot follow.
        std::vector<Vec3> positions;
        for (int i = 0; i < 40; ++i)
            positions.emplace_back(0.02 * i / 30.0, i % 4 == 0 || i % 4 == 3 ? 0.01 : -0.01, 1.5);
        const auto found = steadiness(positions, 1.0 / 30.0);
        REQUIRE(found.has_value());
        CHECK(found->drift_per_s == Approx(0.02).epsilon(1e-3));
        CHECK(found->jitter_rms == Approx(0.01).epsilon(1e-3));
        CHECK_FALSE(steadiness({Vec3(0.0), Vec3(1.0)}, 0.1).has_value());
    }

    TEST_CASE("a direction that turns steadily drifts by its turn and does not jitter") {
        std::vector<Vec3> directions;
        for (int i = 0; i < 31; ++i) {
            const double angle = radiansFromDegrees(10.0) * i / 30.0;
            directions.emplace_back(std::sin(angle), 0.0, std::cos(angle));
        }
        const auto found = directionSteadiness(directions, 1.0 / 30.0);
        REQUIRE(found.has_value());
        CHECK(degreesFromRadians(found->drift_per_s) == Approx(10.0).epsilon(1e-6));
        CHECK(found->jitter_rms < 1e-9);
    }
}
