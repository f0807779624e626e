// Designs beyond the first paper's: systems between participants, equal means, few participants.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "answers_text.hpp"
#include "core/files.hpp"
#include "fixtures.hpp"
#include "results/analysis_tables.hpp"
#include "results/long_table.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::results;
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
        CHECK(contains(page, "systems that no participant met both of"));
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
            contains(page, "No test of layout is significant in rating, for any system; that does not show"));
        CHECK(contains(page, "No test of the groups by group is significant in rating"));
        CHECK_FALSE(contains(page, "made no significant difference"));
        CHECK_FALSE(contains(page, "do not differ"));
    }
}
