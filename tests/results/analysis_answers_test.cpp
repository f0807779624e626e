// Which answers an analysis takes: with and without exclusions, in groups, one by one; and factors of any
// name.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "answers_text.hpp"
#include "core/files.hpp"
#include "csv_table.hpp"
#include "fixtures.hpp"
#include "oracles.hpp"
#include "page_text.hpp"
#include "paths.hpp"
#include "results/answers/long_table.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/report/report.hpp"
#include "text.hpp"
#include "xml.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::close;
using deixis::tests::contains;
using deixis::tests::pageText;
using fixtures::analyseText;
using nlohmann::json;

namespace {

AnalysisResult analyseOracle() {
    const auto table =
        loadLongTable(deixis::tests::sourceDir() / "tests/results/oracles/analysis.csv", {{"Group"}, {}});
    REQUIRE_MESSAGE(table.has_value(), (table ? "" : table.error().text()));
    return analyse(*table);
}

std::string errorOfText(const std::string& text, const LongTableOptions& choice) {
    const fixtures::Folder folder;
    REQUIRE(writeFile(folder / "answers.csv", text).has_value());
    const auto table = loadAnswers(folder / "answers.csv", choice);
    REQUIRE_FALSE(table.has_value());
    return table.error().text();
}

}  // namespace

