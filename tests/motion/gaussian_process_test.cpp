#include "motion/synthesis/gaussian_process.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "core/pose.hpp"
#include "core/random.hpp"

using namespace deixis;
using namespace deixis::motion;
using doctest::Approx;

TEST_SUITE("motion/gaussian_process") {
    // Observations 1 at 0 and -1 at 1: K = (1.5 r; r 1.5) with r = e^-1/2, so K^-1 y = y / (1.5 - r).
    TEST_CASE("two observations have the posterior and the likelihood that are worked by hand") {
        const Kernel kernel{0.0, 0.0, 1.0, 0.5};
        const GaussianProcess process({{0.0}, {1.0}}, {{1.0, 2.0}, {-1.0, -2.0}}, kernel);
        const double r = std::exp(-0.5);
        const std::vector<double> at_0 = process.predict(std::array{0.0});
        REQUIRE(at_0.size() == 2);
        CHECK(at_0[0] == Approx((1.0 - r) / (1.5 - r)));
        CHECK(at_0[1] == Approx(2.0 * at_0[0]));
        CHECK(process.predict(std::array{0.5})[0] == Approx(0.0));
        CHECK(process.predict(std::array{2.0})[0] == Approx((std::exp(-2.0) - std::exp(-0.5)) / (1.5 - r)));
        // y' K^-1 y = 2 / (1.5 - r) for the first output and four times that for the second.
        const double variance = (2.0 + 8.0) / (1.5 - r) / 4.0;
        const double expected =
            -0.5 * (4.0 * std::log(2.0 * pi * variance) + 4.0 + 2.0 * std::log(2.25 - r * r));
        CHECK(process.logMarginalLikelihood() == Approx(expected));
    }

    TEST_CASE("without noise it runs through its observations") {
        const std::vector<std::vector<double>> inputs{{0.0, 1.0}, {0.5, -1.0}, {2.0, 0.3}, {-1.0, 0.2}};
        const std::vector<std::vector<double>> outputs{{1.0}, {-3.0}, {0.5}, {7.0}};
        Kernel kernel;
        kernel.noise = 1e-10;
        const GaussianProcess process(inputs, outputs, kernel);
        for (std::size_t i = 0; i < inputs.size(); ++i)
            CHECK(process.predict(inputs[i])[0] == Approx(outputs[i][0]).epsilon(1e-6));
    }

    TEST_CASE("far from all observations it continues the straight line of least squares") {
        // y = 3 + 2x, with errors +1, -1, -1, +1 that leave the line of least squares where it is.
        const std::vector<std::vector<double>> inputs{{-3.0}, {-1.0}, {1.0}, {3.0}};
        const std::vector<std::vector<double>> outputs{{-2.0}, {0.0}, {4.0}, {10.0}};
        const GaussianProcess process(inputs, outputs, Kernel{1e6, 1e6, 1e4, 1.0});
        CHECK(process.predict(std::array{10.0})[0] == Approx(23.0).epsilon(1e-4));
        CHECK(process.predict(std::array{-10.0})[0] == Approx(-17.0).epsilon(1e-4));
    }

    TEST_CASE("the likelihood finds the noise and the length that outputs were made with") {
        Random random(3);
        std::vector<std::vector<double>> inputs, outputs;
        for (int i = 0; i < 60; ++i) {
            const double x = random.uniform(-3.0, 3.0);
            inputs.push_back({x});
            std::vector<double> row;
            for (int d = 0; d < 40; ++d) row.push_back(std::sin(2.0 * x + d) + random.normal(0.0, 0.1));
            outputs.push_back(row);
        }
        const std::array lengths{0.05, 0.2, 1.0, 5.0, 20.0};
        const std::array noises{1e-6, 1e-2, 1.0};
        const auto process = GaussianProcess::fitted(inputs, outputs, lengths, noises);
        CHECK(process.kernel().length == 1.0);
        CHECK(process.kernel().noise == 1e-2);
    }

    TEST_CASE("what is left out is predicted as by a process that was never told of it") {
        Random random(5);
        std::vector<std::vector<double>> inputs, outputs;
        for (int i = 0; i < 7; ++i) {
            inputs.push_back({random.normal(), random.normal()});
            outputs.push_back({random.normal(), 3.0 + random.normal()});
        }
        const Kernel kernel{2.0, 0.5, 0.8, 0.05};
        const auto errors = GaussianProcess(inputs, outputs, kernel).leftOutErrors();
        REQUIRE(errors.rows() == static_cast<Eigen::Index>(inputs.size()));
        for (std::size_t left_out = 0; left_out < inputs.size(); ++left_out) {
            auto others = inputs, their_outputs = outputs;
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
            their_outputs.erase(their_outputs.begin() + static_cast<std::ptrdiff_t>(left_out));
            const auto predicted = GaussianProcess(others, their_outputs, kernel).predict(inputs[left_out]);
            for (std::size_t d = 0; d < 2; ++d)
                CHECK(errors(static_cast<Eigen::Index>(left_out), static_cast<Eigen::Index>(d)) ==
                      Approx(outputs[left_out][d] - predicted[d]));
        }
    }

    TEST_CASE("what has no positive definite covariance is a broken invariant") {
        const std::vector<std::vector<double>> twice{{0.5}, {0.5}};
        CHECK_THROWS(GaussianProcess(twice, {{1.0}, {2.0}}, Kernel{0.0, 0.0, 1.0, 0.0}));
        CHECK_NOTHROW(GaussianProcess(twice, {{1.0}, {2.0}}, Kernel{0.0, 0.0, 1.0, 0.1}));
    }
}
