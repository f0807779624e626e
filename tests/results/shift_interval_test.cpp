// Intervals that invert the tests, and decimals that are rounded fractions.
#include <doctest/doctest.h>

#include <cmath>

#include "core/random.hpp"
#include "oracles.hpp"
#include "results/statistics/rank_sum.hpp"
#include "results/statistics/rounded_fraction.hpp"
#include "results/statistics/signed_rank.hpp"

using namespace deixis::results;
using namespace deixis::tests;

namespace {

bool holdsZero(const HodgesLehmann& shift) {
    if (!shift.lower) return false;
    return (*shift.lower < 0.0 && *shift.upper > 0.0) || (*shift.lower == 0.0 && shift.lower_included) ||
           (*shift.upper == 0.0 && shift.upper_included);
}

Rational parsed(const char* text) {
    return Rational::parse(text).value();
}

}  // namespace

TEST_SUITE("results/shift_interval") {
    TEST_CASE("Ten zeros and eight positive differences: p is 2/256, and the interval leaves 0 out") {
        const auto test =
            signedRankTest(wholes({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 2, 2, 2, 3, 3, 4}), 0.95);
        CHECK(test.p_two_sided == 2.0 / 256.0);
        CHECK(test.hodges_lehmann.lower == 0.0);
        CHECK_FALSE(test.hodges_lehmann.lower_included);
        CHECK(test.hodges_lehmann.upper == 1.5);
        CHECK(test.hodges_lehmann.upper_included);
    }

    TEST_CASE("The interval holds 0 exactly where the test does not reject it, with ties and zeros") {
        int rejected = 0;
        int with_zeros = 0;
        for (std::uint64_t seed = 0; seed < 600; ++seed) {
            CAPTURE(seed);
            deixis::Random random(seed, "intervals");
            std::vector<Rational> a, b;
            const auto n = 2 + random.below(14);
            for (std::uint64_t i = 0; i < n; ++i) {
                a.emplace_back(static_cast<std::int64_t>(random.below(7)) - 2, 2);
                if (i % 2 == 0) b.emplace_back(static_cast<std::int64_t>(random.below(7)) - 4, 2);
            }
            const double level = seed % 3 == 0 ? 0.99 : seed % 3 == 1 ? 0.95 : 0.8;
            const auto paired = signedRankTest(a, level);
            const auto groups = rankSumTest(a, b, level);
            const auto agrees = [&](const HodgesLehmann& shift, double p) {
                // Of few values the widest interval has a level of its own.
                const double at = shift.level.value_or(level) < level - 1e-12 ? *shift.level : level;
                return holdsZero(shift) == (p > 1.0 - at + 1e-12) || (at < level && !holdsZero(shift));
            };
            CHECK(agrees(paired.hodges_lehmann, paired.p_two_sided));
            CHECK(agrees(groups.hodges_lehmann, *groups.p_two_sided));
            rejected += holdsZero(paired.hodges_lehmann) ? 0 : 1;
            with_zeros += paired.n_zero > 0 ? 1 : 0;
        }
        CHECK(rejected > 50);
        CHECK(with_zeros > 300);
    }

    TEST_CASE("The ends of larger samples' intervals are where the exact p passes 1 - level") {
        for (std::uint64_t seed = 0; seed < 16; ++seed) {
            CAPTURE(seed);
            deixis::Random random(seed, "larger samples");
            const double level = seed % 2 == 0 ? 0.95 : 0.99;
            const std::uint64_t steps = seed % 3 == 0 ? 40 : 4000;  // many ties, few ties
            const auto sample = [&](std::size_t n, int min) {
                std::vector<Rational> out;
                for (std::size_t i = 0; i < n; ++i) {
                    const auto value = static_cast<std::int64_t>(random.below(steps) * random.below(3));
                    out.emplace_back(min + value, 20);
                }
                return out;
            };
            const Rational hair(1, 1000);
            const auto less = [](std::vector<Rational> values, const Rational& shift) {
                for (Rational& value : values) value = value - shift;
                return values;
            };
            const auto crosses = [&](double inside, double outside, double share) {
                CHECK(inside > (1.0 - level) * (1.0 - share));
                CHECK(outside <= (1.0 - level) * (1.0 + share));
            };

            const auto d = sample(201 + 3 * seed, -30);
            const auto paired = signedRankTest(d, level).hodges_lehmann;
            for (const double sign : {1.0, -1.0}) {
                const double end = sign > 0 ? *paired.lower : *paired.upper;
                const Rational place(static_cast<std::int64_t>(std::llround(end * 40.0)), 40);
                const Rational away = sign > 0 ? hair : Rational() - hair;
                crosses(signedRankTest(less(d, place + away), 0.0).p_two_sided,
                        signedRankTest(less(d, place - away), 0.0).p_two_sided, 0.002);
            }

            const auto a = sample(20 + seed, 0);
            const auto b = sample(60 - seed, -20);
            const auto groups = rankSumTest(a, b, level).hodges_lehmann;
            for (const double sign : {1.0, -1.0}) {
                const double end = sign > 0 ? *groups.lower : *groups.upper;
                const Rational place(static_cast<std::int64_t>(std::llround(end * 20.0)), 20);
                const Rational away = sign > 0 ? hair : Rational() - hair;
                crosses(*rankSumTest(less(a, place + away), b, 0.0).p_two_sided,
                        *rankSumTest(less(a, place - away), b, 0.0).p_two_sided, 0.02);
            }
        }
    }

    TEST_CASE("Where the test rejects every shift there is an estimate and no interval") {
        std::vector<Rational> d(400);
        for (int i = 0; i < 8; ++i) d.emplace_back(1 + i);
        const auto test = signedRankTest(d, 0.95);
        CHECK(test.p_two_sided == 2.0 / 256.0);
        CHECK(test.hodges_lehmann.estimate == 0.0);
        CHECK_FALSE(test.hodges_lehmann.lower.has_value());
    }

    TEST_CASE("Decimals that other programs wrote of fractions are those fractions again") {
        CHECK(exactScore(7.333333333333334) == Rational(22, 3));
        CHECK(exactScore(22.0 / 3.0) == Rational(22, 3));
        CHECK(exactScore(-1.0 / 7.0) == Rational(-1, 7));
        CHECK(exactScore(0.1 + 0.2) == Rational(3, 10));
        CHECK(exactScore(6.999999999999999) == Rational(7));
        CHECK(roundedFraction(parsed("0.333333333"), 9) == Rational(1, 3));
        // For what they are.
        CHECK(exactScore(0.1) == Rational(1, 10));
        CHECK(exactScore(3.3333) == Rational(33333, 10000));
        CHECK_FALSE(roundedFraction(0.015625).has_value());
        CHECK_FALSE(roundedFraction(2.0).has_value());
        // All fractions with denominators up to 200, as R and Python write them.
        for (int q = 2; q <= 200; ++q)
            for (const int p : {1, q / 2 + 1, 5 * q - 1}) {
                const double value = static_cast<double>(p) / q;
                CHECK(exactScore(value) == Rational(p, q));
            }
        int taken = 0;
        deixis::Random random(7, "decimals");
        for (int i = 0; i < 20000; ++i) taken += roundedFraction(random.uniform(0.0, 100.0)) ? 1 : 0;
        CHECK(taken == 0);
    }
}
