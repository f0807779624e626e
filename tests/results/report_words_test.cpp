// What the page says of data, and that it says no more than was computed.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "answers_text.hpp"
#include "fixtures.hpp"
#include "results/analysis/analysis.hpp"
#include "results/answers/stations.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/report/report.hpp"
#include "specifications.hpp"
#include "text.hpp"
#include "xml.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;
using deixis::tests::specificationsOf;
using deixis::tests::valuesWith;
using fixtures::analyseText;
using nlohmann::json;

namespace {

/// Six people, two systems, two layouts; ratings in tenths of a scale from 1 to 100.
std::string ratings(int people) {
    std::string text = "participant,system,layout,measure,rating\n";
    for (int p = 1; p <= people; ++p)
        text += fmt::format(
            "P{0},a,near,ease,{1}\nP{0},a,far,ease,{2}\nP{0},b,near,ease,1\nP{0},b,far,ease,100\n", p,
            40 + 3 * p, 60 + p * p % 7);
    return text;
}

ResponseTable preferencesOf(int people) {
    ResponseTable out;
    out.systems = {"a", "b", "c"};
    out.measures = {{"preference", MeasureKind::preference, -2.0, 2.0, 0, 3 * people}};
    for (int p = 0; p < people; ++p)
        for (int pair = 0; pair < 3; ++pair) {
            ResponseRow row;
            row.participant = fmt::format("P{:02}", p);
            row.measure = "preference";
            row.system = out.systems[pair == 2 ? 1 : 0];
            row.other_system = out.systems[pair == 0 ? 1 : 2];
            row.value = (p + pair) % 4 - 2;
            out.rows.push_back(row);
        }
    return out;
}

}  // namespace