TEST_SUITE("results/analysis_answers") {
    TEST_CASE("Pairs are tested with who is excluded, and without what is in doubt, as SciPy tests them") {
        const json expected = tests::oracles("analysis")[0];
        const AnalysisResult result = analyseOracle();
        const auto counts = [&](const AnswerCounts& found, const char* name) {
            CHECK(found.participants == expected[name]["participants"].get<int>());
            CHECK(found.answers == expected[name]["answers"].get<int>());
        };
        counts(result.headline_answers, "headline");
        counts(result.other_answers[0], "with_left_out");
        counts(result.other_answers[1], "without_doubtful");
        REQUIRE(result.sensitivity.size() == 3);
        for (std::size_t i = 0; i < 3; ++i) {
            const SensitivityResult& one = result.sensitivity[i];
            const auto test = [&](const AdjustedTest& found, const char* name) {
                const json& pair = expected[name]["pairs"][i];
                CHECK(found.test.n_pairs == pair["n"].get<int>());
                CHECK(close(found.test.p_two_sided, pair["p"], 1e-9));
                CHECK(close(found.p_holm, pair["p_holm"], 1e-9));
            };
            CHECK(one.a == expected["headline"]["pairs"][i]["a"].get<std::string>());
            CHECK(one.b == expected["headline"]["pairs"][i]["b"].get<std::string>());
            test(one.headline, "headline");
            test(one.other(AnswerChoice::with_left_out).test, "with_left_out");
            test(one.other(AnswerChoice::without_doubtful).test, "without_doubtful");
        }
        // At 0.01: a-b 0.003, 0.379, 0.043; a-c 0.0002, 0.292, 0.006; b-c never.
        CHECK(result.sensitivity[0].other(AnswerChoice::with_left_out).changes);
        CHECK(result.sensitivity[0].other(AnswerChoice::without_doubtful).changes);
        CHECK(result.sensitivity[1].other(AnswerChoice::with_left_out).changes);
        CHECK_FALSE(result.sensitivity[1].other(AnswerChoice::without_doubtful).changes);
        CHECK_FALSE(result.sensitivity[2].other(AnswerChoice::with_left_out).changes);

        const json out = json::parse(analysisJson(result))["sensitivity"];
        CHECK(out["pairs"][0]["changes"] == json{"with_left_out", "without_doubtful"});
        CHECK(out["pairs"][0]["normal"]["p"] == result.pairwise[0].test.normal_p_two_sided);
        CHECK(out["with_left_out"]["participants"] == 20);
        const std::string page = renderReport(result);
        const tests::XmlDocument document(page);
        CHECK(document.count("//h:h2[.='Decisions under other choices']") == 1);
        const double unsure = expected["without_doubtful"]["pairs"][0]["p_holm"];
        CHECK(document.count(fmt::format("//h:td[.='{:.3f} (no)']", unsure)) > 0);
        REQUIRE(result.table.left_out.size() == 3);
        CHECK(result.table.left_out[0].reason == "slept");
    }

    TEST_CASE("Groups are compared over all systems and within each, as SciPy compares them") {
        const json expected = tests::oracles("analysis")[0]["between"];
        const AnalysisResult result = analyseOracle();
        REQUIRE(result.between.size() == expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const BetweenResult& one = result.between[i];
            const json& right = expected[i];
            CAPTURE(one.system);
            CHECK(one.system == right["system"].get<std::string>());
            const bool swapped = one.a != right["a"].get<std::string>();
            REQUIRE_FALSE(swapped);
            CHECK(one.test.n_a == right["n_a"].get<int>());
            CHECK(one.test.n_b == right["n_b"].get<int>());
            CHECK(close(one.mean_a, right["mean_a"], 1e-12));
            CHECK(close(one.mean_b, right["mean_b"], 1e-12));
            CHECK(close(one.test.u, right["u"], 1e-12));
            CHECK(close(one.test.p_two_sided, right["p"], 1e-9));
            CHECK(close(one.p_holm, right["p_holm"], 1e-9));
            CHECK(close(one.test.a12, right["a12"], 1e-12));
            CHECK(close(one.test.cliffs_delta, right["cliffs_delta"], 1e-9));
            CHECK(close(one.test.hodges_lehmann.estimate, right["hodges_lehmann"], 1e-9));
            CHECK(one.family_size == 4);
        }
    }

    TEST_CASE("Groups' preferences are compared in each pair of systems, whichever stood left") {
        // Net preferences for x over y: 2, 1.5, 1 of the old, -1, 0, 0.5 of the young; z was compared by two.
        ResponseTable table;
        table.systems = {"x", "y", "z"};
        table.measures = {{"preference", MeasureKind::preference, -2.0, 2.0, 0, 0}};
        table.between = {{"age", {"old", "young"}}, {"hand", {"left", "right"}}};
        const auto answer = [&](const std::string& who, const std::string& left, const std::string& right,
                                double value) {
            ResponseRow row{who, "preference", left};
            row.other_system = right;
            row.value = value;
            table.rows.push_back(row);
        };
        answer("A", "x", "y", -2.0);
        answer("B", "y", "x", 2.0);
        answer("B", "x", "y", -1.0);
        answer("C", "x", "y", -1.0);
        answer("D", "y", "x", -1.0);
        answer("E", "x", "y", 0.0);
        answer("F", "x", "y", 0.0);
        answer("F", "y", "x", 1.0);
        answer("A", "z", "y", 1.0);
        answer("D", "y", "z", 1.0);
        for (const char* who : {"A", "B", "C"}) table.groups[who]["age"] = "old";
        for (const char* who : {"D", "E", "F"}) table.groups[who]["age"] = "young";
        const AnalysisResult result = analyse(table);
        REQUIRE(result.preferences_between.size() == 4);  // two pairs, of each factor
        const PreferenceBetweenResult& one = result.preferences_between[0];
        CHECK(one.system == "x");
        CHECK(one.other_system == "y");
        CHECK(one.a == "old");
        CHECK(one.mean_a == 1.5);
        CHECK(one.mean_b == doctest::Approx(-1.0 / 6.0));
        CHECK(one.test.u == 9.0);                                     // all old ones above all young ones
        CHECK(one.test.p_two_sided.value() == doctest::Approx(0.1));  // 2 of 20 ways to take three of six
        CHECK(one.test.hodges_lehmann.estimate.value() == 1.5);
        CHECK(one.answers_a.wins == 4);
        CHECK(one.answers_b.wins == 1);
        CHECK(one.answers_b.ties == 2);
        CHECK(one.answers_b.losses == 1);
        CHECK(one.family == "preference: age");
        CHECK(one.family_size == 2);
        CHECK(one.p_holm.value() == doctest::Approx(0.2));
        const PreferenceBetweenResult& other = result.preferences_between[1];
        CHECK(other.system == "y");
        CHECK(other.mean_a == 1.0);  // y stood right of z
        CHECK(other.mean_b == -1.0);
        CHECK(other.p_holm == 1.0);
        CHECK_FALSE(result.preferences_between[2].p_holm.has_value());  // nobody's hand is known

        const json row = json::parse(analysisJson(result))["preferences_between"][0];
        CHECK(row["answers_b"] == json{{"n", 4}, {"wins", 0.25}, {"ties", 0.5}, {"losses", 0.25}});
        CHECK(row["u"] == 9.0);
        const std::string page = renderReport(result);
        CHECK(contains(page, "Preferences by age"));
        CHECK(contains(pageText(page), "25 / 50 / 25\u00a0%"));
        CHECK_FALSE(contains(page, "Preferences by hand"));
        CHECK(contains(page, "No test of the groups by age is significant in their preferences"));
        const tests::CsvTable written(fixtures::csvOf(result, "preferences_between.csv"));
        CHECK(written.has({{"factor", "age"},
                           {"system", "x"},
                           {"other_system", "y"},
                           {"a", "old"},
                           {"b", "young"},
                           {"answers_a", "4"},
                           {"wins_a", "1"},
                           {"answers_b", "4"},
                           {"wins_b", "0.25"},
                           {"ties_b", "0.5"},
                           {"losses_b", "0.25"}}));
    }

    TEST_CASE("Ratings one by one, and the median of participants, are as NumPy has them") {
        const json expected = tests::oracles("analysis")[0]["pooled"];
        const AnalysisResult result = analyseOracle();
        REQUIRE(result.pooled.size() == expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const PooledResult& one = result.pooled[i];
            CHECK(one.n == expected[i]["n"].get<int>());
            CHECK(close(one.mean, expected[i]["mean"], 1e-12));
            CHECK(close(one.sd, expected[i]["sd"], 1e-9));
            const double found[] = {one.q05, one.q25, one.median, one.q75, one.q95};
            for (std::size_t k = 0; k < 5; ++k) CHECK(close(found[k], expected[i]["quantiles"][k], 1e-12));
            CHECK(close(result.systems[i].measures[0].median, expected[i]["median_of_participants"], 1e-12));
        }
        CHECK(hasManySteps(result.measures[0]));
        CHECK(contains(renderReport(result), "median of participants"));
        CHECK(contains(renderReport(result), "pseudo-replicated"));
    }

    TEST_CASE("A factor of any name is tested within systems, or over them where it is nested in them") {
        std::string text = "participant,system,rating,Style,hold\n";
        // Within a: lively one higher for all of three; b is lively - calm = -1, 0, 2. hold: a short, b long.
        for (const auto& [who, b_lively] : {std::pair{"P1", 1}, {"P2", 2}, {"P3", 4}})
            text += fmt::format(
                "{0},a,3,calm,short\n{0},a,4,lively,short\n{0},b,2,calm,long\n{0},b,{1},"
                "lively,long\n",
                who, b_lively);
        const AnalysisResult result = analyseText(text, {{}, {"style", "HOLD"}});
        REQUIRE(result.level_tests.size() == 3);
        const Comparison& in_a = result.level_tests[0];
        CHECK(in_a.factor == "Style");
        CHECK(in_a.system == "a");
        CHECK(in_a.a == "calm");
        CHECK(in_a.mean_difference == -1.0);
        CHECK(in_a.test.p_two_sided == 0.25);  // 2 of 8 sign patterns
        CHECK(in_a.family_size == 2);
        CHECK(in_a.p_holm.value() == 0.5);
        CHECK(result.level_tests[1].test.n_zero == 1);
        const Comparison& over = result.level_tests[2];
        CHECK(over.factor == "hold");
        CHECK(over.system == "all");
        // a: 3.5 each; b: 1.5, 2, 3.
        CHECK(over.mean_difference == doctest::Approx((2.0 + 1.5 + 0.5) / 3.0));
        CHECK(over.family == "rating: hold over systems");
        const json out = json::parse(analysisJson(result));
        REQUIRE(out["factor_levels"].size() == 12);
        CHECK(out["factor_levels"][1]["level"] == "lively");
        CHECK(out["factor_levels"][1]["mean"].get<double>() == doctest::Approx(19.0 / 6.0));
        CHECK(out["factor_tests"].size() == 3);
        CHECK(out["layouts"].empty());
        CHECK(contains(renderReport(result), "Rating by hold"));
    }

    TEST_CASE("What is told of a participant must not change, and a factor's column must be there") {
        const std::string head = "participant,system,rating,excluded,sex\n";
        CHECK(contains(errorOfText(head + "P1,a,1,,f\nP1,a,1,1,f\n", {}),
                       ":3: column \"excluded\": found \"excluded\", but \"no\" in an earlier line"));
        CHECK(contains(errorOfText(head + "P1,a,1,,f\nP1,a,1,,m\n", {{"sex"}, {}}),
                       ":3: column \"sex\": found \"m\", but \"f\" in an earlier line of participant P1"));
        CHECK(contains(errorOfText(head + "P1,a,1,,f\n", {{"age"}, {}}), "there is no such column"));
        CHECK(contains(errorOfText(head + "P1,a,1,,f\n", {{}, {"system"}}), "already has a meaning"));
        CHECK(contains(errorOfText(head + "P1,a,1,,f\n", {{"sex"}, {"sex"}}), "is named twice"));
        CHECK(contains(errorOfText(head + "P1,a,1,asleep,f\n", {}), "has no answers"));
        CHECK(contains(errorOfText("", {}), "the file is empty (0 bytes)"));
    }

    TEST_CASE("The table of answers keeps who is left out, what is marked, and the groups") {
        const AnalysisResult first = analyseOracle();
        std::string answers;
        for (const auto& [name, bytes] : analysisTables(first, TableFormat::csv))
            if (name == "answers.csv") answers = bytes;
        const AnalysisResult again = analyseText(answers, {{"group"}, {}});
        const auto with_left_out = AnswerChoice::with_left_out;
        CHECK(again.sensitivity[0].other(with_left_out).test.p_holm ==
              first.sensitivity[0].other(with_left_out).test.p_holm);
        CHECK(again.other_answers[0].answers == first.other_answers[0].answers);
        CHECK(again.between[0].p_holm == first.between[0].p_holm);
        CHECK(again.table.left_out[1].participant == "P08");
        int marked = 0;
        for (const ResponseRow& row : again.table.rows) marked += row.marked.empty() ? 0 : 1;
        for (const ResponseRow& row : first.table.rows) marked -= row.marked.empty() ? 0 : 1;
        CHECK(marked == 0);
    }

    TEST_CASE("Files of one study join their groups and further factors, in whatever order they stand") {
        const std::string one = "participant,system,rating,u,v,g\nP1,a,1,u1,v1,x\nP1,b,2,u2,v1,x\n";
        const std::string two = "participant,system,rating,v,u,g\nP2,a,3,v2,u2,y\nP2,b,4,v1,u1,y\n";
        const fixtures::Folder folder;
        REQUIRE(writeFile(folder / "one.csv", one).has_value());
        REQUIRE(writeFile(folder / "two.csv", two).has_value());
        const auto joined = joinTables({loadLongTable(folder / "one.csv", {{"g"}, {"u", "v"}}).value(),
                                        loadLongTable(folder / "two.csv", {{"g"}, {"v", "u"}}).value()});
        REQUIRE(joined.has_value());
        REQUIRE(joined->rows.size() == 4);
        CHECK(levelOf(*joined, joined->rows[2], "v") == "v2");
        CHECK(levelOf(*joined, joined->rows[2], "u") == "u2");
        CHECK(joined->between[0].levels == std::vector<std::string>{"x", "y"});
        CHECK(joined->groups.at("P2").at("g") == "y");
    }

    TEST_CASE("Scores are given for all and for each group, with their quartiles") {
        ResponseTable table;
        table.between = {{"style", {"calm", "lively"}}};
        for (const auto& [who, level, value] :
             {std::tuple("A", "calm", 1.0), {"B", "calm", 2.0}, {"C", "lively", 3.0}, {"D", "calm", 10.0}}) {
            table.scores.push_back({who, "after", "total", value});
            table.groups[who]["style"] = level;
        }
        const AnalysisResult result = analyse(table);
        REQUIRE(result.scores.size() == 3);
        CHECK(result.scores[0].factor.empty());
        CHECK(result.scores[0].median == 2.5);
        CHECK(result.scores[0].q25 == 1.75);  // a quarter of the way from the first to the last: 1 + 3/4
        CHECK(result.scores[0].q75 == 4.75);
        CHECK(result.scores[1].level == "calm");
        CHECK(result.scores[1].median == 2.0);
        CHECK(result.scores[1].n == 3);
        CHECK(result.scores[2].mean == 3.0);
        const json out = json::parse(analysisJson(result));
        CHECK(out["scores"].size() == 1);
        CHECK(out["scores_by_group"].size() == 2);
    }
}
