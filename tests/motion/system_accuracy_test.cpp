// The table "How accurate they are" of docs/systems.md.
#include <doctest/doctest.h>

#include <string>

#include "pointing_checks.hpp"

using namespace deixis;
using namespace deixis::motion;
using namespace deixis::tests;

namespace {

/// Games against two distractors 20-40 cm away on the same half-cylinder, for an observer who reads the line
/// from eye to fingertip with 4 degrees of noise an axis.
bool wins(const Ray& read, const Vec3& target, Random& random) {
    std::vector<Vec3> balls{target};
    while (balls.size() < 3) {
        const Vec3 ball = drawTarget(random);
        const double away = glm::length(ball - target);
        if (away >= 0.2 && away <= 0.4) balls.push_back(ball);
    }
    const double noise = radiansFromDegrees(4.0);
    const Vec3 across = glm::normalize(glm::cross(read.direction, up));
    const Vec3 above = glm::cross(across, read.direction);
    const double a = noise * random.normal(), b = noise * random.normal();
    const Ray noisy{read.origin, glm::normalize(read.direction + a * across + b * above)};
    return chosenBall(noisy, balls)->ball == 0;
}

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size()))];
}

}  // namespace

TEST_SUITE("motion/system_accuracy") {
    TEST_CASE("the systems are as accurate as their page says") {
        const struct {
            const char* system;
            double eye, eye_90, index, forearm, won_percent;
        } rows[] = {{"demonstration-nn", 7.7, 16.7, 19.2, 17.8, 62.0},
                    {"direct", 0.2, 0.3, 0.3, 28.4, 85.0},
                    {"stiff", 0.0, 0.0, 0.3, 32.0, 85.0},
                    {"drifting", 20.8, 32.4, 23.1, 21.6, 37.0}};
        for (const auto& row : rows) {
            CAPTURE(std::string(row.system));
            const auto generator = makeGenerator(row.system, referenceHumanoid(), {});
            REQUIRE(generator.has_value());
            std::vector<double> eye, index, forearm;
            Random random(99, "observer");
            constexpr int games_each = 5;
            int won = 0;
            std::uint64_t seed = 1;
            for (const Vec3& target : drawTargets(400, 2024)) {
                const GeneratedClip made = (*generator)->generate({"T", target, seed++});
                eye.push_back(errorDeg(made, target));
                index.push_back(errorDeg(made, target, PointingRay::index_finger));
                forearm.push_back(errorDeg(made, target, PointingRay::forearm));
                for (int game = 0; game < games_each; ++game) won += wins(eyeRay(made), target, random);
            }
            CHECK(std::abs(quantile(eye, 0.5) - row.eye) < 0.1);
            CHECK(std::abs(quantile(eye, 0.9) - row.eye_90) < 0.1);
            CHECK(std::abs(quantile(index, 0.5) - row.index) < 0.1);
            CHECK(std::abs(quantile(forearm, 0.5) - row.forearm) < 0.1);
            CHECK(std::abs(won / (4.0 * games_each) - row.won_percent) < 2.0);
        }
    }
}
