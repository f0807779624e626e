// What the evaluation's figures are told to draw, against the evaluation and by hand. That it is drawn:
// tests/browser.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/random.hpp"
#include "results/evaluation/evaluation.hpp"
#include "results/statistics/descriptive.hpp"
#include "specifications.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;
using deixis::tests::specificationsOf;
using deixis::tests::valuesWith;
using nlohmann::json;

namespace {

/// Systems "one" and "two" at the same grid of `sides`^3 places; accuracies are drawn, those of "two" lower.
Evaluation ofGrid(int sides) {
    EvaluationInput input;
    Random random(7);
    for (const std::string system : {"one", "two"})
        for (int i = 0; i < sides * sides * sides; ++i) {
            MeasuredClip& clip = input.clips.emplace_back();
            clip.system = system;
            clip.clip = system + std::to_string(i);
            clip.target_id = "G" + std::to_string(i);
            const double step = 1.0 / (sides - 1);
            clip.target = {-1.0 + 2.0 * step * (i % sides), 0.5 + step * (i / sides % sides),
                           1.0 + step * (i / sides / sides)};
            clip.hand = clip.target.x > 0.0 ? motion::Side::left : motion::Side::right;
            const double reward = 0.6 - 0.2 * random.uniform() - (system == "two" ? 0.02 : 0.0);
            clip.accuracy = motion::PointingAccuracy{reward, 0.1, 30};
            clip.profile.first_step = -1;
            clip.profile.reward = {0.1, reward, 0.3};
            clip.profile.speed_m_s = {1.0, 0.2 * random.uniform(), 0.4};
        }
    input.training = {{0.9, 1.0, 2.0}, {0.7, 1.3, 1.6}, {-0.8, 0.8, 1.9}, {-0.9, 1.1, 1.2}};
    input.mean_shift_bandwidth = 1.0;
    auto evaluation = evaluate(std::move(input));
    REQUIRE_MESSAGE(evaluation, evaluation.error().text());
    return std::move(*evaluation);
}

std::vector<json> valuesOf(const json& spec, const std::string& mark) {
    std::vector<json> found;
    for (const json& layer : spec["layer"])
        if (layer["mark"]["type"] == mark && layer.contains("data"))
            for (const json& value : layer["data"]["values"]) found.push_back(value);
    return found;
}

bool near(double a, double b) {
    return std::abs(a - b) <= 1e-3 * std::max(1e-3, std::abs(b));  // figures have four digits
}

}  // namespace

