#include "learning/networks/flow_module.hpp"

#include <doctest/doctest.h>

#include "learning/networks/optimising.hpp"
#include "motion/networks/flow.hpp"

using namespace deixis;
using namespace deixis::learning;

namespace {

/// A flow whose couplings do something, as after a training.
FlowModule anyFlow(const FlowSizes& sizes) {
    setUpTorch(1);  // as every training does
    torch::manual_seed(5);
    FlowModule flow(sizes);
    torch::NoGradGuard no_gradient;
    for (auto& parameter : flow.parameters()) parameter += 0.05 * torch::randn_like(parameter);
    return flow;
}

motion::VectorXf vectorOf(const torch::Tensor& tensor) {
    const torch::Tensor plain = tensor.contiguous();
    return Eigen::Map<const motion::VectorXf>(plain.data_ptr<float>(), plain.numel());
}

}  // namespace

TEST_SUITE("learning/flow_module") {
    TEST_CASE("latents and log-determinants are those of the Eigen flow to 1e-5, through a sequence") {
        for (const FlowSizes sizes : {FlowSizes{5, 3, 2, 6}, FlowSizes{53, 32, 8, 32}}) {
            CAPTURE(sizes.size);
            FlowModule flow = anyFlow(sizes);
            motion::NetworkWeights weights;
            flow.append(weights.arrays);
            const auto eigen = motion::ConditionalFlow::read(
                weights, {sizes.size, sizes.condition, sizes.steps, sizes.hidden});
            REQUIRE(eigen.has_value());
            torch::NoGradGuard no_gradient;
            const torch::Tensor x = torch::randn({12, 2, sizes.size});
            const torch::Tensor condition = torch::randn({12, 2, sizes.condition});
            const auto found = flow.forward(x, condition);
            for (int sequence = 0; sequence < 2; ++sequence) {
                auto state = eigen->zeroState();
                for (int frame = 0; frame < 12; ++frame) {
                    float log_determinant = 0.0F;
                    const auto z =
                        eigen->forward(vectorOf(x[frame][sequence]), vectorOf(condition[frame][sequence]),
                                       state, log_determinant);
                    const auto expected = vectorOf(found.z[frame][sequence]);
                    const float size = std::max(1.0F, expected.cwiseAbs().maxCoeff());
                    CHECK((z - expected).cwiseAbs().maxCoeff() < 1e-5F * size);
                    const auto other = found.log_determinant[frame][sequence].item<float>();
                    CHECK(std::abs(log_determinant - other) < 1e-5F * std::max(1.0F, std::abs(other)));
                }
            }
        }
    }

    TEST_CASE("a new flow is a rotation and a scaling: its latents are as long as its frames, scaled") {
        torch::manual_seed(1);
        FlowModule flow({6, 2, 1, 4});
        torch::NoGradGuard no_gradient;
        const torch::Tensor x = torch::randn({3, 1, 6});
        const auto found = flow.forward(x, torch::randn({3, 1, 2}));
        // The rotation keeps volume; the coupling scales three numbers by sigmoid(2) + 1e-6.
        const double scale = 1.0 / (1.0 + std::exp(-2.0)) + 1e-6;
        for (int frame = 0; frame < 3; ++frame)
            CHECK(found.log_determinant[frame][0].item<double>() ==
                  doctest::Approx(3.0 * std::log(scale)).epsilon(1e-4));
    }

    TEST_CASE("actnorm begins with mean 0 and standard deviation 1 of the first frames") {
        torch::manual_seed(2);
        FlowModule flow({4, 2, 1, 4});
        torch::NoGradGuard no_gradient;
        const torch::Tensor x = 3.0 * torch::randn({50, 4, 4}) + 7.0;
        const torch::Tensor condition = torch::randn({50, 4, 2});
        flow.initialiseFrom(x, condition);
        std::vector<motion::NamedArray> arrays;
        flow.append(arrays);
        REQUIRE(arrays[0].name == "flow.0.actnorm.bias");
        REQUIRE(arrays[1].name == "flow.0.actnorm.log_scale");
        for (std::int64_t d = 0; d < 4; ++d) {
            const torch::Tensor column = x.select(-1, d);
            CHECK(arrays[0].values[static_cast<std::size_t>(d)] ==
                  doctest::Approx(-column.mean().item<double>()).epsilon(1e-4));
            CHECK(arrays[1].values[static_cast<std::size_t>(d)] ==
                  doctest::Approx(-std::log(column.std().item<double>())).epsilon(1e-4));
        }
    }
}
