#include "oracles.hpp"
#include "results/statistics/friedman.hpp"
#include "results/statistics/rank_sum.hpp"
#include "results/statistics/shapiro_wilk.hpp"
#include "results/statistics/spearman.hpp"

using namespace deixis::results;
using namespace deixis::tests;

TEST_SUITE("results/rank_sum") {
    TEST_CASE("Every number agrees with the enumeration in exact fractions") {
        const auto cases = oracles("rank_sum");
        REQUIRE(cases.size() >= 30);
        for (const auto& expected : cases) {
            CAPTURE(expected["name"].get<std::string>());
            const auto found =
                rankSumTest(rationals(expected["a"]), rationals(expected["b"]), expected["level"]);
            CHECK(found.n_a == expected["n_a"].get<int>());
            CHECK(found.n_b == expected["n_b"].get<int>());
            if (!expected.contains("u")) {
                CHECK(!found.p_two_sided);
                CHECK(found.method == "undefined");
                continue;
            }
            CHECK(found.u == expected["u"].get<double>());
            CHECK(close(found.a12, expected["a12"], 1e-14));
            CHECK(close(found.cliffs_delta, expected["cliffs_delta"], 1e-14));
            if (expected.contains("p_less")) {
                CHECK(close(found.p_less, expected["p_less"], 1e-13));
                CHECK(close(found.p_greater, expected["p_greater"], 1e-13));
                CHECK(close(found.p_two_sided, expected["p_two_sided"], 1e-13));
            }
            const auto& shift = expected["hodges_lehmann"];
            CHECK(close(found.hodges_lehmann.estimate, shift["estimate"], 0.0));
            CHECK(close(found.hodges_lehmann.lower, shift["lower"], 0.0));
            CHECK(close(found.hodges_lehmann.upper, shift["upper"], 0.0));
            CHECK(close(found.hodges_lehmann.level, shift["level"], 1e-12));
            if (found.hodges_lehmann.lower) {
                CHECK(found.hodges_lehmann.lower_included == shift["lower_included"].get<bool>());
                CHECK(found.hodges_lehmann.upper_included == shift["upper_included"].get<bool>());
            }
        }
    }

    TEST_CASE("R agrees where its conventions are ours: exactRankTests, coin, the normal one, intervals") {
        int compared = 0;
        int intervals = 0;
        for (const auto& expected : oracles("rank_sum")) {
            const auto& r = expected["r"];
            if (!r.contains("greater")) continue;
            CAPTURE(expected["name"].get<std::string>());
            ++compared;
            const auto found =
                rankSumTest(rationals(expected["a"]), rationals(expected["b"]), expected["level"]);
            CHECK(close(found.p_greater, r["greater"], 1e-9));
            CHECK(close(found.p_less, r["less"], 1e-9));
            CHECK(close(found.p_less, r["coin_less"], 1e-8));
            CHECK(close(found.normal_p_two_sided, r["normal_p"], 1e-9));
            if (r.contains("cliffs_delta")) CHECK(close(found.cliffs_delta, r["cliffs_delta"], 1e-9));
            if (!r.contains("interval")) continue;
            ++intervals;
            CHECK(close(found.p_two_sided, r["two_sided"], 1e-9));
            CHECK(close(found.hodges_lehmann.lower, r["interval"][0], 1e-9));
            CHECK(close(found.hodges_lehmann.upper, r["interval"][1], 1e-9));
            CHECK(close(found.hodges_lehmann.estimate, r["estimate"], 1e-9));
        }
        CHECK(compared >= 30);
        CHECK(intervals >= 30);
    }

    TEST_CASE("SciPy's mannwhitneyu agrees: exact without ties, and the normal approximation") {
        checkAgainstScipy("rank_sum", [](const auto& expected) {
            return rankSumTest(rationals(expected["a"]), rationals(expected["b"]));
        });
    }

    TEST_CASE("Exact up to 400 values, with ties; then the approximation, without a step") {
        std::vector<Rational> a;
        std::vector<Rational> b;
        for (int i = 0; i < 200; ++i) {
            a.emplace_back(i % 17, 3);
            b.emplace_back((i * 7) % 16, 3);
        }
        const auto exact = rankSumTest(a, b);
        CHECK(exact.method == "exact with ties");
        CHECK(close(exact.p_two_sided.value(), exact.normal_p_two_sided.value(), 0.005));
        b.emplace_back(2);
        const auto approximate = rankSumTest(a, b);
        CHECK(approximate.method == "normal approximation");
        CHECK(close(approximate.p_two_sided, approximate.normal_p_two_sided.value(), 1e-12));
    }

    TEST_CASE("Exchanging the samples mirrors the test") {
        for (const auto& expected : oracles("rank_sum")) {
            if (!expected.contains("u")) continue;
            const auto a = rationals(expected["a"]);
            const auto b = rationals(expected["b"]);
            const auto found = rankSumTest(a, b);
            const auto mirror = rankSumTest(b, a);
            CHECK(close(mirror.p_less.value(), found.p_greater.value(), 1e-13));
            CHECK(mirror.cliffs_delta.value() == -found.cliffs_delta.value());
            CHECK(mirror.hodges_lehmann.estimate.value() == -found.hodges_lehmann.estimate.value());
            CHECK(mirror.hodges_lehmann.lower.value() == -found.hodges_lehmann.upper.value());
        }
    }
}

