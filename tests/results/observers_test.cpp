// Simulated observers side by side, ceilings and drift: against cases worked by hand.
#include "results/answers/observers.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "core/random.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/synthesis/generator.hpp"
#include "studies/simulation/observed_gesture.hpp"

using namespace deixis;
using namespace deixis::results;

namespace {

const Vec3 tip{0.0, 1.4, 0.6};
const Vec3 across{0.0, 1.65, 3.4};

/// From the fingertip, so many degrees to the left of straight ahead.
Ray line(double left_deg) {
    const double left = radiansFromDegrees(left_deg);
    return {tip, {std::sin(left), 0.0, std::cos(left)}};
}

Vec3 ball(double left_deg) {
    return tip + 1.5 * line(left_deg).direction;
}

studies::ArmLines arm(double eye_deg, double arm_deg) {
    return {line(eye_deg), line(arm_deg), line(90)};
}

/// The target straight ahead and a ball 12 degrees to either side.
ReadTrial trial(const char* system, const char* layout, double eye_deg, double arm_deg) {
    return {system, layout, {arm(eye_deg, arm_deg), across}, {ball(0), ball(12), ball(-12)}};
}

/// On the half-cylinder of pointing2023.
Vec3 drawTarget(Random& random) {
    const double azimuth = radiansFromDegrees(random.uniform(-85.0, 85.0));
    const double radius = random.uniform(1.9, 2.2);
    return {radius * std::sin(azimuth), random.uniform(0.1, 2.1), radius * std::cos(azimuth)};
}

NearestCeiling evenlySpread(int demonstrations) {
    Random random(11);
    std::vector<Vec3> training;
    for (int i = 0; i < demonstrations / 2; ++i) {
        training.push_back(drawTarget(random));
        training.push_back(training.back() * Vec3(-1.0, 1.0, 1.0));
    }
    std::vector<std::vector<Vec3>> balls;
    while (balls.size() < 2000) {
        std::vector<Vec3> shown{drawTarget(random)};
        while (shown.size() < 3) {
            const Vec3 other = drawTarget(random);
            const double away = glm::distance(other, shown.front());
            if (away >= 0.2 && away <= 0.4) shown.push_back(other);
        }
        balls.push_back(std::move(shown));
    }
    return nearestCeiling(balls, training, {0.0, 1.62, 0.08});
}

}  // namespace