TEST_SUITE("results/report_words") {
    TEST_CASE("Only the study of Deichler et al. follows Deichler et al.") {
        ResponseTable table = analyseText(ratings(6)).table;
        for (const auto& [name, hash, follows] : {std::tuple{"", "", false},
                                                  {"pointing2023", "", false},
                                                  {"other", "aa", false},
                                                  {"pointing2023", "aa", true}}) {
            table.study_name = name;
            table.study_hash = hash;
            const std::string page = renderReport(analyse(table));
            CHECK(contains(page, "Deichler") == follows);
            CHECK(contains(page, "the paper's") == false);
        }
    }

    TEST_CASE(
        "Motion that the program made is called synthetic, by the systems' names; a lab's clips are not") {
        ResponseTable table = preferencesOf(9);
        CHECK_FALSE(contains(renderReport(analyse(table)), "is synthetic"));
        table.built_in_systems = {"a", "c"};
        CHECK(contains(renderReport(analyse(table)),
                       "The motion of a and c is synthetic: this program made it"));
    }

    TEST_CASE("Preferences alone have no words on means, boxes or bootstraps, and every pair its numbers") {
        const AnalysisResult result = analyse(preferencesOf(9));
        const std::string page = renderReport(result);
        for (const char* absent : {"Box plots", "SD participants", "bootstrap intervals over participants (",
                                   "participants' means under two systems", "Iman", "by layout"})
            CHECK_MESSAGE(!contains(page, absent), absent);
        CHECK(contains(page, "We compared their mean preferences in each pair of systems, against none by") ==
              false);
        CHECK(contains(page,
                       "We compared participants' mean preferences in each pair of systems, against none, by "
                       "two-sided Wilcoxon signed-rank tests"));
        REQUIRE(result.preferences.size() == 3);
        for (const PreferenceResult& one : result.preferences)
            CHECK(contains(page,
                           fmt::format("{} against {} (n = 9, W = {:g}, p ", one.a, one.b, one.test.w_plus)));
    }

    TEST_CASE("One participant: no test, interval or box plot is claimed") {
        const AnalysisResult result = analyseText(ratings(1));
        const std::string page = renderReport(result);
        for (const char* absent : {"Wilcoxon", "bootstrap intervals", "Box plots.", "What the box plots show",
                                   "answers each", "Significant:"})
            CHECK_MESSAGE(!contains(page, absent), absent);
        CHECK(contains(page, "The answers come from 1 participant, who gave 4 answers."));
    }

    TEST_CASE("The results paragraph has n, W, p, r and interval of each comparison; the program is named") {
        AnalysisResult result = analyseText(ratings(6));
        result.options.program = "deixis 9.9 (commit abc)";
        const std::string page = renderReport(result);
        const json out = json::parse(analysisJson(result));
        std::size_t comparisons = 0;
        for (const char* tests : {"pairwise", "layout_tests"})
            for (const json& one : out[tests]) {
                ++comparisons;
                const double r = one["rank_biserial"];
                const json& shift = one["hodges_lehmann"];
                CHECK(contains(
                    page, fmt::format(
                              "{} against {} (n = {}, W = {:g}, p = {:.3f}, Holm-corrected p = {:.3f}, r = {}"
                              "{:.2f}, shift ",
                              one["a"].get<std::string>(), one["b"].get<std::string>(), one["n"].get<int>(),
                              one["w_plus"].get<double>(), one["p"].get<double>(),
                              one["p_holm"].get<double>(), r < 0.0 ? "\u2212" : "", std::abs(r))));
                CHECK(contains(page, fmt::format("{:.2f}", std::abs(shift["lower"].get<double>()))));
            }
        CHECK(comparisons == 3);
        CHECK(contains(page, "Computed with Deixis 9.9 (commit abc)."));
        CHECK(contains(page, "The Deixis authors (2026). Deixis 9.9 (commit abc)"));
    }

    TEST_CASE("How many were planned is told of a study alone, and by station as it was planned") {
        const auto answered = [](const std::string& page, const char* said) {
            return tests::XmlDocument(page).count(std::string("//h:dd[.='") + said + "']");
        };
        CHECK(answered(renderReport(analyseText(ratings(6))), "6 have answered") == 1);
        const fixtures::Folder folder;
        fixtures::fill(
            folder / "a.sqlite", fixtures::study({"x", "y"}), 3, 2, false, {0.9, 0.5}, {4.0, 2.0},
            [](int participant, const studies::Trial& trial) { return participant != 3 || trial.index < 5; });
        const ResponseTable table = loadResponses(folder / "a.sqlite").value();
        CHECK(contains(renderReport(analyse(table)), "3 of 3 planned have answered"));
        const AnalysisResult here = analyse(onlyAt(table, "desktop"));
        const std::string page = renderReport(here);
        CHECK(answered(page, "3 have answered") == 1);
        CHECK(contains(page, "16 of 24 planned on accuracy"));
        CHECK(json::parse(analysisJson(here))["study"]["planned_participants"].is_null());
    }

    TEST_CASE(
        "Levels are drawn with the means and intervals of the analysis; ticks are round and end the scale") {
        const AnalysisResult result = analyseText(ratings(6));
        const auto figures = specificationsOf(renderReport(result));
        REQUIRE(figures.contains("levels-1-1"));
        const json rows = json::parse(analysisJson(result))["layouts"];
        const auto points = figures.at("levels-1-1")["data"]["values"];
        CHECK(points.size() == 4);
        for (const json& point : points) {
            int found = 0;
            for (const json& row : rows)
                found += row["system"] == point["system"] && row["mean_participants"] == point["y"] &&
                                 (row["interval"].is_null() || (row["interval"]["lower"] == point["low"] &&
                                                                row["interval"]["upper"] == point["high"]))
                             ? 1
                             : 0;
            CHECK(found >= 1);
        }
        const json& axis = figures.at("levels-1-1")["layer"][0]["encoding"]["y"]["axis"];
        CHECK(axis["values"] == json({1.0, 20.0, 40.0, 60.0, 80.0, 100.0}));
    }
}
