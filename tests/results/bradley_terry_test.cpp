// Abilities from preferences, against R's glm (oracles/make_bradley_terry.R) and by hand.
#include "results/analysis/bradley_terry.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "oracles.hpp"
#include "results/analysis/analysis.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/report/report.hpp"

using namespace deixis;
using namespace deixis::results;

namespace {

/// Answers given one by one.
struct Preferences {
    ResponseTable table;

    explicit Preferences(const std::vector<std::string>& systems) {
        table.study_name = "pairs";
        table.systems = systems;
        table.measures = {{"preference", MeasureKind::preference, -2.0, 2.0, 0, 0}};
    }
    void add(const char* participant, const char* left, const char* right, double value, int times = 1) {
        for (int i = 0; i < times; ++i) {
            ResponseRow row;
            row.participant = participant;
            row.measure = "preference";
            row.system = left;
            row.other_system = right;
            row.value = value;
            table.rows.push_back(row);
        }
    }
};

const BootstrapOptions few{500, 3, 0.95};

}  // namespace

TEST_SUITE("results/bradley_terry") {
    TEST_CASE("Abilities are those of R's logistic regression.") {
        for (const auto& one : tests::oracles("bradley_terry")) {
            INFO(one["name"].get<std::string>());
            const auto found = bradleyTerryAbilities(one["wins"].get<WinMatrix>());
            REQUIRE(found.has_value());
            const auto expected = one["abilities"].get<std::vector<double>>();
            REQUIRE(found->size() == expected.size());
            for (std::size_t i = 0; i < expected.size(); ++i)
                CHECK(std::abs((*found)[i] - expected[i]) < 1e-8);
        }
    }

    TEST_CASE("Of two systems the difference is the log of wins to losses, a tie being half of each.") {
        Preferences answers({"x", "y"});
        answers.add("P1", "x", "y", -2.0, 5);  // for x
        answers.add("P2", "y", "x", 1.0, 2);   // for x, on the right
        answers.add("P2", "x", "y", 0.0, 2);
        answers.add("P1", "x", "y", 1.0, 1);  // for y
        const BradleyTerry fit = bradleyTerry(answers.table, few);
        REQUIRE(fit.abilities.size() == 2);
        CHECK(*fit.abilities[0].estimate - *fit.abilities[1].estimate ==
              doctest::Approx(std::log(8.0 / 2.0)));
        CHECK(*fit.abilities[0].estimate == doctest::Approx(-*fit.abilities[1].estimate));
        CHECK(fit.abilities[0].wins == 7);
        CHECK(fit.abilities[0].ties == 2);
        CHECK(fit.abilities[0].losses == 1);
        REQUIRE(fit.pairs.size() == 1);
        CHECK(fit.pairs[0].prefers_a == 7);
        CHECK(fit.pairs[0].prefers_b == 1);
    }

    TEST_CASE("Intervals hold the estimate, repeat with the seed, and narrow with more participants.") {
        const auto fitOf = [](int participants, std::uint64_t seed) {
            Preferences answers({"x", "y", "z"});
            for (int p = 0; p < participants; ++p) {
                const std::string name = "P" + std::to_string(1000 + p);
                answers.add(name.c_str(), "x", "y", p % 3 == 0 ? 1.0 : -1.0);
                answers.add(name.c_str(), "y", "z", p % 4 == 0 ? 1.0 : -1.0);
                answers.add(name.c_str(), "x", "z", p % 5 == 0 ? 1.0 : p % 5 == 1 ? 0.0 : -1.0);
            }
            return bradleyTerry(answers.table, {500, seed, 0.95});
        };
        const auto width = [](const Ability& one) { return one.percentile->upper - one.percentile->lower; };
        const BradleyTerry small = fitOf(60, 3);
        const BradleyTerry large = fitOf(240, 3);
        const BradleyTerry again = fitOf(60, 3);
        const BradleyTerry other = fitOf(60, 4);
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK(small.abilities[i].bca->lower < *small.abilities[i].estimate);
            CHECK(small.abilities[i].bca->upper > *small.abilities[i].estimate);
            CHECK(width(large.abilities[i]) / width(small.abilities[i]) == doctest::Approx(0.5).epsilon(0.2));
            CHECK(small.abilities[i].bca->lower == again.abilities[i].bca->lower);
            CHECK(small.abilities[i].bca->lower != other.abilities[i].bca->lower);
        }
    }

    TEST_CASE("Intervals do not hang on how participants are called") {
        const auto named = [](const std::vector<const char*>& ids) {
            Preferences answers({"x", "y", "z"});
            for (std::size_t i = 0; i < ids.size(); ++i) {
                answers.add(ids[i], "x", "y", i % 3 == 0 ? -1.0 : 2.0, 1 + static_cast<int>(i));
                answers.add(ids[i], "y", "z", i % 2 == 0 ? -1.0 : 1.0, 3);
                answers.add(ids[i], "x", "z", i == 4 ? 0.0 : 1.0, 2);
                answers.add(ids[i], "z", "x", 1.0);
            }
            return bradleyTerry(answers.table, few);
        };
        const BradleyTerry one = named({"P1", "P2", "P3", "P4", "P5", "P6"});
        const BradleyTerry other = named({"Q3", "B1", "Z9", "A7", "M4", "C2"});
        for (std::size_t i = 0; i < 3; ++i) {
            REQUIRE(one.abilities[i].percentile);
            CHECK(one.abilities[i].percentile->lower == other.abilities[i].percentile->lower);
            CHECK(one.abilities[i].percentile->upper == other.abilities[i].percentile->upper);
            CHECK(one.abilities[i].estimate == other.abilities[i].estimate);
        }
    }

    TEST_CASE("Intervals are those of every way to draw the participants, which R has gone through") {
        const auto right = tests::oracles("bradley_terry_bootstrap")[0];
        const std::vector<std::string> names{"x", "y", "z"};
        Preferences answers(names);
        for (std::size_t p = 0; p < right["people"].size(); ++p) {
            const auto wins = right["people"][p].get<WinMatrix>();
            const std::string who = "P" + std::to_string(p);
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = i + 1; j < 3; ++j) {
                    const double tied = 2.0 * (wins[i][j] - std::floor(wins[i][j]));
                    const auto add = [&](double value, double times) {
                        answers.add(who.c_str(), names[i].c_str(), names[j].c_str(), value,
                                    static_cast<int>(times));
                    };
                    add(0.0, tied);
                    add(-1.0, wins[i][j] - tied / 2.0);
                    add(2.0, wins[j][i] - tied / 2.0);
                }
        }
        const BradleyTerry fit = bradleyTerry(answers.table, {40'000, 5, 0.95});
        for (std::size_t i = 0; i < 3; ++i) {
            const Ability& one = fit.abilities[i];
            const auto& expected = right["systems"][i];
            CAPTURE(one.system);
            CHECK(tests::close(one.estimate, expected["ability"], 1e-8));
            // Ends lie at single resamples, and 40,000 drawn ones are not all.
            const auto near = [](double found, const nlohmann::json& end) {
                return std::abs(found - end.get<double>()) < 0.02;
            };
            CHECK(near(one.percentile->lower, expected["percentile"][0]));
            CHECK(near(one.percentile->upper, expected["percentile"][1]));
            CHECK(near(one.bca->lower, expected["bca"][0]));
            CHECK(near(one.bca->upper, expected["bca"][1]));
        }
        CHECK(fit.abilities[1].percentile->upper - fit.abilities[1].bca->upper > 0.08);
    }

    TEST_CASE(
        "Where a system always wins, or nothing joins two groups, there are no abilities and a reason.") {
        Preferences won({"x", "y", "z"});
        won.add("P1", "x", "y", -1.0, 4);
        won.add("P1", "x", "z", -2.0, 4);
        won.add("P2", "y", "z", 1.0, 2);
        won.add("P2", "y", "z", -1.0, 3);
        const BradleyTerry separated = bradleyTerry(won.table, few);
        CHECK_FALSE(separated.abilities[0].estimate.has_value());
        CHECK(separated.abilities[0].wins == 8);
        CHECK(separated.note ==
              "no answer preferred y, z to x or rated them equal: the difference in ability is unbounded");

        Preferences apart({"x", "y", "z", "w"});
        apart.add("P1", "x", "y", 0.0, 2);
        apart.add("P1", "z", "w", 0.0, 2);
        const BradleyTerry disconnected = bradleyTerry(apart.table, few);
        CHECK_FALSE(disconnected.abilities[2].estimate.has_value());
        CHECK(disconnected.note ==
              "x, y were never compared with z, w, directly or through others: abilities have no common "
              "scale");

        const auto json = nlohmann::json::parse(analysisJson(analyse(won.table)));
        CHECK(json["bradley_terry"]["abilities"][0]["ability"].is_null());
        CHECK(json["bradley_terry"]["note"] == separated.note);
        CHECK(renderReport(analyse(won.table)).find("No abilities: no answer preferred y, z to x") !=
              std::string::npos);
    }

    TEST_CASE("Resamples without a maximum are counted and told; without preferences there is nothing.") {
        Preferences answers({"x", "y"});
        answers.add("P1", "x", "y", -1.0, 5);
        answers.add("P2", "x", "y", -1.0, 5);
        answers.add("P3", "x", "y", 1.0, 1);  // absent from (2/3)^3 of the resamples
        const BradleyTerry fit = bradleyTerry(answers.table, {3000, 1, 0.95});
        // All of P1 and P2, or all of P3.
        CHECK(fit.resamples_left_out / 3000.0 == doctest::Approx(8.0 / 27.0 + 1.0 / 27.0).epsilon(0.1));
        CHECK(fit.note.find("resamples have no finite abilities") != std::string::npos);
        // Without P3 nobody ever preferred y.
        CHECK(fit.note.find("BCa intervals are not defined, only percentiles are given") !=
              std::string::npos);
        CHECK_FALSE(fit.abilities[0].bca.has_value());
        CHECK(fit.abilities[0].percentile.has_value());
        const AnalysisResult result = analyse(answers.table);
        const auto json = nlohmann::json::parse(analysisJson(result))["bradley_terry"]["abilities"][0];
        CHECK(json["bca"].is_null());
        CHECK(json["percentile"]["lower"].is_number());
        CHECK(renderReport(result).find("only percentiles are given") != std::string::npos);
        CHECK(bradleyTerry(ResponseTable{}, few).abilities.empty());
    }
}
