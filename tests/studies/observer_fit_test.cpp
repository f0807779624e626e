// The fit of the simulated participant's noise and lapses: against choices that it made with known ones.
#include "studies/simulation/observer_fit.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "core/random.hpp"
#include "simulated_choice.hpp"

using namespace deixis;
using namespace deixis::studies;

namespace {

ObserverModel oneLine(double noise_deg, double lapse_rate) {
    ObserverModel model;
    model.reading = *readingFromName("eye-fingertip");
    model.noise_rad = radiansFromDegrees(noise_deg);
    model.lapse_rate = lapse_rate;
    return model;
}

ObserverModel twoCues(double noise_deg, double lapse_rate, double eye_line_share, double visual_weight) {
    ObserverModel model;
    model.noise_rad = radiansFromDegrees(noise_deg);
    model.lapse_rate = lapse_rate;
    model.eye_line_share = eye_line_share;
    model.visual_weight = visual_weight;
    return model;
}

/// An arm that points near the first of three balls, which lie 20 to 40 cm apart about two metres away: its
/// eye's line by 4 degrees or so, the arm's own line by up to 20, seen from behind, from beside or from
/// across.
SeenChoice situation(Random& random) {
    SeenChoice out;
    const Vec3 target(random.uniform(-1.0, 1.0), random.uniform(0.3, 1.9), random.uniform(1.4, 2.0));
    out.balls = {target};
    for (int i = 0; i < 2; ++i) {
        Vec3 away(random.normal(), random.normal(), random.normal());
        out.balls.push_back(target + random.uniform(0.2, 0.4) * glm::normalize(away));
    }
    const Vec3 tip(-0.2, 1.4, 0.5);
    const auto lineTo = [&](double off) {
        const Vec3 beside(random.normal(), random.normal(), random.normal());
        return Ray{tip, glm::normalize(target + off * beside - tip)};
    };
    out.arm.lines.line = lineTo(0.08);
    out.arm.lines.eye_line = out.arm.lines.line;
    out.arm.lines.arm_line = lineTo(random.uniform(0.0, 0.5));
    out.arm.observer_eye = {random.uniform(-1.5, 0.5), 1.65, random.uniform() < 0.5 ? -1.0 : 3.4};
    return out;
}

std::vector<BallView> views(const SeenChoice& seen) {
    std::vector<BallView> out(seen.balls.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[i].centre = seen.balls[i];
    return out;
}

/// Choices of the simulated participant itself.
std::vector<SeenChoice> choicesOf(std::uint64_t seed, int count, const ObserverModel& model) {
    Random random(seed, "situations");
    BallChooser chooser(model, seed);
    std::vector<SeenChoice> out;
    for (int i = 0; i < count; ++i) {
        out.push_back(situation(random));
        out.back().chosen = chooser.choose(out.back().arm, views(out.back())).place;
    }
    return out;
}

bool within(const FittedParameter& fitted, double value) {
    return (!fitted.lower || *fitted.lower <= value) && (!fitted.upper || value <= *fitted.upper);
}

}  // namespace

TEST_SUITE("studies/observer_fit") {
    TEST_CASE("The chance of each ball is the share of choices that fall on it.") {
        Random random(3);
        for (const double noise_deg : {0.5, 3.0, 12.0})
            for (const ObserverModel& model : {oneLine(noise_deg, 0.1), twoCues(noise_deg, 0.1, 0.4, 0.6)}) {
                const SeenChoice seen = situation(random);
                BallChooser chooser(model, 8);
                constexpr int draws = 20'000;
                std::vector<int> counts(3);
                const auto balls = views(seen);
                for (int i = 0; i < draws; ++i) ++counts[chooser.choose(seen.arm, balls).place];
                double sum = 0.0;
                for (std::size_t ball = 0; ball < 3; ++ball) {
                    const double p = choiceChance(model, seen.arm, seen.balls, ball);
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
        const auto choices = choicesOf(21, 150, oneLine(4.0, 0.1));
        const ObserverFit fit = fitObserver(choices, oneLine(1.0, 0.0), 0.95);
        CHECK(
            observerLogLikelihood(choices, oneLine(fit.noise_deg.value, fit.lapse_rate.value)) ==
            doctest::Approx(fit.log_likelihood).epsilon(5e-4));  // which the fit reads off a table of noises
        CHECK(fit.aic == doctest::Approx(4.0 - 2.0 * fit.log_likelihood));
        for (double noise_deg = 0.5; noise_deg < 35.0; noise_deg *= 1.15)
            for (double lapse = 0.0; lapse <= 1.0; lapse += 0.04)
                CHECK(observerLogLikelihood(choices, oneLine(noise_deg, lapse)) <= fit.log_likelihood + 0.01);
    }

    TEST_CASE("Known noise and lapses lie within their intervals about as often as the level says.") {
        constexpr int seeds = 60;
        int noise_within = 0, lapse_within = 0;
        double noise_sum = 0.0;
        for (int seed = 0; seed < seeds; ++seed) {
            const ObserverFit fit =
                fitObserver(choicesOf(100 + seed, 160, oneLine(4.0, 0.12)), oneLine(1.0, 0.0), 0.95);
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
                out.push_back(choicesOf(500 + p, 60,
                                        oneLine(4.0 * std::max(0.2, 1.0 + between * random.normal()), 0.05)));
            return out;
        };
        const PopulationFit differing = fitPopulation(participants(0.5), oneLine(1.0, 0.0));
        CHECK(differing.noise_deg == doctest::Approx(4.0).epsilon(0.15));
        CHECK(differing.noise_between == doctest::Approx(0.5).epsilon(0.4));
        CHECK(std::abs(differing.lapse_rate - 0.05) < 0.03);
        const auto alike = participants(0.0);
        const PopulationFit same = fitPopulation(alike, oneLine(1.0, 0.0));
        CHECK(same.noise_between < 0.25);
        std::vector<SeenChoice> all;
        for (const auto& choices : alike) all.insert(all.end(), choices.begin(), choices.end());
        CHECK(same.log_likelihood >=
              fitObserver(all, oneLine(1.0, 0.0), 0.95).log_likelihood - 0.01);  // one parameter more
    }
    TEST_CASE("Known weights, noise and lapses of two cues lie within their intervals.") {
        const ObserverModel truth = twoCues(4.0, 0.08, 0.7, 0.5);
        constexpr int seeds = 6;
        int noise_within = 0, lapse_within = 0, eye_within = 0, visual_within = 0;
        double noise_sum = 0.0, eye_sum = 0.0, visual_sum = 0.0;
        for (int seed = 0; seed < seeds; ++seed) {
            const auto choices = choicesOf(300 + seed, 300, truth);
            const ObserverFit fit = fitWeights(choices, twoCues(3.0, 0.02, 0.5, 0.5), 0.95);
            CHECK(fit.log_likelihood >= observerLogLikelihood(choices, truth));
            CHECK(fit.aic == doctest::Approx(8.0 - 2.0 * fit.log_likelihood));
            const ObserverModel found = twoCues(fit.noise_deg.value, fit.lapse_rate.value,
                                                fit.eye_line_share->value, fit.visual_weight->value);
            CHECK(observerLogLikelihood(choices, found) == doctest::Approx(fit.log_likelihood).epsilon(1e-9));
            noise_within += within(fit.noise_deg, 4.0);
            lapse_within += within(fit.lapse_rate, 0.08);
            eye_within += within(*fit.eye_line_share, 0.7);
            visual_within += within(*fit.visual_weight, 0.5);
            noise_sum += fit.noise_deg.value;
            eye_sum += fit.eye_line_share->value;
            visual_sum += fit.visual_weight->value;
        }
        INFO("within: noise " << noise_within << ", lapses " << lapse_within << ", eye line " << eye_within
                              << ", visual " << visual_within << " of " << seeds);
        // Fewer than 4 of 6 come once in five hundred times at the level of 95 %.
        CHECK(noise_within >= 4);
        CHECK(lapse_within >= 4);
        CHECK(eye_within >= 4);
        CHECK(visual_within >= 4);
        CHECK(noise_sum / seeds == doctest::Approx(4.0).epsilon(0.1));
        CHECK(std::abs(eye_sum / seeds - 0.7) < 0.15);
        CHECK(std::abs(visual_sum / seeds - 0.5) < 0.15);
    }

    TEST_CASE("Weights that were not fitted are taken as they are, and the right ones are likelier.") {
        const ObserverModel truth = twoCues(4.0, 0.05, 0.9, 0.3);
        const auto choices = choicesOf(77, 200, truth);
        const ObserverFit right = fitObserver(choices, truth, 0.95);
        const ObserverFit wrong = fitObserver(choices, twoCues(4.0, 0.05, 0.1, 0.3), 0.95);
        CHECK(right.log_likelihood > wrong.log_likelihood + 5.0);
        CHECK_FALSE(right.eye_line_share.has_value());
        const ObserverFit both = fitWeights(choices, truth, 0.95);
        CHECK(both.log_likelihood >= right.log_likelihood - 0.01);
        CHECK(within(*both.eye_line_share, 0.9));
    }
}