TEST_SUITE("results/friedman") {
    TEST_CASE("R's friedman.test, coin, effectsize and SciPy agree, with ties and for two columns") {
        const auto cases = oracles("friedman");
        REQUIRE(cases.size() >= 30);
        for (const auto& expected : cases) {
            CAPTURE(expected["name"].get<std::string>());
            std::vector<std::vector<Rational>> rows;
            for (const auto& row : expected["rows"]) rows.push_back(rationals(row));
            const auto found = friedmanTest(rows);
            const auto& r = expected["r"];
            if (!r.contains("chi2")) continue;  // R takes no single row
            if (!r["chi2"].is_number()) {       // all tied
                CHECK(!found.chi2);
                CHECK(!found.p);
                continue;
            }
            CHECK(std::abs(found.chi2.value() - r["chi2"].get<double>()) < 1e-10 * (1.0 + *found.chi2));
            CHECK(std::abs(*found.chi2 - r["coin_chi2"].get<double>()) < 1e-10 * (1.0 + *found.chi2));
            CHECK(std::abs(found.kendalls_w.value() - r["effectsize_w"].get<double>()) < 1e-12);
            if (expected.contains("scipy")) {
                const auto& scipy = expected["scipy"];
                CHECK(std::abs(*found.chi2 - scipy["chi2"].get<double>()) < 1e-10 * (1.0 + *found.chi2));
                CHECK(close(found.p, scipy["p"], 1e-9));
            }
            CHECK(found.df == r["df"].get<int>());
            CHECK(close(found.p, r["p"], 1e-9));
            CHECK(std::abs(found.kendalls_w.value() - r["w"].get<double>()) < 1e-12);
            const auto& f = found.iman_davenport;
            CHECK(f.df1 == found.k - 1);
            CHECK(f.df2 == (found.k - 1) * (found.n - 1));
            if (!f.f) {
                CHECK(!r["f"].is_number());
                continue;
            }
            CHECK(std::abs(f.f.value() - r["f"].get<double>()) < 1e-9 * (1.0 + *f.f));
            CHECK(close(f.p, r["f_p"], 1e-8));
        }
    }

    TEST_CASE("Perfect agreement, a single row and no row have known answers") {
        const std::vector<std::vector<Rational>> alike(4, wholes({1, 2, 3}));
        const auto perfect = friedmanTest(alike);
        CHECK(perfect.chi2 == 8.0);
        CHECK(perfect.kendalls_w == 1.0);
        CHECK(!perfect.iman_davenport.f);
        CHECK(perfect.iman_davenport.p == 0.0);
        const auto single = friedmanTest(std::vector<std::vector<Rational>>{wholes({1, 2, 2})});
        CHECK(single.kendalls_w == 1.0);
        CHECK(!single.iman_davenport.p);
        CHECK(!friedmanTest({}).chi2);
    }
}

TEST_SUITE("results/shapiro_wilk") {
    TEST_CASE("R's shapiro.test agrees from 3 to 5000 values, and SciPy's within its single precision") {
        const auto cases = oracles("shapiro");
        REQUIRE(cases.size() >= 30);
        for (const auto& expected : cases) {
            CAPTURE(expected["name"].get<std::string>());
            const auto found = shapiroWilk(rationals(expected["x"]));
            CHECK(close(found.w, expected["r"]["w"], 1e-9));
            CHECK(std::abs(found.p.value() - expected["r"]["p"].get<double>()) < 1e-8);
            CHECK(close(found.p, expected["r"]["p"], 1e-6));
            CHECK(close(found.w, expected["scipy"]["w"], 1e-4));
            CHECK(std::abs(found.p.value() - expected["scipy"]["p"].get<double>()) < 1e-3);
        }
    }

    TEST_CASE("Too few, too many and equal values leave it undefined") {
        CHECK(!shapiroWilk(wholes({1, 2})).w);
        CHECK(!shapiroWilk(wholes({2, 2, 2})).p);
        CHECK(!shapiroWilk(wholes(std::vector<int>(5001, 1))).w);
    }
}

TEST_SUITE("results/spearman") {
    TEST_CASE("Every number agrees with the enumeration of all pairings, SciPy and R") {
        const auto cases = oracles("spearman");
        REQUIRE(cases.size() >= 30);
        for (const auto& expected : cases) {
            CAPTURE(expected["name"].get<std::string>());
            const auto found = spearman(rationals(expected["x"]), rationals(expected["y"]));
            const auto& r = expected["r"];
            if (!expected.contains("rho")) {
                CHECK(found.method == "undefined");
                continue;
            }
            CHECK(found.method == (found.n <= 9 ? "exact" : "t"));
            CHECK(std::abs(found.rho - expected["rho"].get<double>()) < 1e-14);
            if (r.contains("rho")) CHECK(std::abs(found.rho - r["rho"].get<double>()) < 1e-12);
            if (expected.contains("p_less")) {
                CHECK(close(found.p_less, expected["p_less"], 1e-14));
                CHECK(close(found.p_greater, expected["p_greater"], 1e-14));
            }
            if (expected.contains("p")) CHECK(close(found.p, expected["p"], 1e-9));
            if (r.contains("p")) CHECK(close(found.p, r["p"], 1e-9));
        }
    }

    TEST_CASE("Doubles are ranked as they are, and sides of different length rejected") {
        const std::vector<double> x{1.0, 2.0, 3.0, 4.0};
        const std::vector<double> y{0.1, 0.4, 0.2, 0.3};
        CHECK(close(spearman(x, y).rho, 0.4, 1e-14));
        CHECK_THROWS(static_cast<void>(spearman(x, std::vector<double>{1.0})));
        const std::vector<double> many{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
        CHECK(spearman(many, many).rho == 1.0);
        CHECK(spearman(many, many).p == 0.0);
    }
}
