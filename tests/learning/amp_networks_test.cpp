// The networks of adversarial motion priors: phases by hand-worked numbers, the policy against its inference.
#include "learning/networks/tensors.hpp"
#include "modules.hpp"
// After LibTorch's, whose CHECK is another.
#include <doctest/doctest.h>

#include "physics/policy/policy.hpp"

using namespace deixis;
using namespace deixis::learning;

TEST_SUITE("learning/amp_networks") {
    TEST_CASE("a phase mixes four sets of weights by the cubic of Catmull and Rom, on a circle") {
        const auto shares = phaseShares(torch::tensor({0.0F, 0.125F, 0.25F, 0.9375F, 1.0F}));
        // At the begin of a quarter its set alone; in its middle -1/16, 9/16, 9/16, -1/16 of those around.
        const float wanted[5][4] = {{1.0F, 0.0F, 0.0F, 0.0F},
                                    {0.5625F, 0.5625F, -0.0625F, -0.0625F},
                                    {0.0F, 1.0F, 0.0F, 0.0F},
                                    // three quarters of the way from the fourth to the first:
                                    {0.8671875F, -0.0703125F, -0.0234375F, 0.2265625F},
                                    {1.0F, 0.0F, 0.0F, 0.0F}};
        for (int row = 0; row < 5; ++row)
            for (int set = 0; set < 4; ++set)
                CHECK(shares[row][set].item<float>() == doctest::Approx(wanted[row][set]).epsilon(1e-5));
    }

    TEST_CASE("a discriminator without phases has the same opinion at all of them") {
        torch::manual_seed(1);
        Discriminator plain(6, {8, 4}, false), phased(6, {8, 4}, true);
        const auto x = torch::randn({3, 6});
        const auto at = [&](Discriminator& one, float phase) {
            return one.forward(x, torch::full({3}, phase));
        };
        CHECK(torch::equal(at(plain, 0.1F), at(plain, 0.6F)));
        CHECK_FALSE(torch::allclose(at(phased, 0.1F), at(phased, 0.6F)));
        CHECK(torch::allclose(at(phased, 0.0F), at(phased, 1.0F)));
    }

    TEST_CASE("a policy acts in Eigen as in LibTorch") {
        torch::manual_seed(2);
        Mlp network(5, {16, 8}, 3, 1.0);
        const auto mean = torch::randn({5}), sd = torch::rand({5}) + 0.5, out_mean = torch::randn({3}),
                   out_sd = torch::rand({3}) + 0.5;
        motion::NetworkWeights weights;
        network.append("policy0", weights.arrays);
        weights.arrays.push_back(arrayOf("policy0.input_mean", mean));
        weights.arrays.push_back(arrayOf("policy0.input_sd", sd));
        weights.arrays.push_back(arrayOf("policy0.output_mean", out_mean));
        weights.arrays.push_back(arrayOf("policy0.output_sd", out_sd));
        const int hidden[] = {16, 8};
        const auto policy = physics::Policy::read(weights, "policy0", 5, hidden, 3);
        REQUIRE(policy.has_value());
        const auto x = 3.0 * torch::randn({20, 5});  // beyond five deviations, too
        const auto wanted = out_mean + out_sd * network.forward(((x - mean) / sd).clamp(-5.0, 5.0));
        for (int row = 0; row < 20; ++row) {
            const auto seen = x[row].contiguous();
            double targets[3];
            policy->act({seen.data_ptr<float>(), 5}, targets);
            for (int i = 0; i < 3; ++i)
                CHECK(targets[i] == doctest::Approx(wanted[row][i].item<double>()).epsilon(1e-5));
        }
    }
}
