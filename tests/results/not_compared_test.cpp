// Systems that a study shows, but does not compare.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "fixtures.hpp"
#include "results/analysis/analysis.hpp"
#include "results/answers/motion_origin.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/report/report.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;
using nlohmann::json;

namespace {

void rate(ResponseTable& table, const std::string& participant, const std::string& system, double value) {
    ResponseRow row;
    row.participant = participant;
    row.measure = "ease";
    row.system = system;
    row.target_id = "T1";
    row.value = value;
    table.rows.push_back(row);
}

/// Three people rate three systems, REF highest.
ResponseTable threeSystems() {
    ResponseTable out;
    out.systems = {"REF", "a", "b"};
    out.measures = {{"ease", MeasureKind::rating, 0.0, 100.0, 0, 9}};
    const double ref[] = {90, 80, 70}, a[] = {40, 50, 60}, b[] = {30, 30, 30};
    for (int p = 0; p < 3; ++p) {
        rate(out, fmt::format("P{}", p), "REF", ref[p]);
        rate(out, fmt::format("P{}", p), "a", a[p]);
        rate(out, fmt::format("P{}", p), "b", b[p]);
    }
    return out;
}

}  // namespace

TEST_SUITE("results/not_compared") {
    TEST_CASE("A system that is not compared is in no test and no rank, and has its own means beside why") {
        ResponseTable table = threeSystems();
        const AnalysisResult all = analyse(table);
        CHECK(all.pairwise.size() == 3);
        table.not_compared = {{"REF", "made by rules: synthetic"}};
        table.processing = {{"REF", "synthetic"}, {"a", "physics-projected, learned-from-synthetic"}};
        const AnalysisResult result = analyse(table);

        REQUIRE(result.pairwise.size() == 1);
        CHECK(result.pairwise[0].a == "a");
        CHECK(result.pairwise[0].b == "b");
        CHECK(result.pairwise[0].family_size == 1);  // three before
        // (40 - 30 + 50 - 30 + 60 - 30) / 3
        CHECK(result.pairwise[0].mean_difference == doctest::Approx(20.0));
        REQUIRE(result.systems.size() == 2);
        CHECK(result.systems[0].system == "a");
        for (const auto& one : result.times) CHECK(one.system != "REF");
        for (const auto& one : result.pooled) CHECK(one.system != "REF");
        REQUIRE(result.omnibus.size() == 1);
        CHECK(result.omnibus[0].test.mean_ranks.size() == 2);
        CHECK(result.items.front().n == 6);

        REQUIRE(result.not_compared.size() == 1);
        CHECK(result.not_compared[0].system == "REF");
        CHECK(result.not_compared[0].measures[0].mean == doctest::Approx(80.0));
        CHECK(result.not_compared[0].measures[0].n == 3);
        CHECK(result.not_compared[0].measures[0].sd_participants == doctest::Approx(10.0));
        // All answers are there, and their hash is that of all of them.
        for (const std::string& remark : result.remarks) CHECK_FALSE(contains(remark, "incomplete"));
        CHECK(result.answers_hash == all.answers_hash);
    }

    TEST_CASE("Page, JSON and tables name it, and what is synthetic") {
        ResponseTable table = threeSystems();
        table.not_compared = {{"REF", "in the place of <recorded> motion"}};
        table.processing = {{"REF", "synthetic"}, {"a", "learned-from-synthetic"}};
        table.built_in_systems = {"b"};
        const AnalysisResult result = analyse(table);
        const std::string page = renderReport(result);
        CHECK(contains(page, "2 systems and 1 that is not compared"));
        CHECK(contains(page, "Shown, but not compared"));
        CHECK(contains(page, "REF (synthetic)"));
        CHECK(contains(page, "in the place of &lt;recorded&gt; motion"));
        CHECK(contains(page, "The motion of b and REF is synthetic: rules or formulas made it"));
        CHECK(contains(page,
                       "The motion of a was made by a system that learned from synthetic demonstrations"));
        const json out = json::parse(analysisJson(result));
        REQUIRE(out["not_compared"].size() == 1);
        CHECK(out["not_compared"][0]["system"] == "REF");
        CHECK(out["not_compared"][0]["motion"] == "synthetic");
        CHECK(out["not_compared"][0]["n"] == 3);
        CHECK(out["synthetic_systems"] ==
              json{{"REF", "synthetic"}, {"a", "learned from synthetic"}, {"b", "synthetic"}});
        bool told = false;
        for (const auto& [name, bytes] : analysisTables(result, TableFormat::csv)) {
            if (name == "not_compared.csv") told = contains(bytes, "REF");
            if (name == "means.csv" || name == "pairwise.csv") CHECK_FALSE(contains(bytes, "REF"));
        }
        CHECK(told);
    }

    TEST_CASE("Without word on a system nothing is said of it; an older database tells built-in systems") {
        ResponseTable table = threeSystems();
        CHECK(syntheticSystems(table).empty());
        CHECK_FALSE(contains(renderReport(analyse(table)), "not compared"));
        table.built_in_systems = {"a"};
        CHECK(motionText(table, "a") == "synthetic or learned from synthetic");
        table.processing.emplace();
        CHECK(motionText(table, "a") == "synthetic");
        CHECK(motionText(table, "b").empty());
    }
}
