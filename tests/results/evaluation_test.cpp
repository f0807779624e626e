#include "results/evaluation/evaluation.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "core/files.hpp"
#include "core/random.hpp"
#include "paths.hpp"
#include "results/statistics/descriptive.hpp"
#include "text.hpp"
#include "xml.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;

namespace {

/// Four training targets before the agent, in two groups far from each other.
std::vector<Vec3> training() {
    return {{1.0, 1.0, 2.0}, {1.2, 1.3, 2.1}, {-1.0, 0.8, 1.9}, {-1.3, 1.1, 2.2}};
}

MeasuredClip clipOf(const std::string& system, int i, const Vec3& target, std::optional<double> reward) {
    MeasuredClip clip;
    clip.system = system;
    clip.clip = system + std::to_string(i) + ".bvh";
    clip.target_id = "G" + std::to_string(i);
    clip.target = target;
    clip.hand = target.x > 0.0 ? motion::Side::left : motion::Side::right;
    if (reward) clip.accuracy = motion::PointingAccuracy{*reward, 0.1 * i, 30 + i};
    clip.profile.first_step = -1;
    clip.profile.reward = {0.1, reward.value_or(0.2), 0.1 * i};
    clip.profile.speed_m_s = {1.0, 0.2, 0.4};
    return clip;
}

/// Two systems at the same four places; "b" misses one.
EvaluationInput small() {
    EvaluationInput input;
    const std::vector<Vec3> places{{1.1, 1.1, 2.0}, {-1.1, 1.0, 2.0}, {0.0, 0.2, 1.0}, {0.5, 1.5, 2.2}};
    for (int i = 0; i < 4; ++i)
        input.clips.push_back(
            clipOf("a <&> \"1\"", i + 1, places[static_cast<std::size_t>(i)], 0.5 + 0.02 * i));
    for (int i = 0; i < 4; ++i)
        input.clips.push_back(clipOf("b", i + 1, places[static_cast<std::size_t>(i)],
                                     i == 2 ? std::optional<double>() : 0.6 - 0.01 * i));
    input.synthetic_systems = {"b"};
    input.training = training();
    input.training_source = "training.csv";
    input.mean_shift_bandwidth = 1.0;
    input.program = "deixis 1";
    input.files = {{"m.csv", std::string(64, 'a')}};
    return input;
}

Evaluation evaluated(EvaluationInput input) {
    auto evaluation = evaluate(std::move(input));
    REQUIRE_MESSAGE(evaluation, evaluation.error().text());
    return std::move(*evaluation);
}

}  // namespace

