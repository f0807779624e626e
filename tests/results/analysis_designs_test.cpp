// Designs beyond the first paper's: systems between participants, equal means, few participants.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "answers_text.hpp"
#include "core/files.hpp"
#include "csv_table.hpp"
#include "fixtures.hpp"
#include "oracles.hpp"
#include "results/answers/long_table.hpp"
#include "results/answers/stations.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/report/report.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::close;
using deixis::tests::contains;
using fixtures::analyseText;
using nlohmann::json;

TEST_SUITE("results/analysis_designs") {
    TEST_CASE("Systems that no participant met both of are compared as groups, worked by hand") {
        // Four see a and four see b, and all of a's means are above all of b's: of 70 ways to share eight
        // ranks out one is as far up, and one as far down. c is seen by those of a: pairs.
        std::string text = "participant,system,rating\n";
        for (int p = 1; p <= 4; ++p)
            text += fmt::format("A{0},a,{1}\nA{0},a,{2}\nB{0},b,{0}\nA{0},c,{3}\n", p, 10 + p, 11 + p, p % 2);
        const AnalysisResult result = analyseText(text);
        REQUIRE(result.between.size() == 2);  // a and b, b and c
        const BetweenResult& one = result.between[0];
        CHECK(one.factor == "system");
        CHECK(one.system == "all");
        CHECK(one.a == "a");
        CHECK(one.b == "b");
        CHECK(one.test.n_a == 4);
        CHECK(*one.test.p_two_sided == doctest::Approx(2.0 / 70.0));
        CHECK(one.family == "rating: pairs of systems, between participants");
        CHECK(one.family_size == 2);
        CHECK(one.mean_a == 13.0);
        CHECK(result.pairwise[1].test.n_pairs == 4);  // a and c are paired as ever
        CHECK(result.pairwise[1].family_size == 1);

        const std::string page = renderReport(result);
        CHECK(contains(page, "systems that no participant saw both of"));
        CHECK(contains(page, ", compared between participants."));
        const json out = json::parse(analysisJson(result))["between"];
        CHECK(out[0]["factor"] == "system");
        CHECK(out[0]["p"].get<double>() == doctest::Approx(2.0 / 70.0));
        AnalysisResult again = result;
        runTests(again);
        CHECK(again.between.size() == 2);
    }

    TEST_CASE("Systems with the same highest mean are both named") {
        const AnalysisResult result = analyseText(
            "participant,system,rating\nP1,a,4\nP1,b,4\nP1,c,1\nP2,a,4\nP2,b,4\nP2,c,2\nP3,a,4\nP3,b,4\nP3,c,"
            "1\n");
        CHECK(contains(renderReport(result),
                       "<b>a</b> and <b>b</b> (each 4.00) had the highest mean rating, "
                       "<b>c</b> (1.33) the lowest."));
    }

    TEST_CASE("What is not significant is never told as no difference") {
        std::string text = "participant,system,layout,rating,group\n";
        for (int p = 1; p <= 8; ++p)
            for (const char* layout : {"across", "beside"})
                for (const char* system : {"a", "b"})
                    text += fmt::format("P{},{},{},{},{}\n", p, system, layout,
                                        1 + (p + (system[0] == 'a' ? 1 : 2) * (layout[0] == 'a' ? 1 : 3)) % 5,
                                        p % 2 == 0 ? "x" : "y");
        const std::string page = renderReport(analyseText(text, {{"group"}, {}}));
        CHECK(
            contains(page, "No test of layout is significant in rating, for any system; this does not show"));
        CHECK(contains(page, "No test of the groups by group is significant in rating"));
        CHECK_FALSE(contains(page, "made no significant difference"));
        CHECK_FALSE(contains(page, "do not differ"));
    }

    TEST_CASE("Interactions of factors, with layouts and with groups, and equivalence, as R tests them") {
        const json expected = tests::oracles("designs")[0];
        AnalysisOptions options;
        options.equivalence = {{"rating", expected["equivalence"]["bound"].get<double>()}};
        const AnalysisResult result =
            analyseText(expected["csv"].get<std::string>(), {{"group"}, {"speed", "path"}}, options);
        const auto within = [&](const char* factor, const char* other) {
            const auto found = std::find_if(result.interactions.begin(), result.interactions.end(),
                                            [&](const InteractionResult& one) {
                                                return one.factor == factor && one.other_factor == other;
                                            });
            REQUIRE(found != result.interactions.end());
            return *found;
        };
        const InteractionResult crossed = within("speed", "path");
        CHECK(crossed.test.n_pairs == 16);
        CHECK(close(crossed.mean_difference, expected["speed_path"]["mean"], 1e-9));
        CHECK(close(crossed.test.p_two_sided, expected["speed_path"]["p"], 1e-9));
        CHECK(crossed.p_holm == crossed.test.p_two_sided);  // the only one of its family
        CHECK(crossed.family == "rating: speed x path");
        CHECK(crossed.significant);
        const InteractionResult layouts = within("system", "layout");
        CHECK(layouts.a == "slow smooth");
        CHECK(layouts.b == "slow jerky");
        CHECK(layouts.family_size == 6);
        CHECK(close(layouts.mean_difference, expected["system_layout"]["mean"], 1e-9));
        CHECK(close(layouts.test.p_two_sided, expected["system_layout"]["p"], 1e-9));
        // A factor that is nested in the systems does not cross with them.
        for (const InteractionResult& one : result.interactions)
            CHECK_FALSE((one.factor == "system" && one.other_factor != "layout"));

        const auto groups =
            std::find_if(result.group_interactions.begin(), result.group_interactions.end(),
                         [](const GroupInteractionResult& one) { return one.other_factor == "path"; });
        REQUIRE(groups != result.group_interactions.end());
        CHECK(close(groups->test.p_two_sided, expected["path_group"]["p"], 1e-9));
        const bool expert_first = groups->a == "expert";
        CHECK(close(expert_first ? groups->mean_a : groups->mean_b, expected["path_group"]["mean_expert"],
                    1e-8));

        const auto pair = std::find_if(
            result.pairwise.begin(), result.pairwise.end(),
            [](const Comparison& one) { return one.a == "slow jerky" && one.b == "fast smooth"; });
        REQUIRE(pair != result.pairwise.end());
        REQUIRE(pair->equivalence.has_value());
        CHECK(close(pair->equivalence->p, expected["equivalence"]["p"], 1e-9));

        const std::string page = renderReport(result);
        CHECK(contains(page,
                       "Significant interaction of speed and path in rating: slow against fast differs "
                       "between smooth and jerky."));
        CHECK(contains(page, "Equivalence within a bound"));
        const json out = json::parse(analysisJson(result));
        CHECK(out["interactions"].size() == result.interactions.size());
        CHECK(out["pairwise"][0]["equivalence"]["bound"] == 0.75);
        CHECK(tests::CsvTable(fixtures::csvOf(result, "equivalence.csv"))
                  .has({{"measure", "rating"}, {"factor", ""}, {"system", ""}, {"a", "slow smooth"}}));
    }

    TEST_CASE("Equivalence needs a bound, and a difference beyond it is none, worked by hand") {
        // Six differences of 1 to 6 hundredths: all lie within 0.1, so both sums of ranks are the largest:
        // 1/64.
        std::string text = "participant,system,rating\n";
        for (int p = 1; p <= 6; ++p) text += fmt::format("P{0},a,3.0{0}\nP{0},b,3\n", p);
        AnalysisOptions options;
        options.alpha = 0.05;
        options.equivalence = {{"rating", 0.1}};
        const AnalysisResult near_by = analyseText(text, {}, options);
        REQUIRE(near_by.pairwise[0].equivalence.has_value());
        CHECK(near_by.pairwise[0].equivalence->p == 1.0 / 64.0);
        CHECK(near_by.pairwise[0].equivalence->equivalent);
        CHECK(near_by.pairwise[0].significant);  // and yet none that matters
        options.equivalence = {{"rating", 0.02}};
        CHECK_FALSE(analyseText(text, {}, options).pairwise[0].equivalence->equivalent);
        CHECK_FALSE(analyseText(text).pairwise[0].equivalence.has_value());
    }

    TEST_CASE("Two participants have no interval that covers 95 %, and the reader is told") {
        AnalysisOptions options;
        options.level = 0.95;
        const auto of = [&](int participants) {
            std::string text = "participant,system,rating\n";
            for (int p = 1; p <= participants; ++p)
                text += fmt::format("P{0},a,{1}\nP{0},b,{2}\n", p, 1 + p % 4, 2 + p % 3);
            return analyseText(text, {}, options);
        };
        const AnalysisResult two = of(2);
        CHECK(two.systems[0].measures[0].interval_falls_short);
        bool told = false;
        for (const std::string& remark : two.remarks)
            told = told ||
                   contains(remark, "covers the median in only 50 % of all samples, and 95 % were requested");
        CHECK(told);
        CHECK(contains(renderReport(two), "it is too narrow"));
        CHECK(of(5).systems[0].measures[0].interval_falls_short);        // 1 - 2^-4 = 0.9375
        CHECK_FALSE(of(6).systems[0].measures[0].interval_falls_short);  // 0.96875
    }

    TEST_CASE("Answers of one headset session are not a mean with those of nineteen desktops") {
        std::string text = "participant,system,rating,station,synthetic\n";
        for (int p = 1; p <= 20; ++p)
            for (const char* system : {"a", "b"})
                text += fmt::format("P{:02},{},{},{},0\n", p, system, p == 20 ? 5 : 1 + p % 2,
                                    p == 20 ? "headset" : "desktop");
        const std::string with_simulated = text + "S1,a,5,simulated,1\nS1,b,5,simulated,1\n";
        const fixtures::Folder folder;
        REQUIRE(writeFile(folder / "a.csv", with_simulated).has_value());
        const ResponseTable table = loadAnswers(folder / "a.csv", {}).value();
        CHECK(stationKinds(table) == std::vector<std::string>{"desktop", "headset", "simulated"});
        const AnalysisResult desktop = analyse(onlyAt(table, "desktop"));
        CHECK(desktop.participants == 19);
        CHECK(desktop.systems[0].measures[0].mean == doctest::Approx(29.0 / 19.0));
        CHECK(analyse(onlyAt(table, "headset")).systems[0].measures[0].mean == 5.0);
        CHECK(analyse(onlyAt(table, "simulated")).synthetic);

        const AnalysisResult together = analyse(withStations(table));
        CHECK(together.participants == 20);
        REQUIRE(together.between.size() == 3);
        CHECK(together.between[0].factor == "station");
        CHECK(*together.between[0].test.p_two_sided == 0.1);  // one of twenty places at the top, twice

        // Whoever forgets to part them gets people's answers alone.
        const AnalysisResult mixed = analyse(table);
        CHECK_FALSE(mixed.synthetic);
        CHECK(mixed.participants == 20);
        CHECK(contains(mixed.remarks.front(), "2 answers of simulated participants are left out"));
    }
}
