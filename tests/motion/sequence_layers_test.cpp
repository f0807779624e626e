// Layers over sequences, by hand. That they are LibTorch's is tested in tests/learning.
#include "motion/networks/sequence_layers.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace deixis;
using namespace deixis::motion;

namespace {

NetworkWeights convolutionOf(std::vector<float> weight, std::size_t outputs, std::size_t inputs,
                             std::size_t kernel) {
    NetworkWeights out;
    out.arrays = {{"c.weight", {outputs, inputs, kernel}, std::move(weight)},
                  {"c.bias", {outputs}, std::vector<float>(outputs, 0.5F)}};
    return out;
}

}  // namespace

TEST_SUITE("motion/sequence_layers") {
    TEST_CASE("a convolution's taps, stride, dilation and padding stand where they should") {
        MatrixXf x(1, 6);
        x << 1, 2, 3, 4, 5, 6;
        const auto weights = convolutionOf({1, 10, 100}, 1, 1, 3);
        const auto of = [&](const ConvolutionPlaces& places) {
            return Convolution::read(weights, "c", 1, 1, places).value().forward(x);
        };
        MatrixXf plain(1, 4), strided(1, 2), dilated(1, 2), padded(1, 6);
        plain << 321.5, 432.5, 543.5, 654.5;
        strided << 321.5, 654.5;
        dilated << 531.5, 642.5;
        padded << 210.5, 321.5, 432.5, 543.5, 654.5, 65.5;
        CHECK(of({.kernel = 3}) == plain);
        CHECK(of({.kernel = 3, .stride = 3}) == strided);
        CHECK(of({.kernel = 3, .dilation = 2}) == dilated);
        CHECK(of({.kernel = 3, .padding = 1}) == padded);
        CHECK(of({.kernel = 3, .dilation = 3}).cols() == 0);
    }

    TEST_CASE("a convolution's inputs and outputs do not change places") {
        MatrixXf x(2, 2);
        x << 1, 2, 10, 20;
        // Of output 0: input 0 at both taps, input 1 at both taps; then of output 1.
        const auto weights = convolutionOf({1, 2, 3, 4, 5, 6, 7, 8}, 2, 2, 2);
        const MatrixXf out = Convolution::read(weights, "c", 2, 2, {.kernel = 2}).value().forward(x);
        REQUIRE(out.cols() == 1);
        CHECK(out(0, 0) == 1 * 1 + 2 * 2 + 3 * 10 + 4 * 20 + 0.5F);
        CHECK(out(1, 0) == 5 * 1 + 6 * 2 + 7 * 10 + 8 * 20 + 0.5F);
        CHECK_FALSE(Convolution::read(weights, "c", 2, 2, {.kernel = 3}).has_value());
    }

    TEST_CASE("a GRU of one number, step by step, forwards and backwards") {
        NetworkWeights weights;
        weights.arrays = {{"g.input_weight", {3, 1}, {0.5F, -1.0F, 2.0F}},
                          {"g.hidden_weight", {3, 1}, {0.3F, 0.7F, -0.4F}},
                          {"g.input_bias", {3}, {0.1F, 0.2F, 0.3F}},
                          {"g.hidden_bias", {3}, {-0.1F, 0.0F, 0.6F}}};
        const GruLayer gru = GruLayer::read(weights, "g", 1, 1).value();
        const auto next = [](double h, double x) {
            const auto logistic = [](double v) { return 1.0 / (1.0 + std::exp(-v)); };
            const double reset = logistic(0.5 * x + 0.1 + 0.3 * h - 0.1);
            const double update = logistic(-x + 0.2 + 0.7 * h);
            const double candidate = std::tanh(2.0 * x + 0.3 + reset * (-0.4 * h + 0.6));
            return (1.0 - update) * candidate + update * h;
        };
        MatrixXf x(1, 3);
        x << 0.4F, -1.0F, 0.8F;
        const double first = next(0.0, 0.4), second = next(first, -1.0);
        const MatrixXf forward = gru.forward(x, false), backward = gru.forward(x, true);
        CHECK(forward(0, 0) == doctest::Approx(first).epsilon(1e-6));
        CHECK(forward(0, 1) == doctest::Approx(second).epsilon(1e-6));
        CHECK(forward(0, 2) == doctest::Approx(next(second, 0.8)).epsilon(1e-6));
        CHECK(backward(0, 2) == doctest::Approx(next(0.0, 0.8)).epsilon(1e-6));
        CHECK(backward(0, 0) == doctest::Approx(next(next(next(0.0, 0.8), -1.0), 0.4)).epsilon(1e-6));
    }
}
