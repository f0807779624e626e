// What the report's figures are told to draw, against the analysis. That it is drawn: tests/browser.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "fixtures.hpp"
#include "results/analysis/analysis.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/report/report.hpp"
#include "specifications.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::specificationsOf;
using deixis::tests::valuesWith;
using nlohmann::json;

namespace {

ResponseTable wholeStudy(const fixtures::Folder& folder) {
    const auto study = fixtures::study({"demonstration-nn", "direct", "stiff", "drifting"});
    fixtures::fill(folder / "a.sqlite", study, 39, 5, true, {0.86, 0.95, 0.83, 0.46}, {4.0, 3.6, 2.6, 2.9},
                   fixtures::everything);
    return loadResponses(folder / "a.sqlite").value();
}

}  // namespace

TEST_SUITE("results/report_figures") {
    TEST_CASE("Box plots draw the quantiles, notches and means of the analysis, and every participant") {
        const fixtures::Folder folder;
        const auto result = analyse(wholeStudy(folder));
        const auto analysis = json::parse(analysisJson(result));
        const auto figures = specificationsOf(renderReport(result));
        int with_notch = 0;
        int without_notch = 0;
        for (const auto& [id, measure] :
             {std::pair{"means-1", "accuracy"}, std::pair{"means-2", "naturalness"}}) {
            const json& spec = figures.at(id);
            const auto corners = valuesWith(spec, "corner");
            std::map<int, std::set<double>> heights;  // of the outlines' corners, by box
            for (const json& corner : corners)
                if (corner.contains("box")) heights[corner["box"]].insert(corner["y"].get<double>());
            std::size_t points = 0;
            std::set<std::pair<double, double>> places;
            for (const json& layer : spec["layer"])
                if (layer["mark"]["type"] == "circle")
                    for (const json& point : layer["data"]["values"]) {
                        places.emplace(point["x"], point["y"]);
                        ++points;
                    }
            CHECK(points == 4 * 39);
            CHECK(places.size() == points);  // none lies on another
            for (int i = 0; i < 4; ++i) {
                const json& system = analysis["systems"][static_cast<std::size_t>(i)][measure];
                const json& box = system["box"];
                for (const char* drawn : {"q25", "median", "q75"}) CHECK(heights[i].count(box[drawn]) == 1);
                // A notch that would reach beyond its box is left out.
                const double low = box["notch_low"];
                const double high = box["notch_high"];
                const bool notched = low >= box["q25"].get<double>() && high <= box["q75"].get<double>();
                (notched ? with_notch : without_notch) += 1;
                CHECK((heights[i].count(low) == 1) == notched);
                CHECK(*heights[i].begin() == box["q25"]);
                CHECK(*heights[i].rbegin() == box["q75"]);
                std::multiset<double> whiskers;
                for (const json& line : valuesWith(spec, "y2"))
                    if (std::abs(line["x"].get<double>() - i) < 0.4) {
                        whiskers.insert(line["y"].get<double>());
                        whiskers.insert(line["y2"].get<double>());
                    }
                CHECK(*whiskers.begin() == box["q05"]);
                CHECK(*whiskers.rbegin() == box["q95"]);
            }
        }
        CHECK(with_notch > 0);
        CHECK(without_notch > 0);
    }

    TEST_CASE(
        "Brackets stand over the pairs that differ, each with the stars of its p, and none over another") {
        const fixtures::Folder folder;
        const auto result = analyse(wholeStudy(folder));
        const auto figures = specificationsOf(renderReport(result));
        for (const auto& [id, measure] :
             {std::pair{"means-1", "accuracy"}, std::pair{"means-2", "naturalness"}}) {
            std::multiset<std::string> wanted;
            for (const auto& pair : result.pairwise)
                if (pair.measure == measure && pair.significant)
                    wanted.insert(*pair.p_holm <= 0.001 ? "***" : *pair.p_holm <= 0.01 ? "**" : "*");
            REQUIRE(wanted.size() > 1);
            std::multiset<std::string> drawn;
            for (const json& star : valuesWith(figures.at(id), "stars")) drawn.insert(star["stars"]);
            CHECK(drawn == wanted);
            std::map<double, std::vector<std::pair<double, double>>> levels;  // height: from, to
            std::map<int, std::vector<json>> brackets;
            for (const json& corner : valuesWith(figures.at(id), "bracket"))
                brackets[corner["bracket"]].push_back(corner);
            for (const auto& [bracket, corners] : brackets) {
                REQUIRE(corners.size() == 4);
                const double from = corners[1]["x"];
                const double to = corners[2]["x"];
                CHECK(from < to);
                for (const auto& [low, high] : levels[corners[1]["y"].get<double>()])
                    CHECK((to < low || high < from));
                levels[corners[1]["y"].get<double>()].emplace_back(from, to);
            }
        }
    }

    TEST_CASE("Bars of answers hold every answer once, around the middle of the scale") {
        const fixtures::Folder folder;
        const auto result = analyse(wholeStudy(folder));
        const json spec = specificationsOf(renderReport(result)).at("answers-2");
        std::map<int, std::map<std::string, json>> bars;
        for (const json& part : spec["data"]["values"])
            bars[static_cast<int>(std::lround(0.5 * (part["y"].get<double>() + part["y2"].get<double>())))]
                [part["step"]] = part;
        REQUIRE(bars.size() == 4);
        for (const auto& [system, parts] : bars) {
            double whole = 0.0;
            for (const auto& [step, part] : parts) {
                double answers = 0.0;
                double all = 0.0;
                for (const auto& row : result.table.rows)
                    if (row.measure == "naturalness" &&
                        row.system == result.table.systems[static_cast<std::size_t>(system)]) {
                        all += 1.0;
                        answers += row.value == std::stod(step) ? 1.0 : 0.0;
                    }
                CHECK(part["share"].get<double>() == doctest::Approx(answers / all));
                CHECK(part["x2"].get<double>() - part["x"].get<double>() == doctest::Approx(answers / all));
                whole += answers / all;
                if (step == "3") CHECK(part["x"].get<double>() == doctest::Approx(-part["x2"].get<double>()));
            }
            CHECK(whole == doctest::Approx(1.0));
        }
    }

    TEST_CASE("Differences are drawn of every participant who has both, with the test's own interval") {
        const fixtures::Folder folder;
        fixtures::fill(folder / "b.sqlite", fixtures::study({"direct", "stiff"}), 12, 5, false, {0.9, 0.5},
                       {4.0, 2.6}, [](int participant, const studies::Trial& trial) {
                           return participant != 7 || trial.index < 12;
                       });
        const auto result = analyse(loadResponses(folder / "b.sqlite").value());
        const json spec = specificationsOf(renderReport(result)).at("differences-1");
        const Comparison& pair = result.pairwise.front();
        CHECK(static_cast<int>(pair.differences.size()) == pair.test.n_pairs);
        double sum = 0.0;
        int points = 0;
        for (const json& layer : spec["layer"])
            if (layer["mark"]["type"] == "circle")
                for (const json& point : layer["data"]["values"]) {
                    sum += point["x"].get<double>();
                    ++points;
                }
        CHECK(points == pair.test.n_pairs);
        CHECK(sum / points == doctest::Approx(pair.mean_difference));
        const json shift = valuesWith(spec, "low").front();
        CHECK(shift["x"] == *pair.test.hodges_lehmann.estimate);
        CHECK(shift["low"] == *pair.test.hodges_lehmann.lower);
        CHECK(shift["high"] == *pair.test.hodges_lehmann.upper);
    }

    TEST_CASE("Names cannot end a figure's specification, nor the page") {
        const fixtures::Folder folder;
        ResponseTable table = wholeStudy(folder);
        const std::string name = "</script>&amp;]]>\"'\xff";
        for (auto& system : table.systems)
            if (system == "direct") system = name;
        for (auto& row : table.rows)
            if (row.system == "direct") row.system = name;
        const auto figures = specificationsOf(renderReport(analyse(table)));
        CHECK(figures.size() == 7);
        CHECK(tests::contains(figures.at("means-1")["description"].get<std::string>(),
                              "</script>&amp;]]>\"'\ufffd"));
    }

    TEST_CASE(
        "Right choices stand where their targets do: the avatar's left on the left, ahead and up are up") {
        ResponseTable table;
        table.systems = {"x", "y"};
        const Vec3 left_low_far{0.5, 0.4, 2.0};
        const Vec3 right_high_near{-0.5, 1.6, 1.0};
        table.choices = {{"A", "x", "T1", {left_low_far, right_high_near}, 0, 0, 0.0, 2.0},
                         {"A", "x", "T2", {left_low_far, right_high_near}, 1, 0, 0.0, 2.0},
                         {"A", "y", "T2", {left_low_far, right_high_near}, 1, 1, 0.0, 2.0}};
        const auto figures = specificationsOf(renderReport(analyse(table)));
        REQUIRE(figures.contains("places"));
        const auto points = valuesWith(figures.at("places"), "mean");
        REQUIRE(points.size() == 6);  // three places, from above and from behind
        const auto at = [&](std::size_t i, const char* axis) { return points[i][axis].get<double>(); };
        CHECK(points[0]["mean"] == 1.0);
        CHECK(points[2]["mean"] == 0.0);
        CHECK(at(0, "x") < at(2, "x"));
        CHECK(at(1, "x") < at(3, "x"));
        CHECK(at(0, "y") < at(2, "y"));                          // farther ahead; the axis counts downwards
        CHECK(at(1, "y") > at(3, "y"));                          // lower
        CHECK(at(4, "y") == doctest::Approx(at(2, "y") + 1.0));  // the second system's row
        CHECK(tests::contains(points[0]["tip"].get<std::string>(), "x, T1: 1 of 1"));
    }
}
