#include "motion/networks/flow.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>

#include "flow_fixture.hpp"

using namespace deixis;
using namespace deixis::motion;
using namespace deixis::tests;
using doctest::Approx;

namespace {

ConditionalFlow randomFlow(const FlowShape& shape, std::uint64_t seed) {
    NetworkWeights weights;
    weights.arrays = randomFlowArrays(shape, seed);
    auto read = ConditionalFlow::read(weights, shape);
    REQUIRE(read.has_value());
    return std::move(*read);
}

/// log |det| of the map from a frame to its latent, by central differences.
double numericalLogDeterminant(const ConditionalFlow& flow, const VectorXf& x, const VectorXf& condition,
                               const ConditionalFlow::State& before) {
    const Eigen::Index n = x.size();
    Eigen::MatrixXd jacobian(n, n);
    constexpr float h = 3e-3F;
    for (Eigen::Index j = 0; j < n; ++j) {
        float unused = 0.0F;
        VectorXf high = x, low = x;
        high[j] += h;
        low[j] -= h;
        ConditionalFlow::State a = before, b = before;
        const VectorXf up = flow.forward(high, condition, a, unused);
        const VectorXf down = flow.forward(low, condition, b, unused);
        jacobian.col(j) = (up - down).cast<double>() / static_cast<double>(high[j] - low[j]);
    }
    return std::log(std::abs(jacobian.determinant()));
}

}  // namespace

TEST_SUITE("motion/network_layers") {
    TEST_CASE("a linear layer gives what is worked by hand") {
        NetworkWeights weights;
        weights.arrays = {{"l.weight", {2, 3}, {1, 2, 3, -1, 0, 0.5}}, {"l.bias", {2}, {0.25, -1}}};
        const auto layer = Linear::read(weights, "l", 3, 2);
        REQUIRE(layer.has_value());
        const VectorXf y = layer->forward(VectorXf{{1.0F, -1.0F, 2.0F}});
        CHECK(y[0] == 5.25F);  // 1 - 2 + 6 + 0.25
        CHECK(y[1] == -1.0F);  // -1 + 0 + 1 - 1
        CHECK_FALSE(Linear::read(weights, "l", 2, 2).has_value());
        CHECK_FALSE(Linear::read(weights, "m", 3, 2).has_value());
    }

    // Gates 0.7, 0, 1.05 and 0.2 before their functions; the rest in double precision by Python's math.
    TEST_CASE("an LSTM cell of one unit gives what is worked by hand") {
        NetworkWeights weights;
        weights.arrays = {{"c.input_weight", {4, 1}, {1.0F, -0.5F, 2.0F, 0.3F}},
                          {"c.hidden_weight", {4, 1}, {0.4F, 0.2F, -1.0F, 0.6F}},
                          {"c.bias", {4}, {0.1F, 0.2F, 0.3F, -0.1F}}};
        const auto cell = LstmCell::read(weights, "c", 1, 1);
        REQUIRE(cell.has_value());
        LstmState state{VectorXf{{0.25F}}, VectorXf{{-0.4F}}};
        cell->step(VectorXf{{0.5F}}, state);
        CHECK(state.cell[0] == Approx(0.32239344835751543).epsilon(1e-6));
        CHECK(state.hidden[0] == Approx(0.17136647832011215).epsilon(1e-6));
    }

    TEST_CASE("an invertible linear map is P L U: by hand for two numbers") {
        // L = (1 0; 0.5 1), U = (2 3; 0 -1), P exchanges: L U = (2 3; 1 0.5), y = (1 0.5; 2 3) x.
        InvertibleLinear map;
        map.permutation = Eigen::VectorXi{{1, 0}};
        map.lower = MatrixXf{{9.0F, 9.0F}, {0.5F, 9.0F}};  // what is not below the diagonal does not count
        map.upper = MatrixXf{{9.0F, 3.0F}, {9.0F, 9.0F}};
        map.sign = VectorXf{{1.0F, -1.0F}};
        map.log_size = VectorXf{{std::log(2.0F), 0.0F}};
        const VectorXf y = map.forward(VectorXf{{1.0F, 4.0F}});
        CHECK(y[0] == Approx(3.0));
        CHECK(y[1] == Approx(14.0));
        CHECK(map.logDeterminant() == Approx(std::log(2.0)));  // |1 * 3 - 0.5 * 2| = 2
        const VectorXf x = map.inverse(y);
        CHECK(x[0] == Approx(1.0));
        CHECK(x[1] == Approx(4.0));
    }

    TEST_CASE("actnorm shifts, scales and goes back") {
        const ActNorm norm{VectorXf{{1.0F, -2.0F}}, VectorXf{{std::log(3.0F), 0.0F}}};
        const VectorXf y = norm.forward(VectorXf{{1.0F, 5.0F}});
        CHECK(y[0] == Approx(6.0));
        CHECK(y[1] == Approx(3.0));
        CHECK(norm.logDeterminant() == Approx(std::log(3.0)));
        CHECK(norm.inverse(y)[0] == Approx(1.0));
        CHECK(norm.inverse(y)[1] == Approx(5.0));
    }
}

