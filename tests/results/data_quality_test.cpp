#include "results/answers/data_quality.hpp"

#include <doctest/doctest.h>

#include <fmt/core.h>

#include "fixtures.hpp"
#include "results/answers/response_table.hpp"

using namespace deixis;
using doctest::Approx;
using Units = std::vector<std::vector<double>>;

namespace {

void add(results::ResponseTable& table, const std::string& who, const std::string& measure, int trial,
         const std::string& item, double value, double time_s = 2.0) {
    results::ResponseRow row;
    row.participant = who;
    row.measure = measure;
    row.system = "a";
    row.target_id = item;
    row.trial = trial;
    row.value = value;
    if (measure == "preference") row.other_system = "b";
    row.response_time_s = time_s;
    table.rows.push_back(row);
}

results::ResponseTable empty() {
    results::ResponseTable table;
    table.systems = {"a"};
    table.measures = {{"naturalness", results::MeasureKind::rating, 1.0, 5.0},
                      {"preference", results::MeasureKind::preference, -2.0, 2.0}};
    return table;
}

}  // namespace

TEST_SUITE("results/data_quality") {
    TEST_CASE("Krippendorff's alpha of his own example") {
        // Krippendorff (2011), "Computing Krippendorff's alpha-reliability", section D: four observers,
        // twelve units, seven values missing; interval data: .849. Unit 12 has one value, and so no part in
        // it.
        const Units units{{1, 1, 1},    {2, 2, 3, 2}, {3, 3, 3, 3}, {3, 3, 3, 3}, {2, 2, 2, 2}, {1, 2, 3, 4},
                          {4, 4, 4, 4}, {1, 1, 2, 1}, {2, 2, 2, 2}, {5, 5, 5},    {1, 1}};
        const auto alpha = results::krippendorffAlpha(units);
        REQUIRE(alpha);
        CHECK(*alpha == Approx(0.849).epsilon(0.0006));
        // Far from 0 the same.
        Units far = units;
        for (auto& unit : far)
            for (double& x : unit) x += 1e6;
        CHECK(*results::krippendorffAlpha(far) == Approx(*alpha).epsilon(1e-9));
        CHECK_FALSE(results::krippendorffAlpha({{1, 2}}));
        CHECK_FALSE(results::krippendorffAlpha({{3, 3}, {3, 3}}));
        CHECK(*results::krippendorffAlpha({{1, 1}, {5, 5}}) == 1.0);
    }

    TEST_CASE("Intraclass correlations of the published example") {
        // Shrout & Fleiss (1979), tables 2 and 4: six targets, four judges; ICC(1,1) .17, ICC(1,4) .44.
        const Units units{{9, 2, 5, 8}, {6, 1, 3, 2},  {8, 4, 6, 8},
                          {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}};
        const auto icc = results::intraclassCorrelation(units);
        REQUIRE(icc);
        CHECK(icc->single == Approx(0.17).epsilon(0.03));
        CHECK(icc->mean == Approx(0.44).epsilon(0.012));
        CHECK(icc->k == 4.0);
        // Their mean squares: between 11.24, within 6.26.
        CHECK(icc->single == Approx((11.24 - 6.26) / (11.24 + 3.0 * 6.26)).epsilon(0.002));
        CHECK_FALSE(results::intraclassCorrelation({{1, 2}}));
    }

    TEST_CASE("What a participant did is counted, worked by hand") {
        auto table = empty();
        // anna and ben rate alike; carl always gives 3, and fast; dora goes against them.
        for (int i = 0; i < 10; ++i) {
            const std::string item = fmt::format("T{}", i);
            const double rating = 1.0 + i % 5;
            add(table, "anna", "naturalness", i, item, rating, 2.0 + 0.1 * i);
            add(table, "ben", "naturalness", i, item, rating, 2.1 + 0.1 * i);
            add(table, "carl", "naturalness", i, item, 3.0, 0.05);
            add(table, "dora", "naturalness", i, item, 6.0 - rating, 2.2 + 0.1 * i);
        }
        for (int i = 0; i < 8; ++i) add(table, "dora", "preference", 10 + i, "", i < 7 ? -1.0 : 0.0);
        const auto quality = results::dataQuality(table);
        REQUIRE(quality.participants.size() == 4);
        const auto& anna = quality.participants[0];
        const auto& carl = quality.participants[2];
        const auto& dora = quality.participants[3];
        CHECK(anna.same_share == 0.2);
        CHECK(anna.longest_run == 1);
        CHECK(*anna.median_s == Approx(2.45));
        CHECK(anna.fast == 0);
        CHECK_FALSE(anna.p_side);
        // With ben's r = 1, carl's constant and dora's 6 - r the others' mean is 1/3 (r + 3 + 6 - r) = 3.
        CHECK_FALSE(anna.agreement);
        CHECK(carl.same_share == 1.0);
        CHECK(carl.same_rating == 3.0);
        CHECK(carl.longest_run == 10);
        CHECK(carl.fast == 10);
        CHECK_FALSE(carl.agreement);
        // The others' mean is 1/3 (2 r + 3), which rises where hers falls.
        CHECK(*dora.agreement == Approx(-1.0));
        CHECK(dora.decided == 7);
        CHECK(dora.left == 7);
        CHECK(*dora.p_side == Approx(2.0 / 128.0));  // all seven on one side
        REQUIRE(quality.reliability.size() == 1);
        CHECK(quality.reliability[0].raters == 4);
        CHECK(quality.reliability[0].units == 10);
        CHECK(quality.reliability[0].ratings == 40);
    }

    TEST_CASE("Agreement over several measures is that within each, whatever their scales") {
        auto table = empty();
        table.measures.push_back({"human-likeness", results::MeasureKind::rating, 0.0, 100.0});
        for (int i = 0; i < 5; ++i) {
            const std::string item = fmt::format("T{}", i);
            add(table, "anna", "naturalness", i, item, 1.0 + i);
            add(table, "ben", "naturalness", i, item, 5.0 - i);
            add(table, "anna", "human-likeness", 5 + i, item, 70.0 + i);
            add(table, "ben", "human-likeness", 5 + i, item, 74.0 - i);
        }
        // Together the two scales would make them agree almost perfectly.
        for (const auto& one : results::dataQuality(table).participants)
            CHECK(*one.agreement == Approx(-1.0));
    }

    TEST_CASE("A measure of few answers does not hide one that the rule judges") {
        auto table = empty();
        table.measures.push_back({"confidence", results::MeasureKind::rating, 1.0, 5.0});
        for (int i = 0; i < 20; ++i) add(table, "anna", "naturalness", i, "T", i == 0 ? 1.0 : 4.0);
        for (int i = 0; i < 3; ++i) add(table, "anna", "confidence", 20 + i, "T", 2.0);
        table.leave_out.same_rating_share = 0.9;
        CHECK(results::leftOutByRule(table) ==
              std::map<std::string, std::string>{
                  {"anna", "by the study's rule: rated 4 in 19 of 20 (naturalness)"}});
    }

    TEST_CASE("A declared rule names whom it leaves out, and why; without one nobody is") {
        auto table = empty();
        for (int i = 0; i < 10; ++i) {
            add(table, "anna", "naturalness", i, "T", 1.0 + i % 5);
            add(table, "ben", "naturalness", i, "T", i == 0 ? 1.0 : 4.0);
            add(table, "carl", "preference", i, "", i < 8 ? 2.0 : -1.0);
            add(table, "dora", "naturalness", i, "T", 1.0 + i % 5, 0.3);
        }
        for (int i = 0; i < 9; ++i) add(table, "few", "naturalness", i, "T", 4.0, 0.1);
        CHECK(results::leftOutByRule(table).empty());
        table.leave_out.same_rating_share = 0.9;
        CHECK(results::leftOutByRule(table) ==
              std::map<std::string, std::string>{
                  {"ben", "by the study's rule: rated 4 in 9 of 10 (naturalness)"}});
        table.leave_out = {.one_side_share = 0.8};
        CHECK(results::leftOutByRule(table) ==
              std::map<std::string, std::string>{
                  {"carl", "by the study's rule: preferred the right one in 8 of 10 pairs"}});
        table.leave_out = {.median_time_below_s = 0.31};
        CHECK(
            results::leftOutByRule(table) ==
            std::map<std::string, std::string>{{"dora", "by the study's rule: median response time 0.30 s"}});
    }
}
