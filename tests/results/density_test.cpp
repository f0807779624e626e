// Densities, clusters and correlations against SciPy, statsmodels and scikit-learn
// (scripts/reference/density.py).
#include "results/statistics/density.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "paths.hpp"
#include "results/statistics/mean_shift.hpp"
#include "results/statistics/spearman.hpp"

using namespace deixis::results;

namespace {

nlohmann::json reference() {
    std::ifstream in(deixis::tests::sourceDir() / "tests/results/reference/density_scipy.json");
    return nlohmann::json::parse(in);
}

void checkDensity(const GaussianDensity& density, const nlohmann::json& expected, const Points& queries) {
    const auto bandwidths = expected["bandwidths"].get<std::vector<double>>();
    REQUIRE(density.bandwidths().size() == bandwidths.size());
    for (std::size_t j = 0; j < bandwidths.size(); ++j)
        CHECK(density.bandwidths()[j] == doctest::Approx(bandwidths[j]).epsilon(1e-12));
    const auto values = expected["density"].get<std::vector<double>>();
    REQUIRE(values.size() == queries.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        CHECK(density(queries[i]) == doctest::Approx(values[i]).epsilon(1e-10));
}

}  // namespace

TEST_SUITE("results/density") {
    TEST_CASE("Densities and bandwidths agree with statsmodels' KDEMultivariate and SciPy's gaussian_kde") {
        const auto file = reference();
        REQUIRE(file["density"].size() >= 30);
        for (const auto& example : file["density"]) {
            const auto points = example["points"].get<Points>();
            const auto queries = example["queries"].get<Points>();
            const auto product = GaussianDensity::fit(points, BandwidthRule::normal_reference);
            REQUIRE(product);
            checkDensity(*product, example["normal_reference"], queries);
            const auto full = GaussianDensity::fit(points, BandwidthRule::scott_covariance);
            REQUIRE(full);
            checkDensity(*full, example["scott_covariance"], queries);
            const auto given =
                GaussianDensity::fit(points, example["given"]["bandwidths"].get<std::vector<double>>());
            REQUIRE(given);
            checkDensity(*given, example["given"], queries);
            // Scott's rule per axis has the bandwidths of the whole covariance, without its slant.
            const auto scott = GaussianDensity::fit(points, BandwidthRule::scott);
            REQUIRE(scott);
            CHECK(scott->bandwidths() == full->bandwidths());
        }
    }

    TEST_CASE("A density of one point is the normal density") {
        const auto density = GaussianDensity::fit({{1.0, 2.0}}, std::vector<double>{0.5, 2.0});
        REQUIRE(density);
        CHECK((*density)({1.0, 2.0}) == doctest::Approx(1.0 / (2.0 * 3.14159265358979 * 0.5 * 2.0)));
        CHECK((*density)({1.5, 2.0}) ==
              doctest::Approx(std::exp(-0.5) / (2.0 * 3.14159265358979 * 0.5 * 2.0)));
    }

    TEST_CASE("Points without spread, bad bandwidths and rows of different length are rejected") {
        const auto says = [](const auto& result, const char* words) {
            REQUIRE_FALSE(result);
            CHECK(result.error().text().find(words) != std::string::npos);
        };
        using Fixed = std::vector<double>;
        says(GaussianDensity::fit({}, BandwidthRule::scott), "there are none");
        says(GaussianDensity::fit({{1.0, 2.0}}, BandwidthRule::scott), "a single point");
        says(GaussianDensity::fit({{1.0, 2.0}, {1.0, 3.0}}, BandwidthRule::scott), "axis 1");
        says(GaussianDensity::fit({{1.0, 2.0}, {2.0, 4.0}, {3.0, 6.0}}, BandwidthRule::scott_covariance),
             "fewer dimensions");
        says(GaussianDensity::fit({{1.0, 2.0}, {1.0}}, BandwidthRule::scott), "a point of 1 numbers");
        says(GaussianDensity::fit({{1.0, 2.0}}, Fixed{0.0, 1.0}), "bandwidth 0");
        says(GaussianDensity::fit({{1.0, 2.0}}, Fixed{1.0}), "one for each axis");
        says(GaussianDensity::fit({{1.0, NAN}}, Fixed{1.0, 1.0}), "finite");
        says(bandwidthRuleFromName("silverman"), "normal-reference, scott or scott-covariance");
        CHECK(bandwidthRuleFromName("scott-covariance").value() == BandwidthRule::scott_covariance);
    }
}

TEST_SUITE("results/mean_shift") {
    TEST_CASE("Labels, centres and the estimated bandwidth agree with scikit-learn") {
        const auto file = reference();
        REQUIRE(file["mean_shift"].size() >= 30);
        for (const auto& example : file["mean_shift"]) {
            CAPTURE(example["name"].get<std::string>());
            const auto points = example["points"].get<Points>();
            CHECK(estimateBandwidth(points, example["quantile"].get<double>()) ==
                  doctest::Approx(example["estimated"].get<double>()).epsilon(1e-12));
            const auto found = meanShift(points, example["bandwidth"].get<double>());
            REQUIRE(found);
            const auto centres = example["centres"].get<Points>();
            REQUIRE(found->centres.size() == centres.size());
            for (std::size_t c = 0; c < centres.size(); ++c)
                for (std::size_t j = 0; j < centres[c].size(); ++j)
                    CHECK(found->centres[c][j] == doctest::Approx(centres[c][j]).epsilon(1e-10));
            CHECK(found->labels == example["labels"].get<std::vector<int>>());
        }
    }

    TEST_CASE("No points and a bandwidth of nothing are rejected") {
        CHECK_FALSE(meanShift({}, 1.0));
        CHECK_FALSE(meanShift({{1.0}}, 0.0));
        CHECK_FALSE(meanShift({{1.0}, {1.0, 2.0}}, 1.0));
        CHECK(meanShift({{1.0}, {1.0}}, 1.0)->centres == Points{{1.0}});
        CHECK(estimateBandwidth({{1.0}, {1.0}}) == 0.0);
    }
}

TEST_SUITE("results/spearman with density") {
    TEST_CASE("Correlations agree with SciPy; up to nine pairs p is that of all pairings") {
        const auto file = reference();
        REQUIRE(file["spearman"].size() == 5);
        for (const auto& example : file["spearman"]) {
            CAPTURE(example["name"].get<std::string>());
            const auto x = example["x"].get<std::vector<double>>();
            const auto y = example["y"].get<std::vector<double>>();
            const auto test = spearman(x, y);
            CHECK(test.n == static_cast<int>(x.size()));
            CHECK(test.method == (x.size() <= 9 ? "exact" : "t"));
            CHECK(test.rho == doctest::Approx(example["rho"].get<double>()).epsilon(1e-12));
            CHECK(test.p == doctest::Approx(example["p"].get<double>()).epsilon(1e-9));
            CHECK(spearman(y, x).p == doctest::Approx(test.p).epsilon(1e-12));
        }
    }

    TEST_CASE("Over 1,000 pairs p is that of Student's t, and rho that of the turned ranks") {
        const auto of_turned = [](int k) {
            std::vector<double> x, y;
            for (int i = 0; i < 1000; ++i) {
                x.push_back(i);
                y.push_back(i < 1000 - k ? i : 2000 - k - 1 - i);
            }
            return spearman(x, y);
        };
        CHECK(of_turned(0).rho == 1.0);
        CHECK(of_turned(0).p == 0.0);
        CHECK(of_turned(1000).rho == -1.0);
        const auto middling = of_turned(795);  // 1 - 2 (795^3 - 795)/(1000^3 - 1000); p by SciPy 1.10.1
        CHECK(middling.rho == doctest::Approx(-0.004919164919164919).epsilon(1e-9));
        CHECK(middling.p == doctest::Approx(0.8765343363200228).epsilon(1e-9));
    }

    TEST_CASE("A constant side, or fewer than two pairs, have no correlation") {
        const std::vector<double> constant{1.0, 1.0, 1.0};
        const std::vector<double> rising{1.0, 2.0, 3.0};
        CHECK(spearman(constant, rising).method == "undefined");
        CHECK(spearman(std::span<const double>{}, {}).method == "undefined");
        CHECK(spearman(constant, rising).p == 1.0);
        CHECK_THROWS((void)spearman(constant, std::span<const double>{}));
        CHECK(spearman(rising, rising).p == doctest::Approx(2.0 / 6.0));
    }
}
