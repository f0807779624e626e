// The fit of the simulated participant's noise and lapses: against choices that it made with known ones.
#include "studies/observer_fit.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/random.hpp"
#include "simulated_choice.hpp"

using namespace deixis;
using namespace deixis::studies;

namespace {

/// An arm that points near the first of three balls, which lie 20 to 40 cm apart about two metres away.
SeenChoice situation(Random& random) {
    SeenChoice out;
    const Vec3 target(random.uniform(-1.0, 1.0), random.uniform(0.3, 1.9), random.uniform(1.4, 2.0));
    out.balls = {target};
    for (int i = 0; i < 2; ++i) {
        Vec3 away(random.normal(), random.normal(), random.normal());
        out.balls.push_back(target + random.uniform(0.2, 0.4) * glm::normalize(away));
    }
    out.ray.origin = {-0.2, 1.4, 0.5};
    const Vec3 off(random.normal(), random.normal(), random.normal());
    out.ray.direction = glm::normalize(target + 0.08 * off - out.ray.origin);
    return out;
}

std::vector<BallView> views(const SeenChoice& seen) {
    std::vector<BallView> out(seen.balls.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[i].centre = seen.balls[i];
    return out;
}

/// Choices of the simulated participant itself.
std::vector<SeenChoice> choicesOf(std::uint64_t seed, int count, double noise_deg, double lapse_rate) {
    Random random(seed, "situations");
    BallChooser chooser(radiansFromDegrees(noise_deg), lapse_rate, seed);
    std::vector<SeenChoice> out;
    for (int i = 0; i < count; ++i) {
        out.push_back(situation(random));
        SeenGesture gesture;
        gesture.ray = out.back().ray;
        out.back().chosen = chooser.choose(gesture, views(out.back())).place;
    }
    return out;
}

bool within(const FittedParameter& fitted, double value) {
    return (!fitted.lower || *fitted.lower <= value) && (!fitted.upper || value <= *fitted.upper);
}

}  // namespace

TEST_SUITE("studies/observer_fit") {
    TEST_CASE("The probability of each ball is the share of choices that fall on it.") {
        Random random(3);
        for (const double noise_deg : {0.5, 3.0, 12.0}) {
            SeenChoice seen = situation(random);
            BallChooser chooser(radiansFromDegrees(noise_deg), 0.0, 8);
            SeenGesture gesture;
            gesture.ray = seen.ray;
            constexpr int draws = 20'000;
            std::vector<int> counts(3);
            const auto balls = views(seen);
            for (int i = 0; i < draws; ++i) ++counts[chooser.choose(gesture, balls).place];
            double sum = 0.0;
            for (std::size_t ball = 0; ball < 3; ++ball) {
                const double p = ballProbability(seen, ball, radiansFromDegrees(noise_deg));
                const double share = static_cast<double>(counts[ball]) / draws;
                INFO(noise_deg << " degrees, ball " << ball << ": " << p << ", drawn " << share);
                CHECK(std::abs(p - share) <
                      4.0 * std::sqrt(std::max(p * (1.0 - p), 1.0 / draws) / draws) + 1e-3);
                sum += p;
            }
            CHECK(sum == doctest::Approx(1.0).epsilon(1e-6));
        }
    }

    TEST_CASE("No point of a grid is more likely than what was fitted.") {
        const auto choices = choicesOf(21, 150, 4.0, 0.1);
        const ObserverFit fit = fitObserver(choices, 0.95);
        CHECK(observerLogLikelihood(choices, fit.noise_deg.value, fit.lapse_rate.value) ==
              doctest::Approx(fit.log_likelihood).epsilon(1e-4));
        CHECK(fit.aic == doctest::Approx(4.0 - 2.0 * fit.log_likelihood));
        for (double noise_deg = 0.5; noise_deg < 35.0; noise_deg *= 1.15)
            for (double lapse = 0.0; lapse <= 1.0; lapse += 0.04)
                CHECK(observerLogLikelihood(choices, noise_deg, lapse) <= fit.log_likelihood + 0.01);
    }

    TEST_CASE("Known noise and lapses lie within their intervals about as often as the level says.") {
        constexpr int seeds = 60;
        int noise_within = 0, lapse_within = 0;
        double noise_sum = 0.0;
        for (int seed = 0; seed < seeds; ++seed) {
            const ObserverFit fit = fitObserver(choicesOf(100 + seed, 160, 4.0, 0.12), 0.95);
            noise_within += within(fit.noise_deg, 4.0);
            lapse_within += within(fit.lapse_rate, 0.12);
            noise_sum += fit.noise_deg.value;
        }
        INFO("noise within " << noise_within << ", lapses within " << lapse_within << " of " << seeds);
        // 57 expected; fewer than 51 of 60 come once in a hundred times at the level of 95 %.
        CHECK(noise_within >= 51);
        CHECK(lapse_within >= 51);
        CHECK(noise_within + lapse_within < 2 * seeds);  // an interval that always covers says nothing
        CHECK(noise_sum / seeds == doctest::Approx(4.0).epsilon(0.08));
    }

    TEST_CASE("How much participants differ in noise comes back, and none where they do not differ.") {
        const auto participants = [](double between) {
            Random random(5, "participants");
            std::vector<std::vector<SeenChoice>> out;
            for (int p = 0; p < 40; ++p)
                out.push_back(
                    choicesOf(500 + p, 60, 4.0 * std::max(0.2, 1.0 + between * random.normal()), 0.05));
            return out;
        };
        const PopulationFit differing = fitPopulation(participants(0.5));
        CHECK(differing.noise_deg == doctest::Approx(4.0).epsilon(0.15));
        CHECK(differing.noise_between == doctest::Approx(0.5).epsilon(0.4));
        CHECK(std::abs(differing.lapse_rate - 0.05) < 0.03);
        const auto alike = participants(0.0);
        const PopulationFit same = fitPopulation(alike);
        CHECK(same.noise_between < 0.25);
        std::vector<SeenChoice> all;
        for (const auto& choices : alike) all.insert(all.end(), choices.begin(), choices.end());
        CHECK(same.log_likelihood >= fitObserver(all, 0.95).log_likelihood - 0.01);  // one parameter more
    }
}