TEST_SUITE("results/evaluation") {
    TEST_CASE("Means, missing clips, correlations and clusters of a small case worked by hand") {
        const Evaluation evaluation = evaluated(small());
        REQUIRE(evaluation.systems.size() == 2);
        const SystemEvaluation& a = evaluation.systems[0];
        const SystemEvaluation& b = evaluation.systems[1];
        CHECK(a.system == "a <&> \"1\"");
        CHECK_FALSE(a.synthetic);
        CHECK(b.synthetic);
        CHECK(a.rewards == std::vector<double>{0.5, 0.52, 0.54, 0.56});
        CHECK(mean(a.rewards) == doctest::Approx(0.53));
        CHECK(a.missing == 0);
        CHECK(b.missing == 1);
        CHECK(b.rewards.size() == 3);
        CHECK(a.left_hand == 2);
        CHECK(a.errors_deg[1] == doctest::Approx(0.2 * 180.0 / pi));
        // Density falls from the place beside two training targets to the one beside nothing.
        REQUIRE(evaluation.points.size() == 4);
        for (const auto& point : evaluation.points)
            CHECK(point.density ==
                  doctest::Approx((*GaussianDensity::fit(
                      {{1.0, 1.0, 2.0}, {1.2, 1.3, 2.1}, {-1.0, 0.8, 1.9}, {-1.3, 1.1, 2.2}},
                      BandwidthRule::normal_reference))({point.target.x, point.target.y, point.target.z})));
        CHECK(a.correlation.n == 4);
        CHECK(b.correlation.n == 3);
        CHECK(b.densities == std::vector<double>{evaluation.points[0].density, evaluation.points[1].density,
                                                 evaluation.points[3].density});
        REQUIRE(evaluation.clusters.size() == 2);
        const std::size_t left = evaluation.clusters[0].centre.x > 0.0 ? 0 : 1;
        CHECK(evaluation.clusters[left].centre.x == doctest::Approx(1.1));
        CHECK(evaluation.clusters[left].training_targets == 2);
        CHECK(evaluation.clusters[left].test_points == 2);  // the middle lies nearest to (-1, 0.8, 1.9)
        CHECK(*a.cluster_means[left] == doctest::Approx(0.5 * (0.5 + 0.56)));
        CHECK(*b.cluster_means[1 - left] == doctest::Approx(0.59));
        REQUIRE(evaluation.remarks.size() == 1);
        CHECK(contains(evaluation.remarks[0], "b: 1 clip of 4 has no accuracy"));
    }

    TEST_CASE("Profiles are means by hand at the steps that half of the clips have") {
        EvaluationInput input = small();
        input.clips[0].profile.first_step = 0;  // the left hand's first clip begins a step later
        const Evaluation evaluation = evaluated(std::move(input));
        const HandProfile& left = evaluation.systems[0].left;
        CHECK(left.clips == 2);  // targets 1 and 4
        REQUIRE(left.points.size() == 4);
        CHECK(left.points[0].time_s == doctest::Approx(-0.05));
        CHECK(left.points[0].n == 1);
        CHECK(left.points[1].n == 2);
        CHECK(left.points[1].reward_mean == doctest::Approx(0.5 * (0.1 + 0.56)));
        CHECK(left.points[1].reward_sd == doctest::Approx(0.46 / std::sqrt(2.0)));
        CHECK(left.points[2].speed_mean == doctest::Approx(0.5 * (0.2 + 0.4)));
        const HandProfile& right = evaluation.systems[0].right;
        CHECK(right.clips == 2);
        CHECK(right.points.size() == 3);
    }

    TEST_CASE("The page is well formed, self-contained, escaped and says what is synthetic") {
        EvaluationInput input = small();
        input.training_synthetic = true;
        const Evaluation evaluation = evaluated(std::move(input));
        const std::string html = renderEvaluation(evaluation);
        const deixis::tests::XmlDocument page(html);
        // Its one script stands in it; the rest are the figures' specifications.
        CHECK(page.count("//h:link | //h:img | //@src | //@href[not(starts-with(., '#'))]") == 0);
        CHECK(page.count("//h:script[not(@type)]") == 1);
        // Accuracy, differences, reward and speed of two systems, four of the density, maps of accuracy.
        CHECK(page.count("//h:figure[@aria-label != ''][h:figcaption][h:script[@type='application/json']]") ==
              11);
        CHECK(page.count("//@id[. = preceding::*/@id]") == 0);
        CHECK(page.count("//*[@class='synthetic']") > 0);
        const std::string text = page.text();
        CHECK(contains(text, "a <&> \"1\""));
        CHECK(contains(text, "Synthetic: b is made by formulas"));
        CHECK(contains(text, "the training targets are those of this program's synthetic demonstrations") ==
              false);
        CHECK(contains(text, "The training targets are those of this program's synthetic demonstrations"));
        CHECK(contains(text, "0.530"));
        CHECK(contains(text, std::string(64, 'a')));
        CHECK_FALSE(contains(html.substr(0, html.find("<noscript>")), "nan"));
        CHECK(html == renderEvaluation(evaluated([] {
                  EvaluationInput again = small();
                  again.training_synthetic = true;
                  return again;
              }())));
        EvaluationInput real = small();
        real.synthetic_systems.clear();
        CHECK(deixis::tests::XmlDocument(renderEvaluation(evaluated(std::move(real))))
                  .count("//*[@class='synthetic']") == 0);
    }

    TEST_CASE("JSON and CSV carry the same numbers, with null and empty cells for what is missing") {
        const Evaluation evaluation = evaluated(small());
        const auto json = nlohmann::json::parse(evaluationJson(evaluation));
        CHECK(json["format"] == "deixis-evaluation");
        CHECK(json["version"] == 2);
        CHECK(json["systems"][1]["missing"] == 1);
        CHECK(json["systems"][0]["accuracy"]["mean"].get<double>() == doctest::Approx(0.53));
        CHECK(json["systems"][0]["density_correlation"]["method"] == "exact");
        CHECK(json["settings"]["bandwidth_rule"] == "normal-reference");
        CHECK(json["training"]["targets"].size() == 4);
        CHECK(json["targets"].size() == 4);
        CHECK(json["targets"][1]["accuracy"]["b"].get<double>() == doctest::Approx(0.59));
        CHECK(json["targets"][2]["accuracy"].size() == 1);  // "b" has none there
        const auto tables = evaluationTables(evaluation);
        REQUIRE(tables.size() == 7);
        const std::vector<std::size_t> rows{9, 3, 2, 13, 5, 3, 1};  // with the header
        for (std::size_t i = 0; i < tables.size(); ++i) {
            CAPTURE(tables[i].first);
            const auto records = parseCsv(tables[i].second, tables[i].first);
            REQUIRE(records);
            CHECK(records->size() == rows[i]);
            CHECK(records->front().fields.back() == "unit");
            for (std::size_t r = 1; r < records->size(); ++r)
                CHECK_FALSE((*records)[r].fields.back().empty());
            for (const auto& record : *records) CHECK(record.fields.size() == records->front().fields.size());
        }
        const auto clips = *parseCsv(tables[0].second, "clips.csv");
        CHECK(clips[1].fields[0] == "a <&> \"1\"");
        CHECK(clips[7].fields[10].empty());
        CHECK(clips[6].fields[10] == "0.59");
    }

    TEST_CASE(
        "A target's accuracies go by its place, whatever manifests call it, and are means of its clips") {
        EvaluationInput input = small();
        input.clips[5].target_id = "elsewhere";  // of "b", at the second place
        MeasuredClip again = clipOf("b", 5, input.clips[5].target, 0.49);
        again.target_id = "G1";  // the first place's name
        input.clips.push_back(again);
        const auto targets = nlohmann::json::parse(evaluationJson(evaluated(input)))["targets"];
        REQUIRE(targets.size() == 4);
        CHECK(targets[0]["accuracy"]["b"].get<double>() == doctest::Approx(0.6));
        CHECK(targets[1]["accuracy"]["b"].get<double>() == doctest::Approx(0.5 * (0.59 + 0.49)));
    }

    TEST_CASE("A system whose every clip is missing has no numbers, and the page still stands") {
        EvaluationInput input = small();
        for (auto& clip : input.clips)
            if (clip.system == "b") clip.accuracy.reset();
        const Evaluation evaluation = evaluated(std::move(input));
        CHECK(evaluation.systems[1].correlation.method == "undefined");
        CHECK(contains(renderEvaluation(evaluation), "no accuracy"));
        const auto json = nlohmann::json::parse(evaluationJson(evaluation));
        CHECK(json["systems"][1]["accuracy"]["mean"].is_null());
        CHECK(json["systems"][1]["density_correlation"]["rho"].is_null());
        CHECK(nlohmann::json::accept(evaluationJson(evaluation)));  // JSON knows no NaN
    }

    TEST_CASE("No clips, one training target and targets in a plane are rejected with words") {
        EvaluationInput none = small();
        none.clips.clear();
        CHECK(contains(evaluate(std::move(none)).error().text(), "no clip with a target"));
        EvaluationInput one = small();
        one.training.resize(1);
        CHECK(
            contains(evaluate(std::move(one)).error().text(), "training.csv: no bandwidth can be estimated"));
        EvaluationInput flat = small();
        for (auto& target : flat.training) target.y = 1.0;
        CHECK(contains(evaluate(std::move(flat)).error().text(), "axis 2"));
        EvaluationInput given = small();
        for (auto& target : given.training) target.y = 1.0;
        given.bandwidth = std::vector<double>{0.8, 0.36, 0.35};
        CHECK(evaluated(std::move(given)).bandwidths == std::vector<double>{0.8, 0.36, 0.35});
        EvaluationInput together = small();
        together.bandwidth = std::vector<double>{0.8, 0.36, 0.35};
        together.training = {{1, 1, 1}, {1, 1, 1}};
        together.mean_shift_bandwidth.reset();
        CHECK(contains(evaluate(std::move(together)).error().text(), "--meanshift-bandwidth"));
    }

    TEST_CASE("Systems made for different targets are remarked on, as are clips that point at nothing") {
        EvaluationInput input = small();
        input.clips.pop_back();
        input.without_target = 3;
        input.clips[0].phases_given = false;
        input.clips[0].placed = true;
        const Evaluation evaluation = evaluated(std::move(input));
        std::string all;
        for (const auto& remark : evaluation.remarks) all += remark + "\n";
        CHECK(contains(all, "3 clips of the manifests point at nothing"));
        CHECK(contains(all, "gives no phases for 1 clip;"));
        CHECK(contains(all, "1 clip was placed at the origin"));
        CHECK(contains(all, "not made for the same targets"));
    }
}