TEST_SUITE("motion/flow") {
    TEST_CASE("a sequence of frames comes back from its latents to 1e-5, with the state carried") {
        for (const FlowShape shape :
             {FlowShape{7, 5, 3, 8}, FlowShape{2, 1, 4, 3}, FlowShape{52, 40, 8, 16}}) {
            CAPTURE(shape.size);
            const ConditionalFlow flow = randomFlow(shape, 11);
            Random random(5);
            ConditionalFlow::State there = flow.zeroState(), back = flow.zeroState();
            for (int frame = 0; frame < 20; ++frame) {
                const VectorXf x = randomVector(shape.size, random);
                const VectorXf condition = randomVector(shape.condition, random);
                float unused = 0.0F;
                const VectorXf z = flow.forward(x, condition, there, unused);
                const VectorXf again = flow.inverse(z, condition, back);
                CHECK((again - x).cwiseAbs().maxCoeff() < 1e-5F * std::max(1.0F, z.cwiseAbs().maxCoeff()));
            }
        }
    }

    TEST_CASE("the log-determinant is that of the numerical Jacobian, frame after frame") {
        const FlowShape shape{5, 3, 3, 6};
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            const ConditionalFlow flow = randomFlow(shape, seed);
            Random random(seed);
            ConditionalFlow::State state = flow.zeroState();
            for (int frame = 0; frame < 4; ++frame) {
                const VectorXf x = randomVector(shape.size, random);
                const VectorXf condition = randomVector(shape.condition, random);
                const double expected = numericalLogDeterminant(flow, x, condition, state);
                float found = 0.0F;
                (void)flow.forward(x, condition, state, found);
                CHECK(found == Approx(expected).epsilon(2e-3).scale(1.0));
            }
        }
    }

    TEST_CASE("a permutation that is none, and an array that is missing, are named") {
        const FlowShape shape{4, 2, 2, 3};
        NetworkWeights weights;
        weights.file = "w.bin";
        weights.arrays = randomFlowArrays(shape, 3);
        for (NamedArray& array : weights.arrays)
            if (array.name == "flow.1.linear.permutation") array.values[0] = array.values[1];
        const auto twice = ConditionalFlow::read(weights, shape);
        REQUIRE_FALSE(twice.has_value());
        CHECK(twice.error().where == "w.bin: flow.1.linear.permutation");
        std::erase_if(weights.arrays, [](const NamedArray& a) { return a.name == "flow.0.actnorm.bias"; });
        const auto missing = ConditionalFlow::read(weights, shape);
        REQUIRE_FALSE(missing.has_value());
        CHECK(missing.error().where == "w.bin: flow.0.actnorm.bias");
    }
}
