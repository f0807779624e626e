#include "results/statistics.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/random.hpp"

using namespace deixis::results;

namespace {

nlohmann::json reference(const char* name) {
    std::ifstream in(std::string(DEIXIS_SOURCE_DIR "/tests/results/reference/") + name);
    return nlohmann::json::parse(in);
}

std::vector<double> numbers(const nlohmann::json& list) {
    return list.get<std::vector<double>>();
}

void checkClose(double found, double expected, double relative) {
    CHECK(std::abs(found - expected) <= relative * std::abs(expected));
}

}  // namespace

TEST_SUITE("results/statistics") {
    TEST_CASE("Signed-rank tests agree with R, exact without ties and approximate with corrections") {
        const auto file = reference("statistics_r.json");
        REQUIRE(file["signed_rank"].size() == 9);
        for (const auto& expected : file["signed_rank"]) {
            CAPTURE(expected["name"].get<std::string>());
            const auto test = signedRankTest(numbers(expected["differences"]));
            CHECK(test.method == expected["method"].get<std::string>());
            CHECK(test.w_plus == expected["w_plus"].get<double>());
            checkClose(test.p, expected["p"].get<double>(), 1e-9);
        }
    }

    TEST_CASE("Exact tests agree with the enumeration of all sign patterns, and with SciPy") {
        const auto file = reference("signed_rank_enumerated.json");
        REQUIRE(file["signed_rank"].size() == 11);
        for (const auto& expected : file["signed_rank"]) {
            CAPTURE(expected["name"].get<std::string>());
            const auto test = signedRankTest(numbers(expected["differences"]));
            CHECK(test.method == expected["method"].get<std::string>());
            CHECK(test.n_zero == expected["n_zero"].get<int>());
            CHECK(test.w_plus == expected["w_plus"].get<double>());
            CHECK(test.w_minus == expected["w_minus"].get<double>());
            checkClose(test.p, expected["p"].get<double>(), 1e-9);
        }
    }

    TEST_CASE("Zeros are dropped, and nothing but zeros is no evidence") {
        const std::vector<double> with{0.0, 1.0, -2.0, 3.0, 0.0, 4.0};
        const std::vector<double> without{1.0, -2.0, 3.0, 4.0};
        const auto test = signedRankTest(with);
        CHECK(test.n == 6);
        CHECK(test.n_zero == 2);
        CHECK(test.p == signedRankTest(without).p);
        const auto none = signedRankTest(std::vector<double>{0.0, 0.0, 0.0});
        CHECK(none.method == "no differences");
        CHECK(none.n_zero == 3);
        CHECK(none.p == 1.0);
        CHECK(signedRankTest({}).n == 0);
    }

    TEST_CASE("Differences that are equal on paper are tied and zero although their last bits differ") {
        const double a = (4.0 + 5.0 + 3.0) / 3.0 - 3.8;  // 0.2
        const double b = 0.1 + 0.1;
        const double c = 0.3 - 0.1;  // 0.19999999999999998
        REQUIRE(c != b);
        const auto test = signedRankTest(std::vector<double>{a, b, -c, 0.1 + 0.2 - 0.3});
        CHECK(test.n_zero == 1);
        CHECK(test.w_plus == 4.0);
        CHECK(test.w_minus == 2.0);
    }

    TEST_CASE("Rank sums add up, and turning all signs swaps them and keeps p") {
        for (std::uint64_t seed = 0; seed < 50; ++seed) {
            CAPTURE(seed);
            deixis::Random random(seed);
            std::vector<double> differences(1 + random.below(130));
            for (double& d : differences) d = static_cast<double>(random.below(11)) - 4.0;
            auto turned = differences;
            for (double& d : turned) d = -d;
            const auto test = signedRankTest(differences);
            const auto mirror = signedRankTest(turned);
            const double ranked = test.n - test.n_zero;
            CHECK(test.w_plus + test.w_minus == ranked * (ranked + 1.0) / 2.0);
            CHECK(test.w_plus == mirror.w_minus);
            CHECK(test.p == mirror.p);
            CHECK(test.p > 0.0);
            CHECK(test.p <= 1.0);
        }
    }

    TEST_CASE("The approximation takes over smoothly from the exact test") {
        std::vector<double> differences;
        for (int i = 1; i <= 100; ++i) differences.push_back(i % 5 < 2 ? -i : i);
        const auto exact = signedRankTest(differences);
        differences.push_back(-50.5);
        const auto approximate = signedRankTest(differences);
        CHECK(exact.method == "exact");
        CHECK(approximate.method == "normal approximation");
        CHECK(std::abs(std::log(exact.p / approximate.p)) < 0.5);
    }

    TEST_CASE("Holm's adjustment agrees with R and keeps the order") {
        const auto file = reference("statistics_r.json");
        REQUIRE(file["holm"].size() == 3);
        for (const auto& expected : file["holm"]) {
            const auto adjusted = holm(numbers(expected["p"]));
            const auto by_r = numbers(expected["holm"]);
            REQUIRE(adjusted.size() == by_r.size());
            for (std::size_t i = 0; i < by_r.size(); ++i) checkClose(adjusted[i], by_r[i], 1e-12);
        }
        CHECK(holm({}).empty());
    }

    TEST_CASE("Mean, standard deviation and quantiles agree with R") {
        const auto file = reference("statistics_r.json");
        REQUIRE(file["descriptions"].size() == 3);
        for (const auto& expected : file["descriptions"]) {
            const auto x = numbers(expected["x"]);
            checkClose(mean(x), expected["mean"].get<double>(), 1e-12);
            checkClose(sampleSd(x), expected["sd"].get<double>(), 1e-12);
            const auto q = numbers(expected["q"]);
            const auto by_r = numbers(expected["quantiles"]);
            for (std::size_t i = 0; i < q.size(); ++i) checkClose(quantile(x, q[i]), by_r[i], 1e-12);
        }
        CHECK(sampleSd(std::vector<double>{3.0}) == 0.0);
    }
}
