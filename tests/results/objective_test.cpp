// Answers beside the objective evaluation of the same clips.
#include "results/analysis/objective.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "fixtures.hpp"
#include "page_text.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/report/report.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;
using deixis::tests::pageText;
using nlohmann::json;

namespace {

/// As `deixis evaluate` writes it, what is not read left out.
json evaluation() {
    const auto system = [](const char* name, json mean) {
        return json{{"system", name}, {"accuracy", {{"mean", std::move(mean)}}}};
    };
    const auto target = [](const char* id, double x, const json& accuracy) {
        return json{{"target_id", id}, {"target", {x, 1.0, 2.0}}, {"accuracy", accuracy}};
    };
    return {{"format", "deixis-evaluation"},
            {"version", 1},
            {"systems",
             {system("near", 0.6), system("far", 0.3), system("middle", 0.5), system("none", nullptr)}},
            {"targets",
             {target("T1", 0.1, {{"near", 0.61}, {"far", 0.1}}),
              target("T2", 0.2, {{"near", 0.62}, {"far", 0.2}}),
              target("T3", 0.3, {{"near", 0.63}, {"far", 0.3}}), target("T4", 0.4, {{"near", 0.64}}),
              target("T5", 0.5, json::object())}}};
}

Result<ObjectiveAccuracy> readBack(const std::string& text) {
    const fixtures::Folder folder;
    const auto file = folder / "evaluation.json";
    REQUIRE(writeFile(file, text));
    return readObjectiveAccuracy(file);
}

/// Ratings of 1 to 5, two people.
ResponseTable answers() {
    ResponseTable table;
    table.systems = {"far", "middle", "near"};
    Measure measure;
    measure.name = "clarity";
    measure.kind = MeasureKind::rating;
    measure.low = 1;
    measure.high = 5;
    table.measures = {measure};
    const auto rated = [&](const char* who, const char* system, const char* target, double value) {
        ResponseRow row;
        row.participant = who;
        row.measure = "clarity";
        row.system = system;
        row.target_id = target;
        row.value = value;
        table.rows.push_back(row);
    };
    for (const char* who : {"A", "B"}) {
        rated(who, "near", "T1", 2);
        rated(who, "near", "T2", 4);
        rated(who, "near", "T3", 3);
        rated(who, "near", "T4", 5);
        rated(who, "far", "T1", 3);
        rated(who, "far", "T2", 2);
        rated(who, "far", "T3", 1);
        rated(who, "far", "T4", 1);  // not evaluated there
        rated(who, "middle", "T1", 3);
    }
    return table;
}

}  // namespace

TEST_SUITE("results/objective") {
    TEST_CASE("Mean answers go with Equation 2 over systems and over each system's targets, worked by hand") {
        const auto objective = readBack(evaluation().dump());
        REQUIRE(objective);
        CHECK(objective->systems.size() == 3);
        CHECK(objective->positions_m.at("T3").x == 0.3);
        REQUIRE(checkSameClips(*objective, answers()));
        AnalysisOptions options;
        options.resamples = 100;
        options.objective = *objective;
        const AnalysisResult result = analyse(answers(), options);
        const auto& found = result.objective.correlations;
        REQUIRE(found.size() == 3);  // "middle" has no targets with an accuracy
        // Means 3.5, 3 and 1.75 beside .6, .5 and .3. Of 3! orders two are as far from none as this.
        CHECK(found[0].over == "systems");
        CHECK(found[0].test.n == 3);
        CHECK(found[0].test.rho == doctest::Approx(1.0));
        CHECK(found[0].test.p == doctest::Approx(2.0 / 6.0));
        CHECK(found[1].system == "far");
        CHECK(found[1].test.n == 3);
        CHECK(found[1].test.rho == doctest::Approx(-1.0));
        // Ranks 1 3 2 4 beside 1 2 3 4: 1 - 6 (0 + 1 + 1 + 0) / (4 * 15) = 0.8.
        CHECK(found[2].system == "near");
        CHECK(found[2].test.n == 4);
        CHECK(found[2].test.rho == doctest::Approx(0.8));
    }

    TEST_CASE("Page and JSON show them, and nothing where no evaluation is given") {
        AnalysisOptions options;
        options.resamples = 100;
        const AnalysisResult without = analyse(answers(), options);
        CHECK_FALSE(contains(renderReport(without), "Beside the objective evaluation"));
        CHECK(json::parse(analysisJson(without))["objective"]["file"].is_null());
        options.objective = *readBack(evaluation().dump());
        const AnalysisResult with = analyse(answers(), options);
        const std::string page = pageText(renderReport(with));
        CHECK(contains(page,
                       "Equation 2 and clarity have the systems in the same order: near > middle > far."));
        const json out = json::parse(analysisJson(with))["objective"];
        CHECK(out["means"].size() == 3);
        CHECK(out["means"][0]["equation_2"] == 0.3);
        CHECK(out["means"][0]["mean"] == 1.75);
        CHECK(out["correlations"][2]["rho"].get<double>() == doctest::Approx(0.8));
    }

    TEST_CASE("What is no evaluation, or one of other clips, is rejected by name") {
        const auto rejection = [](const std::string& text) {
            const auto read = readBack(text);
            REQUIRE_FALSE(read);
            return read.error().text();
        };
        CHECK(contains(rejection("[1, 2]"), "evaluation.json: is no objective evaluation"));
        CHECK(contains(rejection("system,clip\n"), "is no objective evaluation"));
        json earlier = evaluation();
        earlier["targets"][0].erase("accuracy");
        CHECK(contains(rejection(earlier.dump()), "written by an earlier program"));
        json twice = evaluation();
        twice["targets"][1]["target_id"] = "T1";
        CHECK(contains(rejection(twice.dump()), "has two targets named T1"));
        json damaged = evaluation();
        damaged["targets"][1]["target"] = "here";
        CHECK(contains(rejection(damaged.dump()), "is damaged"));
        CHECK_FALSE(readObjectiveAccuracy("no such file"));

        const auto objective = readBack(evaluation().dump());
        ResponseTable table = answers();
        table.target_positions["T2"] = {0.2, 1.0, 2.0005};
        CHECK(checkSameClips(*objective, table));
        table.target_positions["T2"] = {0.2, 1.0, 2.2};
        const auto elsewhere = checkSameClips(*objective, table);
        REQUIRE_FALSE(elsewhere);
        CHECK(contains(elsewhere.error().text(),
                       "has the target T2 at (0.200, 1.000, 2.000), the study at (0.200, 1.000, 2.200)"));
        table = answers();
        table.systems = {"other"};
        const auto others = checkSameClips(*objective, table);
        REQUIRE_FALSE(others);
        CHECK(contains(others.error().text(),
                       "has the systems far, middle, near; the answers are about other"));
    }
}
