#include "results/analysis/analysis.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "fixtures.hpp"
#include "results/outputs/analysis_json.hpp"

using namespace deixis;
using namespace deixis::results;

namespace {

/// A table of two systems to which answers are added one by one.
struct TableMaker {
    ResponseTable table;

    TableMaker() {
        table.measures = {{"accuracy", MeasureKind::accuracy, 0.0, 1.0, 3, 0},
                          {"naturalness", MeasureKind::rating, 1.0, 5.0, 0, 0}};
        table.study_name = "hand-made";
        table.systems = {"x", "y"};
        table.layouts = {"across", "side-by-side"};
        table.alpha = 0.01;
    }
    void add(const char* participant, std::size_t measure, const char* system, const char* layout,
             double value) {
        ResponseRow row;
        row.participant = participant;
        row.measure = table.measures[measure].name;
        row.system = system;
        row.layout = layout;
        row.target_id = "T001";
        row.value = value;
        table.rows.push_back(row);
        ++table.measures[measure].planned;
    }
    void rate(const char* participant, const char* system, double rating) {
        add(participant, 1, system, "across", rating);
    }
    void choose(const char* participant, const char* system, const char* layout, bool correct) {
        add(participant, 0, system, layout, correct ? 1.0 : 0.0);
    }
    void prefer(const char* participant, const char* left, const char* right, double preference) {
        if (table.measures.size() < 3)
            table.measures.push_back({"preference", MeasureKind::preference, -2.0, 2.0, 0, 0});
        add(participant, 2, left, "across", preference);
        table.rows.back().other_system = right;
    }
};

bool anyContains(const std::vector<std::string>& texts, const char* part) {
    return std::any_of(texts.begin(), texts.end(),
                       [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

}  // namespace

TEST_SUITE("results/analysis") {
    TEST_CASE("A table worked by hand gives its means, deviations and tests") {
        TableMaker made;
        // Participants' means: x 4, 3, 5; y 2, 2, 1 -> differences 2, 1, 4.
        for (const double rating : {5.0, 3.0}) made.rate("A", "x", rating);
        for (const double rating : {2.0, 2.0}) made.rate("A", "y", rating);
        made.rate("B", "x", 3.0);
        made.rate("B", "y", 2.0);
        made.rate("C", "x", 5.0);
        made.rate("C", "y", 1.0);
        // Across: A right, B wrong; side by side: A right, B right; C has played across only.
        made.choose("A", "x", "across", true);
        made.choose("A", "x", "side-by-side", true);
        made.choose("B", "x", "across", false);
        made.choose("B", "x", "side-by-side", true);
        made.choose("C", "x", "across", true);
        made.table.planned_participants = 3;
        const auto result = analyse(made.table);
        CHECK(result.participants == 3);
        REQUIRE(result.systems.size() == 2);
        const auto& x = result.systems[0];
        CHECK(x.measures[1].mean == doctest::Approx(4.0));
        CHECK(x.measures[1].sd_participants == doctest::Approx(1.0));
        // Ratings 5, 3, 3, 5: mean 4, squares 4, n - 1 = 3.
        CHECK(x.measures[1].sd_trials == doctest::Approx(std::sqrt(4.0 / 3.0)));
        CHECK(x.measures[1].n == 4);
        // Means 1, 1/2, 1: the mean of participants, not of trials (4/5).
        CHECK(x.measures[0].mean == doctest::Approx(2.5 / 3.0));
        CHECK(x.measures[0].n == 5);
        CHECK(result.systems[1].measures[0].n == 0);
        CHECK(x.measures[1].by_participant == std::vector<double>{4.0, 3.0, 5.0});

        REQUIRE(result.levels.size() == 6);
        CHECK(result.levels[0].system == "all");
        CHECK(result.levels[0].level == "across");
        CHECK(result.levels[0].mean == doctest::Approx(2.0 / 3.0));
        CHECK(result.levels[0].sd_trials == doctest::Approx(std::sqrt(1.0 / 3.0)));
        CHECK(result.levels[3].system == "x");
        CHECK(result.levels[3].level == "side-by-side");
        CHECK(result.levels[3].mean == 1.0);
        CHECK(result.levels[3].n == 2);

        REQUIRE(result.pairwise.size() == 2);
        const auto& accuracy = result.pairwise[0];
        CHECK(accuracy.measure == "accuracy");
        CHECK(accuracy.test.n_pairs == 0);
        CHECK(accuracy.test.p_two_sided == 1.0);
        const auto& naturalness = result.pairwise[1];
        CHECK(naturalness.measure == "naturalness");
        CHECK(naturalness.a == "x");
        CHECK(naturalness.b == "y");
        CHECK(naturalness.mean_difference == doctest::Approx(7.0 / 3.0));
        CHECK(naturalness.test.w_plus == 6.0);
        CHECK(naturalness.test.w_minus == 0.0);
        CHECK(naturalness.test.p_two_sided == 0.25);  // 2 of 8 sign patterns
        CHECK_FALSE(naturalness.significant);

        REQUIRE(result.level_tests.size() == 2);
        CHECK(result.level_tests[0].system == "x");
        CHECK(result.level_tests[0].test.n_pairs == 2);
        CHECK(result.level_tests[0].test.n_zero == 1);
        CHECK(result.level_tests[0].test.p_two_sided == 1.0);
        CHECK(anyContains(result.remarks, "Tests of layout: participants without answers"));
        CHECK(naturalness.out_of_reach);  // 2 of 8, alpha 0.01
        CHECK_FALSE(accuracy.p_holm.has_value());
        CHECK(accuracy.family_size == 0);
        CHECK(anyContains(result.remarks,
                          "1 of 1 tests (naturalness: pairs of systems) cannot be significant"));
        CHECK_FALSE(anyContains(result.remarks, "incomplete"));
    }

    TEST_CASE(
        "The deviation over trials of right and wrong answers is the binomial one of the paper's Table 1") {
        // Proportions and deviations as printed there, two decimals each.
        const std::pair<double, double> printed[] = {
            {0.84, 0.37}, {0.5, 0.5}, {0.39, 0.49}, {0.96, 0.20}, {0.95, 0.22}};
        for (const auto& [p, sd] : printed) {
            const double proportion = p;  // clang 14 lets no lambda use a structured binding
            const double deviation = sd;
            CAPTURE(proportion);
            TableMaker made;
            for (int trial = 0; trial < 400; ++trial)
                made.choose(trial % 2 == 0 ? "A" : "B", "x", "across",
                            trial < std::lround(400.0 * proportion));
            const auto result = analyse(made.table);
            CHECK(std::abs(result.levels[0].sd_trials - deviation) < 0.005);
        }
    }

    TEST_CASE("Holm's families are the pairs within a measure, and the layout tests") {
        TableMaker made;
        made.table.systems = {"x", "y", "z"};
        const char* participants[] = {"A", "B", "C", "D", "E", "F", "G", "H", "I", "J", "K", "L"};
        for (int i = 0; i < 12; ++i) {
            made.rate(participants[i], "x", 5.0);
            made.rate(participants[i], "y", 3.0);
            made.rate(participants[i], "z", i % 2 == 0 ? 2.0 : 4.0);
        }
        made.table.planned_participants = 12;
        const auto result = analyse(made.table);
        REQUIRE(result.pairwise.size() == 6);
        const double p = std::exp2(-11);  // all of 12 differences positive
        const auto& xy = result.pairwise[3];
        CHECK(xy.test.p_two_sided == doctest::Approx(p));
        CHECK(xy.p_holm.value() == doctest::Approx(3.0 * p));
        CHECK(xy.significant);
        CHECK(result.pairwise[5].p_holm.value() == 1.0);
        CHECK_FALSE(result.pairwise[5].significant);
        CHECK_FALSE(anyContains(result.remarks, "pairs of systems) cannot be significant"));
        CHECK(xy.family == "naturalness: pairs of systems");
        CHECK(xy.family_size == 3);
        CHECK(anyContains(result.remarks, "There are no answers on accuracy"));
    }

    TEST_CASE("A decision that depends on how zeros are treated is told") {
        // Counted over all 2^11 patterns of signs by a script of a dozen lines: 118 of 2048 where the zero is
        // dropped, 78 where it is ranked first (Pratt).
        TableMaker made;
        made.table.alpha = 0.05;
        const double differences[] = {0, 4, 3, 2, 1, -1, 1, 1, 1, 5, 1, -2};
        for (int i = 0; i < 12; ++i) {
            const std::string name(1, static_cast<char>('A' + i));
            made.rate(name.c_str(), "x", 10.0 + differences[i]);
            made.rate(name.c_str(), "y", 10.0);
        }
        const auto result = analyse(made.table);
        const auto& pair = result.pairwise[1];
        CHECK(pair.p_holm.value() == 118.0 / 2048.0);
        CHECK(pair.p_holm_pratt.value() == 78.0 / 2048.0);
        CHECK_FALSE(pair.significant);
        CHECK(pair.depends_on_zeros);
        CHECK(anyContains(
            result.remarks,
            "x against y is not significant at 0.05 if differences of zero are dropped (p = 0.0576"));
        AnalysisOptions strict;
        strict.alpha = 0.01;
        CHECK_FALSE(analyse(made.table, strict).pairwise[1].depends_on_zeros);
        CHECK(analyse(made.table, strict).alpha == 0.01);
    }

    TEST_CASE("Friedman's test takes the participants who have every system") {
        // Conover (1999), example 5.8.1: homeowners' ranks of grasses; chi2 = 8.0973, F = 3.1922 (df 3, 33).
        const double ranks[12][4] = {{4, 3, 2, 1},     {4, 2, 3, 1}, {3, 1.5, 1.5, 4}, {3, 1, 2, 4},
                                     {4, 2, 1, 3},     {2, 2, 2, 4}, {1, 3, 2, 4},     {2, 4, 1, 3},
                                     {3.5, 1, 2, 3.5}, {4, 1, 3, 2}, {4, 2, 3, 1},     {3.5, 1, 2, 3.5}};
        TableMaker made;
        made.table.systems = {"w", "x", "y", "z"};
        for (int i = 0; i < 12; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                made.rate(std::string(1, static_cast<char>('A' + i)).c_str(), made.table.systems[j].c_str(),
                          ranks[i][j]);
        made.rate("left-out", "w", 1.0);
        const auto result = analyse(made.table);
        REQUIRE(result.omnibus.size() == 2);
        const FriedmanTest& test = result.omnibus[1].test;
        CHECK(test.n == 12);
        CHECK(test.chi2.value() == doctest::Approx(8.0973).epsilon(1e-5));
        CHECK(test.iman_davenport.f.value() == doctest::Approx(3.1922).epsilon(1e-4));
        CHECK(test.iman_davenport.df2 == 33);
        CHECK_FALSE(result.omnibus[0].test.chi2.has_value());
    }

    TEST_CASE("Preferences count for a system whichever side it stood on, and are tested over participants") {
        TableMaker made;
        // For x: A clearly (left) and slightly (right), B slightly against, C equal.
        made.prefer("A", "x", "y", -2.0);
        made.prefer("A", "y", "x", 1.0);
        made.prefer("B", "x", "y", 1.0);
        made.prefer("C", "y", "x", 0.0);
        made.table.planned_participants = 3;
        const auto result = analyse(made.table);
        REQUIRE(result.preferences.size() == 1);
        const auto& pair = result.preferences[0];
        CHECK(pair.a == "x");
        CHECK(pair.b == "y");
        CHECK(pair.prefers_a == 2);
        CHECK(pair.ties == 1);
        CHECK(pair.prefers_b == 1);
        // Means of participants: 1.5, -1, 0.
        CHECK(pair.mean == doctest::Approx(0.5 / 3.0));
        CHECK(pair.test.n_pairs == 3);
        CHECK(pair.test.n_zero == 1);
        CHECK(pair.test.w_plus == 2.0);
        CHECK(pair.test.w_minus == 1.0);
    }

    TEST_CASE("Levels of the distance are a family of their own beside those of the layout") {
        TableMaker made;
        made.table.distances = {"near", "far"};
        for (const char* participant : {"A", "B", "C"})
            for (const char* distance : {"near", "far"}) {
                made.choose(participant, "x", "across", std::string(distance) == "far");
                made.table.rows.back().distance = distance;
            }
        const auto result = analyse(made.table);
        int tests = 0;
        for (const auto& one : result.level_tests) {
            if (one.factor != "distance" || one.system != "x") continue;
            ++tests;
            CHECK(one.a == "near");
            CHECK(one.mean_difference == -1.0);
            CHECK(one.test.p_two_sided == 0.25);  // 2 of 8 sign patterns
            CHECK(one.p_holm.value() == 0.25);    // y has no answers: no p, and none in the family
        }
        CHECK(tests == 1);
    }

    TEST_CASE("A score's mean and deviation are over participants") {
        TableMaker made;
        for (const auto& [participant, value] : {std::pair{"A", 10.0}, {"B", 20.0}, {"C", 60.0}})
            made.table.scores.push_back({participant, "after", "total", value});
        const auto result = analyse(made.table);
        REQUIRE(result.scores.size() == 1);
        CHECK(result.scores[0].mean == 30.0);
        CHECK(result.scores[0].sd == doctest::Approx(std::sqrt(700.0)));  // (400 + 100 + 900) / 2
        CHECK(result.participants == 3);
    }

    TEST_CASE("The JSON has the promised shapes, null where nothing is known, and the same bytes each time") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"a", "b", "c", "d"});
        fixtures::fill(folder / "a.sqlite", study, 5, 2, true, {0.9, 0.8, 0.7, 0.4}, {4.0, 3.5, 3.0, 2.5},
                       fixtures::everything);
        const auto table = loadResponses(folder / "a.sqlite");
        REQUIRE(table);
        const auto result = analyse(*table);
        const auto text = analysisJson(result);
        CHECK(text == analysisJson(analyse(*loadResponses(folder / "a.sqlite"))));
        const auto json = nlohmann::json::parse(text);
        CHECK(json["participants"] == 5);
        CHECK(json["synthetic"] == true);
        CHECK(json["alpha"] == 0.01);
        REQUIRE(json["systems"].size() == 4);
        for (const char* measure : {"accuracy", "naturalness"})
            for (const char* key : {"mean", "sd_participants", "sd_trials", "n"})
                CHECK(json["systems"][0][measure][key].is_number());
        CHECK(json["systems"][0]["naturalness"]["n"] == 10);
        CHECK(json["systems"][0]["accuracy"]["n"] == 20);
        CHECK(json["systems"][2]["accuracy"]["mean"].get<double>() == result.systems[2].measures[0].mean);
        REQUIRE(json["layouts"].size() == 10);
        for (const char* key : {"system", "layout", "mean", "sd_trials", "n"})
            CHECK(json["layouts"][9].contains(key));
        REQUIRE(json["pairwise"].size() == 12);
        for (const char* key : {"measure", "a", "b", "n", "n_zero", "w_plus", "w_minus", "p", "p_holm",
                                "significant", "method"})
            CHECK(json["pairwise"][0].contains(key));
        CHECK(json["layout_tests"].size() == 4);

        fixtures::fill(folder / "one.sqlite", study, 1, 1, false, {1, 1, 1, 1}, {3, 3, 3, 3},
                       [](int, const studies::Trial& trial) { return trial.stage == "naturalness"; });
        const auto one = nlohmann::json::parse(analysisJson(analyse(*loadResponses(folder / "one.sqlite"))));
        CHECK(one["synthetic"] == false);
        CHECK(one["systems"][0]["accuracy"]["mean"].is_null());
        CHECK(one["systems"][0]["naturalness"]["mean"].is_number());
        CHECK(one["systems"][0]["naturalness"]["sd_participants"].is_null());
        CHECK(anyContains(one["remarks"], "incomplete: 0 of 8 planned on accuracy are answered"));
    }
}