TEST_SUITE("results/observers") {
    TEST_CASE("an arm is read right by those who read the line that is right, and by two cues either way") {
        const auto readings = readByObservers(
            {trial("by eye", "across", 0, 20), trial("by arm", "across", 20, 0)}, {"by eye", "by arm"});
        REQUIRE(readings.size() == 2);
        // In the order of observer_names: two-cue, arm-finger, eye-fingertip. Lapses take 2 % * 2/3.
        for (const ObserverReading& one : readings) {
            CHECK(one.layout == "across");
            CHECK(one.trials == 1.0);
            CHECK(one.accuracy[0] > 0.9);
            CHECK(one.without_error[0] == doctest::Approx(1.0));
        }
        const double lapsed = 0.02 / 3.0;
        CHECK(readings[0].accuracy[1] == doctest::Approx(lapsed).epsilon(0.5));
        CHECK(readings[0].without_error[1] == 0.0);
        CHECK(readings[0].accuracy[2] > 0.93);
        CHECK(readings[0].without_error[2] == 1.0);
        CHECK(readings[1].accuracy[1] == doctest::Approx(readings[0].accuracy[2]));
        CHECK(readings[1].accuracy[2] == doctest::Approx(readings[0].accuracy[1]));
        const auto rankings = observerRankings(readings);
        CHECK(rankings[0] == ObserverRanking{{"by eye", "by arm"}});  // alike, to a hundredth
        CHECK(rankings[1] == ObserverRanking{{"by arm"}, {"by eye"}});
        CHECK(rankings[2] == ObserverRanking{{"by eye"}, {"by arm"}});
    }

    TEST_CASE(
        "layouts stand by themselves and together, weighed by their answers; an unknown system nowhere") {
        auto often = trial("a", "side-by-side", 20, 20);
        often.answers = 3.0;
        const auto readings = readByObservers(
            {trial("a", "across", 0, 0), often, trial("stranger", "across", 0, 0)}, {"a", "none"});
        REQUIRE(readings.size() == 3);
        CHECK(readings[0].layout == "all");
        CHECK(readings[0].trials == 4.0);
        CHECK(readings[1].layout == "across");
        CHECK(readings[2].layout == "side-by-side");
        for (std::size_t i = 0; i < observer_names.size(); ++i)
            CHECK(readings[0].accuracy[i] ==
                  doctest::Approx((readings[1].accuracy[i] + 3.0 * readings[2].accuracy[i]) / 4.0));
        CHECK(readings[0].without_error[2] == 0.25);
    }

    TEST_CASE("what nearest demonstrations can reach: worked by hand") {
        const Vec3 eye{0.0, 1.6, 0.0};
        const std::vector<Vec3> balls{{0.0, 1.6, 2.0}, {0.3, 1.6, 2.0}, {-0.3, 1.6, 2.0}};
        const auto ceiling = [&](const Vec3& demonstrated) {
            return nearestCeiling({balls}, {demonstrated, Vec3(0.0, 9.0, 0.0)}, eye);
        };
        CHECK(ceiling(balls[0]).share_right == 1.0);
        CHECK(ceiling(balls[0]).median_distance_m == 0.0);
        CHECK(ceiling({0.1, 1.6, 2.0}).share_right == 1.0);
        CHECK(ceiling({0.1, 1.6, 2.0}).median_distance_m == doctest::Approx(0.1));
        CHECK(ceiling({0.2, 1.6, 2.0}).share_right == 0.0);  // nearer to the ball at 0.3
        // Nearer in space to a distractor, but on the target's line as the pointer sees it.
        CHECK(ceiling({0.0, 1.6, 2.6}).share_right == 1.0);
        const auto both = nearestCeiling({balls, {balls[1], balls[0], balls[2]}}, {balls[0]}, eye);
        CHECK(both.targets == 2);
        CHECK(both.share_right == 0.5);
        CHECK(both.median_distance_m == doctest::Approx(0.15));
    }

    // Points on a thick surface: with the square root of their number on a plane, with the cube root in a
    // room.
    TEST_CASE(
        "with twice as many demonstrations the nearest is nearer by a root of two, and more are right") {
        const NearestCeiling few = evenlySpread(104);
        const NearestCeiling more = evenlySpread(208);
        const NearestCeiling many = evenlySpread(4000);
        const double nearer = more.median_distance_m / few.median_distance_m;
        CHECK(nearer > std::pow(2.0, -1.0 / 2.0) - 0.1);
        CHECK(nearer < std::pow(2.0, -1.0 / 3.0) + 0.1);
        CHECK(few.share_right > 1.0 / 3.0);
        CHECK(more.share_right > few.share_right);
        CHECK(many.share_right > more.share_right);
        CHECK(many.share_right < 1.0);
    }

    TEST_CASE(
        "the built-in systems' arms are read by their eye's line, and no better than chance by their own") {
        std::vector<ReadTrial> trials;
        // Of who reads the eye's line where it runs through the target: a reading that is off by normal noise
        // across the line is right where it stays on the near side of the middle between the target and each
        // other ball; and a share of choices is made at random.
        const studies::ObserverModel observer;
        std::map<std::string, double> expected;
        Random noise(5);
        for (const std::string& system : motion::generatorNames()) {
            const auto generator = motion::makeGenerator(system, motion::referenceHumanoid(), {});
            REQUIRE(generator.has_value());
            Random random(2024);
            for (std::uint64_t seed = 1; seed <= 100; ++seed) {
                std::vector<Vec3> balls{drawTarget(random)};
                while (balls.size() < 3) {
                    const Vec3 other = drawTarget(random);
                    const double away = glm::distance(other, balls.front());
                    if (away >= 0.2 && away <= 0.4) balls.push_back(other);
                }
                const auto gesture =
                    studies::observeGesture((*generator)->generate({"T", balls.front(), seed, {}}).clip, {});
                REQUIRE(gesture.has_value());
                trials.push_back({system, "across", {gesture->hold, across}, balls});
                const Vec3 eye = gesture->hold.eye_line.origin;
                const Vec3 ahead = glm::normalize(balls[0] - eye);
                int right = 0;
                constexpr int draws = 500;
                for (int k = 0; k < draws; ++k) {
                    const Vec3 any(noise.normal(), noise.normal(), noise.normal());
                    const Vec3 off = observer.noise_rad * (any - glm::dot(any, ahead) * ahead);
                    right += std::all_of(balls.begin() + 1, balls.end(), [&](const Vec3& other) {
                        const Vec3 there = glm::normalize(other - eye);
                        const Vec3 beside = glm::normalize(there - glm::dot(there, ahead) * ahead);
                        return glm::dot(off, beside) < 0.5 * std::acos(glm::dot(ahead, there));
                    });
                }
                expected[system] +=
                    (1.0 - observer.lapse_rate) * right / draws / 100.0 + observer.lapse_rate / 300.0;
            }
        }
        const auto readings = readByObservers(trials, motion::generatorNames());
        REQUIRE(readings.size() == 5);
        std::map<std::string, double> found;
        for (const ObserverReading& one : readings) {
            CAPTURE(one.system);
            const double two_cue = one.accuracy[0], arm = one.accuracy[1], eye = one.accuracy[2];
            CHECK(arm < 0.5);
            if (one.system == "direct" || one.system == "stiff") {
                CHECK(std::abs(eye - expected[one.system]) < 0.02);
                CHECK(one.without_error[2] == 1.0);
            } else if (one.system == "gp") {
                CHECK(std::abs(eye - expected[one.system]) < 0.1);  // it is off by a degree
            } else {
                CHECK(eye < expected[one.system] - 0.1);
            }
            CHECK(two_cue > arm);
            found[one.system] = eye;
        }
        CHECK(found["drifting"] < found["demonstration-nn"]);
        CHECK(found["demonstration-nn"] < found["gp"]);
    }

    TEST_CASE("choices by the ball nearest when the hold began and when it ended") {
        const auto choice = [](int chosen, double first_deg, double last_deg) {
            return ObservedChoice{trial("a", "across", 0, 0), chosen, arm(0, first_deg), arm(0, last_deg)};
        };
        // Ball 0 at 0 degrees, 1 at 12, 2 at -12: the arm's line goes from 12 to 0 in three, stays in one.
        const auto drift =
            countDrift({choice(1, 12, 0), choice(0, 12, 0), choice(2, 12, 0), choice(0, 1, -1)}, {"a", "b"});
        REQUIRE(drift.size() == 2);
        CHECK(drift[0].line == "arm-finger");
        CHECK(drift[0].choices == 4);
        CHECK(drift[0].of_first == 2);
        CHECK(drift[0].of_last == 2);
        CHECK(drift[0].moved == 3);
        CHECK(drift[0].moved_first == 1);
        CHECK(drift[0].moved_last == 1);
        CHECK(drift[1].line == "eye-fingertip");
        CHECK(drift[1].moved == 0);
        CHECK(drift[1].of_first == 2);
    }
}
