// deixis stats: what it prints, and what it says of files that it cannot read.
#include <cmath>
#include <sstream>

#include "program.hpp"
#include "text.hpp"

using namespace deixis::tests;
using nlohmann::json;

namespace {

/// `deixis stats TEST FILE OPTIONS --json` of a file with this content.
Finished stats(const std::string& test, const std::string& content, const std::string& options) {
    const Scratch scratch;
    spill(scratch / "data.csv", content);
    return program("stats " + test + " " + (scratch / "data.csv") + " " + options);
}

json numbers(const std::string& test, const std::string& content, const std::string& options) {
    const auto finished = stats(test, content, options + " --json");
    INFO(finished.err);
    REQUIRE(finished.status == 0);
    return json::parse(finished.out);
}

const std::string pairs = "who,a,b\nP1,0.2,0\nP2,0,1/5\nP3,2/5,0\nP4,0.4,0\nP5,1,1\nP6,3/5,0e3\nP7,,3\n";

}  // namespace

TEST_SUITE("app/stats") {
    TEST_CASE("signed-rank prints every key that scripts rely on, and reads fractions exactly") {
        const json out = numbers("signed-rank", pairs, "--columns a,b");
        CHECK(out["n_pairs"] == 6);
        CHECK(out["n_missing"] == 1);
        CHECK(out["n_zero"] == 1);
        CHECK(out["n_positive"] == 4);
        CHECK(out["n_negative"] == 1);
        CHECK(out["ties"] == 2);
        CHECK(out["w_plus"] == 13.5);
        CHECK(out["w_minus"] == 1.5);
        CHECK(out["method"] == "exact with ties");
        CHECK(out["p_two_sided"] == 0.1875);  // 3 of 32 sign patterns, twice
        CHECK(out["p_greater"] == 0.09375);
        CHECK(out["p_less"] == 0.96875);
        CHECK(out["pratt"]["w_plus"] == 17.5);
        CHECK(out["pratt"]["p_two_sided"] == 0.1875);
        CHECK(out["z"] == out["normal"]["z"]);
        // Five differences without zeros, two of them alike twice: the variance is 5 x 6 x 11 / 24 less 2 x
        // (2^3 - 2) / 48; half a rank is taken off for continuity.
        CHECK(out["normal"]["p_two_sided"].get<double>() ==
              doctest::Approx(std::erfc((13.5 - 7.5 - 0.5) / std::sqrt(13.75 - 0.25) / std::sqrt(2.0))));
        CHECK(out["rank_biserial"] == 0.8);
        CHECK(out["paired_superiority"] == 0.75);
        CHECK(out["hodges_lehmann"]["estimate"] == 0.2);
        CHECK(out["hodges_lehmann"]["level"] == 0.96875);
        CHECK(!out.contains("note"));
    }

    TEST_CASE("Undefined values are null, and a note says why") {
        const json none = numbers("signed-rank", "a,b\n", "--columns a,b");
        CHECK(none["n_pairs"] == 0);
        CHECK(none["p_two_sided"] == 1.0);
        CHECK(none["z"].is_null());
        CHECK(none["hodges_lehmann"]["estimate"].is_null());
        CHECK(none["note"].get<std::string>().find("no complete pair") != std::string::npos);
        const json zeros = numbers("signed-rank", "a,b\n1,1\n2,2\n", "--columns a,b");
        CHECK(zeros["p_two_sided"] == 1.0);
        CHECK(zeros["rank_biserial"].is_null());
        CHECK(zeros["note"].get<std::string>().find("zero") != std::string::npos);
        CHECK(numbers("rank-sum", "a,b\n1,\n", "--columns a,b")["p_two_sided"].is_null());
        CHECK(numbers("friedman", "a,b\n1,1\n", "--columns a,b")["chi2"].is_null());
        CHECK(numbers("shapiro", "a\n1\n2\n", "--columns a")["w"].is_null());
        CHECK(numbers("spearman", "a,b\n1,2\n1,3\n", "--columns a,b")["rho"].is_null());
        CHECK(numbers("describe", "a\n", "--columns a")["mean"].is_null());
        CHECK(numbers("proportion", "a\n", "--columns a --chance 1/3")["lower"].is_null());
    }

    TEST_CASE("The other tests print their keys") {
        const json rank_sum = numbers("rank-sum", pairs, "--columns a,b");
        for (const char* key :
             {"u", "method", "p_two_sided", "p_greater", "p_less", "a12", "cliffs_delta", "hodges_lehmann"})
            CHECK(!rank_sum[key].is_null());
        const json friedman = numbers("friedman", pairs, "--columns a,b");
        CHECK(friedman["n_missing"] == 1);
        CHECK(friedman["df"] == 1);
        CHECK(friedman["chi2"].get<double>() == doctest::Approx(1.8));  // 4 rows for a, 1 for b, 1 tied
        CHECK(friedman["iman_davenport"]["df2"] == 5);
        for (const char* key : {"p", "kendalls_w"}) CHECK(friedman[key].is_number());
        const json spearman = numbers("spearman", "x,y\n1,2\n2,4\n3,9\n", "--columns x,y");
        CHECK(spearman["rho"] == 1.0);
        CHECK(spearman["method"] == "exact");
        CHECK(spearman["p"].get<double>() == doctest::Approx(1.0 / 3.0));
        const json shapiro = numbers("shapiro", pairs, "--columns a,b");
        CHECK(shapiro["of"] == "differences");
        CHECK(shapiro["n"] == 6);
        const json described = numbers("describe", "x\n1\n2\n3\n10\n", "--columns x");
        for (const char* key :
             {"n", "mean", "sd", "se", "min", "q05", "q25", "median", "q75", "q95", "max", "mad"})
            CHECK(described[key].is_number());
        CHECK(described["q25"] == 1.75);
        CHECK(described["mad"] == 1.4826);
        CHECK(numbers("describe", pairs, "--columns a,b")["by_column"]["b"]["n"] == 7);
        const json shares = numbers("proportion", "c\n1\n1\n0\n1\n1\n\n", "--columns c --chance 1/3");
        CHECK(shares["successes"] == 4);
        CHECK(shares["n"] == 5);
        CHECK(shares["n_missing"] == 1);
        CHECK(shares["p_chance"].get<double>() == doctest::Approx(11.0 / 243.0));
    }

    TEST_CASE("holm keeps the order, and a missing p stays missing also where it is an empty line") {
        const json out = numbers("holm", "p\n0.01\n\n3/100\nNA\n0.005\n", "--columns p");
        CHECK(out["adjusted"] == json::array({0.02, nullptr, 0.03, nullptr, 0.015}));
    }

    TEST_CASE("decimal commas stand for points between semicolons, are told, and are not mixed with points") {
        const Scratch scratch;
        const auto signed_rank = [&](const std::string& rows) {
            spill(scratch / "d.csv", rows);
            return program("stats signed-rank " + (scratch / "d.csv") + " --columns a,b --json");
        };
        const auto commas = signed_rank("a;b\n1,5;2,25\n3;1,5\n2,5;2\n");
        const auto points = signed_rank("a,b\n1.5,2.25\n3,1.5\n2.5,2\n");
        REQUIRE(commas.status == 0);
        REQUIRE(points.status == 0);
        auto told = json::parse(commas.out);
        CHECK(contains(told["note"].get<std::string>(), "decimal points"));
        CHECK(told["hodges_lehmann"] == json::parse(points.out)["hodges_lehmann"]);
        CHECK_FAILS_SAYING(signed_rank("a;b\n1,5;2.25\n3;1,5\n"), "d.csv:2: b: 2.25", "the same way");
        // A thousands separator is no decimal comma.
        CHECK_FAILS_SAYING(signed_rank("a,b\n\"1,234\",2\n3,4\n"), "d.csv:2", "1,234");
    }

    TEST_CASE("bootstrap prints its seed, resamples participants and repeats itself") {
        const std::string rows = "who,a,b\nP1,1,2\nP1,3,\nP2,2,1\nP3,5,2\n";
        const json out = numbers("bootstrap", rows, "--columns a,b --cluster who --seed 7 --resamples 500");
        CHECK(out["participants"] == 3);
        CHECK(out["seed"] == 7);
        CHECK(out["resamples"] == 500);
        CHECK(out["means"][0]["estimate"] == 3.0);  // of 2, 2 and 5
        CHECK(out["differences"][0]["a"] == "a");
        CHECK(out == numbers("bootstrap", rows, "--columns a,b --cluster who --seed 7 --resamples 500"));
    }

    TEST_CASE("Rows of one participant are averaged exactly, over different numbers of answers") {
        // P1: 4/3 against 4/3, P2: 3/2 against 1.
        const std::string rows = "who,a,b\nP1,1,2\nP1,1,\nP1,2,1\nP1,,1\nP2,1,1\nP2,2,1\nP3,,4\n";
        const json out = numbers("signed-rank", rows, "--columns a,b --paired-by who");
        CHECK(out["n_zero"] == 1);
        CHECK(out["n_positive"] == 1);
        CHECK(out["n_missing"] == 1);
        CHECK(out["hodges_lehmann"]["upper"] == 0.5);
    }

    TEST_CASE("The long form gives the same numbers as the wide one") {
        const std::string rows =
            "who,system,score\nP1,a,0.2\nP1,b,0\nP2,b,1/5\nP2,a,0\nP3,a,2/"
            "5\nP3,b,0\nP4,a,0.4\nP4,b,0\nP5,a,1\n"
            "P5,b,1\nP6,a,3/5\nP6,b,0\nP7,b,3\nP7,c,9\n";
        auto wide = numbers("signed-rank", pairs, "--columns a,b");
        CHECK(numbers("signed-rank", rows, "--group system --value score --paired-by who --columns a,b") ==
              wide);
        const json shared_out = numbers("rank-sum", rows, "--group system --value score --columns b,a");
        CHECK(shared_out["n_a"] == 7);
        CHECK(shared_out["n_b"] == 6);
        CHECK_FAILS_SAYING(stats("signed-rank", rows, "--group system --value score --columns a,b"),
                           "compares paired values", "--paired-by");
        CHECK_FAILS_SAYING(stats("signed-rank", rows, "--group system --value score --paired-by who"),
                           "takes 2 columns", "3 are chosen");
        CHECK_FAILS_SAYING(stats("rank-sum", rows, "--group system --columns a,b"), "--value",
                           "belong together");
        CHECK_FAILS_SAYING(stats("rank-sum", rows, "--group system --value score --columns a,z"), "\"z\"",
                           "system");
    }

    TEST_CASE("What cannot be read is named with file, line and column") {
        CHECK_FAILS_SAYING(stats("signed-rank", "a,b\n1,2\n1,two\n", "--columns a,b"), "data.csv:3: b",
                           "\"two\" is not a number", "7/3");
        CHECK_FAILS_SAYING(stats("signed-rank", "a,b\n1,2/0\n", "--columns a,b"), "data.csv:2",
                           "divides by zero");
        CHECK_FAILS_SAYING(stats("signed-rank", "a,b\n1\n", "--columns a,b"), "data.csv:2", "found 1 field",
                           "expected 2");
        CHECK_FAILS_SAYING(stats("signed-rank", "a,b\n1,2\n", "--columns a,c"), "data.csv:1",
                           "column 'c' is missing", "a, b");
        CHECK_FAILS_SAYING(stats("signed-rank", "a,a\n1,2\n", "--columns a,a"), "more than once");
        CHECK_FAILS_SAYING(stats("signed-rank", "a,b\n1,2\n", "--columns a"), "takes 2 columns",
                           "1 is chosen");
        CHECK_FAILS_SAYING(stats("signed-rank", "", "--columns a,b"), "is empty");
        CHECK_FAILS_SAYING(stats("holm", "p\n0.1\n1.5\n", "--columns p"), "data.csv:3", "not a p value");
        CHECK_FAILS_SAYING(stats("proportion", "c\n1\n2\n", "--columns c"), "data.csv:3", "neither 0 nor 1");
        CHECK_FAILS_SAYING(stats("proportion", "c\n1\n", "--columns c --chance 3/2"), "--chance");
        CHECK_FAILS_SAYING(stats("describe", "who,a\n,1\n", "--columns a --paired-by who"),
                           "data.csv:2: who");
        CHECK_FAILS_SAYING(stats("rank-sum", pairs, "--columns a,b --level 1"), "--level");
        CHECK_FAILS_SAYING(program("stats describe /nowhere/x.csv --columns a"), "/nowhere/x.csv");
        CHECK_FAILS_SAYING(stats("rank-sum", "x\n1\n", "--columns x,x,x"), "takes 2 columns");
        CHECK(stats("bootstrap", "x\n1\n", "--columns x --seed -1").status == 2);
        CHECK(stats("signed-rank", pairs, "").status == 1);
        CHECK(program("stats").status == 2);
    }

    TEST_CASE("Columns are named in one line of CSV, before the file or after it") {
        const std::string odd = "who,\"x, y\", -z ,7/3\nP1,1,2,3\nP2,2,4,4\nP3,5,1,9\n";
        const json out = numbers("friedman", odd, "'--columns=\"x, y\", -z,7/3'");
        CHECK(out["columns"] == json::array({"x, y", "-z", "7/3"}));
        CHECK(out["mean_ranks"] == json::array({4.0 / 3.0, 5.5 / 3.0, 8.5 / 3.0}));
        const Scratch scratch;
        spill(scratch / "data.csv", pairs);
        const auto first = program("stats signed-rank --columns a,b " + (scratch / "data.csv") + " --json");
        REQUIRE(first.status == 0);
        CHECK(json::parse(first.out) == numbers("signed-rank", pairs, "--columns a,b"));
        CHECK_FAILS_SAYING(stats("friedman", odd, "--columns 'x, y'"), "column 'x' is missing");
        CHECK_FAILS_SAYING(stats("friedman", odd, "--columns '\"x'"), "--columns", "no closing quote");
        CHECK_FAILS_SAYING(stats("friedman", odd, "--columns 'who\n7/3'"), "--columns", "2 lines");
    }

    TEST_CASE("Empty cells, NA, NaN and null are missing; a sign or a word alone is not") {
        CHECK(numbers("describe", "x,y\n,1\nNA,1\nnan,1\n Null ,1\n7,1\n", "--columns x")["n_missing"] == 4);
        for (const char* cell : {"-", "none", "n/a", "inf", ".", "1;5"})
            CHECK_FAILS_SAYING(stats("describe", "x\n1\n" + std::string(cell) + "\n", "--columns x"),
                               "data.csv:3: x", cell, "is not a number");
    }

    TEST_CASE("A number beyond a double is null, and the note says so") {
        const json large = numbers("describe", "x\n1e400\n1\n2\n", "--columns x");
        CHECK(large["max"].is_null());
        CHECK(large["median"] == 2.0);
        CHECK(large["note"].get<std::string>().find("1.8e308") != std::string::npos);
        const json sums = numbers("bootstrap", "x\n1e308\n1.5e308\n1e308\n", "--columns x --resamples 50");
        CHECK(sums["means"][0]["bca"]["lower"].is_null());
        CHECK(sums["note"].get<std::string>().find("too large") != std::string::npos);
        // Ranks and differences are exact all the same.
        CHECK(numbers("signed-rank", "a,b\n1e400,0\n2e400,1\n3,4\n", "--columns a,b")["w_plus"] == 5.0);
    }

    TEST_CASE("Standard input is read, and people get a line for each number") {
        const auto finished = program("stats describe - --columns x", "printf 'x\\n1\\n2\\n' |");
        REQUIRE(finished.status == 0);
        CHECK(finished.out.find("median               1.5\n") != std::string::npos);
    }

    TEST_CASE("kde gives the normal kernels' sum, at the rows or elsewhere") {
        const auto density = [](double z) {
            return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::acos(-1.0));
        };
        const json out = numbers("kde", "x\n0\n\n1\n", "--columns x --bandwidth 1");
        CHECK(out["test"] == "kde");
        CHECK(out["columns"] == json({"x"}));
        CHECK(out["n"] == 2);
        CHECK(out["n_missing"] == 1);
        CHECK(out["densities"][0].get<double>() == doctest::Approx(0.5 * (density(0.0) + density(1.0))));
        CHECK(out["densities"][1].is_null());
        const Scratch scratch;
        spill(scratch / "at.csv", "y,x\n7,0.5\n");
        const json at = numbers("kde", "x\n0\n1\n", "--columns x --bandwidth 1 --at " + (scratch / "at.csv"));
        REQUIRE(at["densities"].size() == 1);
        CHECK(at["densities"][0].get<double>() == doctest::Approx(density(0.5)));
        const json scott = numbers("kde", "x,y\n0,0\n1,3\n2,1\n", "--columns x,y --bandwidth scott");
        CHECK(scott["rule"] == "scott");
        CHECK(scott["bandwidths"][0].get<double>() == doctest::Approx(std::pow(3.0, -1.0 / 6.0)));
        const auto bad = stats("kde", "x,y\n0,0\n1,3\n", "--columns x,y --bandwidth 1");
        CHECK(bad.status != 0);
        CHECK(bad.err.find("found 1 numbers, but 2 columns") != std::string::npos);
        CHECK(stats("kde", "x\n1\n1\n", "--columns x").status != 0);
    }

    TEST_CASE("meanshift finds the groups that lie apart") {
        const json out =
            numbers("meanshift", "x,y\n5,1\n0,0\n0.1,0\n0.2,0\n5.1,1\n", "--columns x,y --bandwidth 1");
        CHECK(out["clusters"] == 2);
        CHECK(out["counts"] == json::array({3, 2}));
        CHECK(out["labels"] == json::array({1, 0, 0, 0, 1}));
        CHECK(out["centres"][0][0].get<double>() == doctest::Approx(0.1));
        CHECK(stats("meanshift", "x\n1\n1\n", "--columns x").err.find("cannot be estimated") !=
              std::string::npos);
    }
}
