#include "results/statistics/signed_rank.hpp"

#include "core/random.hpp"
#include "oracles.hpp"

using namespace deixis::results;
using namespace deixis::tests;

namespace {

/// All sign patterns of up to 20 differences; ties and zeros as they come. Nothing is shared with the
/// product.
struct Enumerated {
    double p_less = 0.0;
    double p_greater = 0.0;
    double all = 0.0;
};

Enumerated enumerate(const std::vector<int>& differences) {
    std::vector<int> rest;
    for (const int d : differences)
        if (d != 0) rest.push_back(d);
    std::vector<int> doubled;
    for (const int d : rest) {
        int rank = 1;
        for (const int other : rest)
            rank += std::abs(other) < std::abs(d) ? 2 : std::abs(other) == std::abs(d) ? 1 : 0;
        doubled.push_back(rank);
    }
    int found = 0;
    for (std::size_t i = 0; i < rest.size(); ++i) found += rest[i] > 0 ? doubled[i] : 0;
    Enumerated out;
    const unsigned patterns = 1U << rest.size();
    for (unsigned pattern = 0; pattern < patterns; ++pattern) {
        int sum = 0;
        for (std::size_t i = 0; i < rest.size(); ++i) sum += (pattern >> i & 1U) != 0U ? doubled[i] : 0;
        out.p_less += sum <= found ? 1.0 / patterns : 0.0;
        out.p_greater += sum >= found ? 1.0 / patterns : 0.0;
        out.all += 1.0 / patterns;
    }
    return out;
}

}  // namespace