TEST_SUITE("results/evaluation_figures") {
    TEST_CASE("Boxes draw the quantiles of all clips, and points of all, or of a hundred with both ends") {
        for (const auto& grid : {std::pair{3, 27}, std::pair{6, 100}}) {
            const int sides = grid.first;
            const int points = grid.second;
            CAPTURE(sides);
            const Evaluation evaluation = ofGrid(sides);
            const std::string page = renderEvaluation(evaluation);
            const json spec = specificationsOf(page).at("accuracy");
            const auto corners = valuesWith(spec, "corner");
            const auto drawn = valuesOf(spec, "circle");
            for (int i = 0; i < 2; ++i) {
                const std::vector<double>& rewards = evaluation.systems[static_cast<std::size_t>(i)].rewards;
                const auto box = *boxSummary(rewards);
                for (const double height : {box.q25, box.median, box.q75, box.notch_low, box.notch_high})
                    CHECK(std::any_of(corners.begin(), corners.end(), [&](const json& corner) {
                        return corner["box"] == i && corner["y"] == height;
                    }));
                std::vector<double> heights;
                for (const json& point : drawn)
                    if (std::abs(point["x"].get<double>() - i) < 0.5)
                        heights.push_back(point["y"].get<double>());
                REQUIRE(heights.size() == static_cast<std::size_t>(points));
                const auto [min, max] = std::minmax_element(rewards.begin(), rewards.end());
                CHECK(*std::min_element(heights.begin(), heights.end()) == *min);
                CHECK(*std::max_element(heights.begin(), heights.end()) == *max);
                // The points' quantiles are those of all.
                CHECK(std::abs(quantile(heights, 0.5) - box.median) < 0.005);
                CHECK(std::abs(quantile(heights, 0.25) - box.q25) < 0.005);
            }
            CHECK(contains(page, "Points: at most 100 of a system") == (points == 100));
            // The ceiling, and as many angles as have room: Equation 2 of 30 degrees is (e^(5/6) - 1)/e.
            const auto levels = valuesWith(spec, "words");
            REQUIRE(levels.front()["words"] == "0\u00b0");
            CHECK(levels.front()["y"].get<double>() ==
                  doctest::Approx((std::exp(1.0) - 1.0) / std::exp(1.0)));
            const auto thirty = std::find_if(levels.begin(), levels.end(),
                                             [](const json& level) { return level["words"] == "30\u00b0"; });
            REQUIRE(thirty != levels.end());
            CHECK((*thirty)["y"].get<double>() ==
                  doctest::Approx((std::exp(5.0 / 6.0) - 1.0) / std::exp(1.0)));
        }
    }

    TEST_CASE("Differences are drawn with the test's estimate and interval, thinned where there are many") {
        for (const auto& [sides, points] : {std::pair{3, 27}, std::pair{6, 100}}) {
            const Evaluation evaluation = ofGrid(sides);
            const std::string page = renderEvaluation(evaluation);
            const json spec = specificationsOf(page).at("differences");
            const SystemComparison& pair = evaluation.comparisons.front();
            CHECK(pair.differences.size() == static_cast<std::size_t>(sides * sides * sides));
            CHECK(mean(pair.differences) == doctest::Approx(pair.mean_difference));
            CHECK(valuesOf(spec, "circle").size() == static_cast<std::size_t>(points));
            const json shift = valuesWith(spec, "low").front();
            CHECK(shift["x"] == *pair.test.hodges_lehmann.estimate);
            CHECK(shift["low"] == *pair.test.hodges_lehmann.lower);
            CHECK(shift["high"] == *pair.test.hodges_lehmann.upper);
            CHECK(contains(page, "At most 100 points per pair") == (points == 100));
        }
    }

    TEST_CASE("Profiles draw mean and band of each hand at each step, on one scale") {
        const Evaluation evaluation = ofGrid(3);
        const auto figures = specificationsOf(renderEvaluation(evaluation));
        for (const auto& [kind, top] : {std::pair{"reward", 0.65}, std::pair{"speed", 1.0}})
            for (std::size_t i = 0; i < 2; ++i) {
                const json& spec = figures.at(kind + std::string("-") + std::to_string(i + 1));
                const SystemEvaluation& system = evaluation.systems[i];
                const bool reward = kind == std::string("reward");
                std::vector<ProfilePoint> wanted = system.right.points;
                wanted.insert(wanted.end(), system.left.points.begin(), system.left.points.end());
                const json& values = spec["data"]["values"];
                REQUIRE(values.size() == wanted.size());
                for (std::size_t k = 0; k < wanted.size(); ++k) {
                    const double centre = reward ? wanted[k].reward_mean : wanted[k].speed_mean;
                    const double sd = reward ? wanted[k].reward_sd : wanted[k].speed_sd;
                    CHECK(near(values[k]["t"], wanted[k].time_s));
                    CHECK(near(values[k]["mean"], centre));
                    CHECK(near(values[k]["low"], std::max(0.0, centre - sd)));
                    CHECK(near(values[k]["high"], centre + sd));
                    CHECK(values[k]["hand"] ==
                          (k < system.right.points.size()
                               ? "right hand (" + std::to_string(system.right.clips) + ")"
                               : "left hand (" + std::to_string(system.left.clips) + ")"));
                }
                for (const json& layer : spec["layer"])
                    if (layer["encoding"].contains("y") && layer["encoding"]["y"].contains("scale"))
                        CHECK(layer["encoding"]["y"]["scale"]["domain"] == json{0.0, top});
            }
    }

    TEST_CASE(
        "Clips stand at their density and accuracy, at most five hundred; diamonds are medians of tenths") {
        const Evaluation evaluation = ofGrid(9);
        const std::string page = renderEvaluation(evaluation);
        const json spec = specificationsOf(page).at("density-2");
        const SystemEvaluation& system = evaluation.systems[1];
        const auto points = valuesOf(spec, "circle");
        CHECK(points.size() == 500);
        CHECK(contains(page, "500 of 729 clips are drawn, evenly along the density."));
        for (const json& point : points) {
            const auto tip = point["tip"].get<std::string>();  // two123: 0.512 (5.7 degrees)
            const auto i = static_cast<std::size_t>(std::stoi(tip.substr(3)));
            CHECK(near(point["x"], system.densities[i]));
            CHECK(near(point["y"], system.rewards[i]));
        }
        const auto tenths = valuesOf(spec, "line");
        REQUIRE(tenths.size() == 10);
        std::vector<std::pair<double, double>> clips;
        for (std::size_t i = 0; i < system.rewards.size(); ++i)
            clips.emplace_back(system.densities[i], system.rewards[i]);
        std::stable_sort(clips.begin(), clips.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<double> lowest;
        for (std::size_t i = 0; i < 72; ++i) lowest.push_back(clips[i].second);  // floor(729 / 10)
        CHECK(near(tenths.front()["y"], quantile(lowest, 0.5)));
        const json few = specificationsOf(renderEvaluation(ofGrid(3))).at("density-1");
        CHECK(valuesOf(few, "circle").size() == 27);
        CHECK(valuesOf(few, "line").empty());
    }

    TEST_CASE("A map's cells are means over the third axis: left on the left, ahead and up are up") {
        EvaluationInput input;
        for (int i = 0; i < 8; ++i) {
            MeasuredClip& clip = input.clips.emplace_back();
            clip.system = "only";
            clip.clip = clip.target_id = std::to_string(i);
            clip.target = {(i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.5 : 0.5, (i & 4) != 0 ? 2.0 : 1.0};
            // Higher by 0.1 at the left, by 0.02 above and by 0.004 ahead.
            clip.accuracy =
                motion::PointingAccuracy{0.4 + 0.1 * (i & 1) + 0.01 * (i & 2) + 0.001 * (i & 4), 0.1, 30};
        }
        input.training = {{1.0, 1.0, 2.0}, {1.2, 1.3, 2.1}, {-1.0, 0.8, 1.9}, {-1.3, 1.1, 2.2}};
        input.mean_shift_bandwidth = 1.0;
        const auto evaluation = evaluate(std::move(input));
        REQUIRE(evaluation);
        const std::string page = renderEvaluation(*evaluation);
        const auto figures = specificationsOf(page);
        CHECK_FALSE(figures.contains("differences"));
        const auto cells = valuesWith(figures.at("accuracy-map"), "mean");
        REQUIRE(cells.size() == 8);
        // From above: x is 0 to 1, its left half the agent's left; y counts downwards.
        const std::vector<std::tuple<double, double, double>> wanted{
            {0.0, 0.0, 0.514},   // left, ahead: 0.4 + 0.1 + 0.02/2 + 0.004
            {0.0, 0.43, 0.51},   // left, near
            {0.5, 0.0, 0.414},   // right, ahead
            {0.5, 0.43, 0.41},   // right, near
            {1.08, 0.0, 0.522},  // left, up: 0.4 + 0.1 + 0.02 + 0.004/2
            {1.08, 0.43, 0.502}, {1.58, 0.0, 0.422}, {1.58, 0.43, 0.402}};
        for (const auto& one : wanted) {
            const double x = std::get<0>(one);
            const double y = std::get<1>(one);
            const double value = std::get<2>(one);
            CAPTURE(value);
            const auto found = std::find_if(cells.begin(), cells.end(), [&](const json& cell) {
                return std::abs(cell["mean"].get<double>() - value) < 1e-6;
            });
            REQUIRE(found != cells.end());
            CHECK((*found)["x"].get<double>() == doctest::Approx(x));
            CHECK((*found)["x2"].get<double>() == doctest::Approx(x + 0.5));
            CHECK((*found)["y"].get<double>() == doctest::Approx(y - 0.43));
            CHECK((*found)["y2"].get<double>() == doctest::Approx(y));
        }
        // Of the density the same cells, and each training target in both views.
        CHECK(valuesWith(figures.at("density-map"), "mean").size() == 8);
        CHECK(valuesOf(figures.at("density-map"), "point").size() == 8);
    }

    TEST_CASE("Of the test points in space the nearer are drawn after the farther") {
        const Evaluation evaluation = ofGrid(3);
        const auto points =
            valuesWith(specificationsOf(renderEvaluation(evaluation)).at("density-space"), "density");
        REQUIRE(points.size() == 27);
        CHECK(contains(points.front()["tip"].get<std::string>(), "at -1.00, 0.50, 1.00 m"));
        CHECK(contains(points.back()["tip"].get<std::string>(), "at 1.00, 1.50, 2.00 m"));
        for (const json& point : points) {
            const auto tip = point["tip"].get<std::string>();  // G12: ...
            const auto i = static_cast<std::size_t>(std::stoi(tip.substr(1)));
            CHECK(near(point["density"], evaluation.points[i].density));
        }
    }
}