TEST_SUITE("results/signed_rank") {
    TEST_CASE("Every number agrees with the enumeration in exact fractions") {
        const auto cases = oracles("signed_rank");
        REQUIRE(cases.size() >= 30);
        for (const auto& expected : cases) {
            CAPTURE(expected["name"].get<std::string>());
            const auto found = signedRankTest(differences(expected["a"], expected["b"]), expected["level"]);
            CHECK(found.n_pairs == expected["n_pairs"].get<int>());
            CHECK(found.n_zero == expected["n_zero"].get<int>());
            CHECK(found.n_positive == expected["n_positive"].get<int>());
            CHECK(found.n_negative == expected["n_negative"].get<int>());
            CHECK(found.ties == expected["ties"].get<int>());
            CHECK(found.w_plus == expected["w_plus"].get<double>());
            CHECK(found.w_minus == expected["w_minus"].get<double>());
            CHECK(close(found.p_two_sided, expected["p_two_sided"], 1e-13));
            CHECK(close(found.p_greater, expected["p_greater"], 1e-13));
            CHECK(close(found.p_less, expected["p_less"], 1e-13));
            if (found.n_positive + found.n_negative > 0) {
                CHECK(found.pratt_w_plus == expected["pratt_w_plus"].get<double>());
                CHECK(close(found.pratt_p_two_sided, expected["pratt_p_two_sided"], 1e-13));
            }
            CHECK(close(found.rank_biserial, expected["rank_biserial"], 1e-14));
            CHECK(close(found.paired_superiority, expected["paired_superiority"], 1e-14));
            const auto& walsh = expected["hodges_lehmann"];
            CHECK(close(found.hodges_lehmann.estimate, walsh["estimate"], 0.0));
            CHECK(close(found.hodges_lehmann.lower, walsh["lower"], 0.0));
            CHECK(close(found.hodges_lehmann.upper, walsh["upper"], 0.0));
            CHECK(close(found.hodges_lehmann.level, walsh["level"], 1e-12));
            if (found.hodges_lehmann.lower) {
                CHECK(found.hodges_lehmann.lower_included == walsh["lower_included"].get<bool>());
                CHECK(found.hodges_lehmann.upper_included == walsh["upper_included"].get<bool>());
            }
        }
    }

    TEST_CASE(
        "R agrees where its conventions are ours: exactRankTests, coin's Pratt, the normal one, intervals") {
        int compared = 0;
        int intervals = 0;
        for (const auto& expected : oracles("signed_rank")) {
            const auto& r = expected["r"];
            if (!r.contains("exact_greater")) continue;
            CAPTURE(expected["name"].get<std::string>());
            ++compared;
            const auto found = signedRankTest(differences(expected["a"], expected["b"]), expected["level"]);
            CHECK(close(found.p_greater, r["exact_greater"], 1e-9));
            CHECK(close(found.p_less, r["exact_less"], 1e-9));
            CHECK(close(found.p_two_sided, r["exact_two.sided"], 1e-9));
            CHECK(close(found.normal_p_two_sided, r["normal_p"], 1e-9));
            if (r.contains("pratt")) CHECK(close(found.pratt_p_two_sided, r["pratt"], 1e-8));
            if (r.contains("rank_biserial")) CHECK(close(found.rank_biserial, r["rank_biserial"], 1e-9));
            if (r.contains("interval")) {
                ++intervals;
                CHECK(close(found.hodges_lehmann.lower, r["interval"][0], 1e-9));
                CHECK(close(found.hodges_lehmann.upper, r["interval"][1], 1e-9));
            }
        }
        CHECK(compared >= 30);
        CHECK(intervals >= 30);
    }

    TEST_CASE("SciPy's wilcoxon agrees: exact without ties, and the normal approximation") {
        checkAgainstScipy("signed_rank", [](const auto& expected) {
            return signedRankTest(differences(expected["a"], expected["b"]));
        });
    }

    TEST_CASE("A thousand and more tied differences are tested exactly") {
        for (const auto& expected : oracles("signed_rank_large")) {
            CAPTURE(expected["name"].get<std::string>());
            const auto found = signedRankTest(rationals(expected["a"]));
            CHECK(found.method == "exact with ties");
            CHECK(found.w_plus == expected["w_plus"].get<double>());
            CHECK(close(found.p_two_sided, expected["p_two_sided"], 1e-10));
            CHECK(close(found.p_greater, expected["p_greater"], 1e-10));
            CHECK(close(found.p_less, expected["p_less"], 1e-10));
            if (expected["r"].contains("exact_two.sided"))
                CHECK(close(found.p_two_sided, expected["r"]["exact_two.sided"], 1e-9));
        }
    }

    TEST_CASE(
        "Small tied samples give the very doubles of the enumeration, and turning the signs mirrors them") {
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            CAPTURE(seed);
            deixis::Random random(seed, "signed rank");
            std::vector<int> d(random.below(13));
            for (int& value : d) value = static_cast<int>(random.below(9)) - 4;
            auto turned = d;
            for (int& value : turned) value = -value;
            const auto found = signedRankTest(wholes(d));
            const auto mirror = signedRankTest(wholes(turned));
            const auto expected = enumerate(d);
            CHECK(expected.all == 1.0);
            CHECK(found.p_less == expected.p_less);
            CHECK(found.p_greater == expected.p_greater);
            CHECK(mirror.p_less == expected.p_greater);
            CHECK(mirror.p_two_sided == found.p_two_sided);
            CHECK(mirror.w_plus == found.w_minus);
        }
    }

    TEST_CASE("Tails far out are counted, not rounded away") {
        std::vector<int> all_positive;
        for (int i = 1; i <= 1000; ++i) all_positive.push_back(i);
        const auto test = signedRankTest(wholes(all_positive));
        CHECK(test.p_greater == std::ldexp(1.0, -1000));
        CHECK(test.p_less == 1.0);
        CHECK(test.p_two_sided == test.smallest_p);
        // Sums of up to 3 below the largest: {}, {1}, {2}, {3}, {1, 2}.
        all_positive[2] = -3;
        CHECK(signedRankTest(wholes(all_positive)).p_greater == std::ldexp(5.0, -1000));
    }

    TEST_CASE("The approximation takes over from the exact test without a step") {
        deixis::Random random(3, "many");
        std::vector<Rational> d;
        for (int i = 0; i < 2000; ++i) d.emplace_back(static_cast<std::int64_t>(random.below(41)) - 19, 7);
        std::erase(d, Rational());
        while (d.size() < 2000) d.emplace_back(1, 7);
        const auto exact = signedRankTest(d);
        d.emplace_back(1, 7);
        const auto approximate = signedRankTest(d);
        CHECK(exact.method == "exact with ties");
        CHECK(approximate.method == "normal approximation");
        CHECK(close(exact.p_two_sided, exact.normal_p_two_sided, 0.05));
        CHECK(close(approximate.p_two_sided, exact.p_two_sided, 0.05));
        CHECK(close(approximate.p_two_sided, approximate.normal_p_two_sided, 1e-12));
    }

    TEST_CASE(
        "Zeros are dropped in the headline and ranked by Pratt's rule; nothing but zeros is no evidence") {
        const auto test = signedRankTest(wholes({0, 1, -2, 3, 0, 4}));
        CHECK(test.n_pairs == 6);
        CHECK(test.p_two_sided == signedRankTest(wholes({1, -2, 3, 4})).p_two_sided);
        CHECK(test.pratt_w_plus == 3.0 + 5.0 + 6.0);
        CHECK(test.pratt_p_two_sided == 0.375);  // of ranks 3 to 6: {}, {3} and {4} do not exceed W- = 4
        const auto none = signedRankTest(wholes({0, 0, 0}));
        CHECK(none.method == "no differences");
        CHECK(none.p_two_sided == 1.0);
        CHECK(!none.z);
        CHECK(none.paired_superiority == 0.5);
        CHECK(none.hodges_lehmann.estimate == 0.0);
    }

    TEST_CASE("Numbers with many different denominators are handled in bounded time") {
        std::vector<Rational> d;
        for (int i = 0; i < 300; ++i) d.emplace_back(i % 3 == 0 ? -1 : 1, 100003 + 2 * i);
        const auto test = signedRankTest(d);
        CHECK(test.ties == 0);
        CHECK(test.hodges_lehmann.estimate.value() < 1e-5);
    }
}
