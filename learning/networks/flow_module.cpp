#include "learning/networks/flow_module.hpp"

#include <fmt/format.h>

#include "learning/networks/tensors.hpp"

namespace deixis::learning {

namespace {

/// A permutation that LibTorch's LU decomposition returns, as the place in L U x of each number of P L U x.
torch::Tensor placesOf(const torch::Tensor& permutation_matrix) {
    return std::get<1>(permutation_matrix.max(1)).to(torch::kFloat32);
}

}  // namespace

FlowModule::FlowModule(const FlowSizes& sizes) : sizes_(sizes) {
    const int kept = sizes.size / 2;
    const int changed = sizes.size - kept;
    for (int k = 0; k < sizes.steps; ++k) {
        const auto named = [k](const char* part) { return fmt::format("step{}_{}", k, part); };
        Step step;
        step.bias = register_parameter(named("bias"), torch::zeros({sizes.size}));
        step.log_scale = register_parameter(named("log_scale"), torch::zeros({sizes.size}));
        const torch::Tensor rotation = std::get<0>(torch::linalg_qr(torch::randn({sizes.size, sizes.size})));
        const auto [permutation, lower, upper] = torch::linalg_lu(rotation);
        const torch::Tensor diagonal = upper.diagonal().clone();
        step.permutation = register_buffer(named("permutation"), placesOf(permutation));
        step.sign = register_buffer(named("sign"), diagonal.sign());
        step.log_size = register_parameter(named("log_size"), diagonal.abs().log());
        step.lower = register_parameter(named("lower"), lower.tril(-1).clone());
        step.upper = register_parameter(named("upper"), upper.triu(1).clone());
        step.lstm = register_module(
            named("lstm"),
            torch::nn::LSTM(torch::nn::LSTMOptions(kept + sizes.condition, sizes.hidden).num_layers(2)));
        step.output = register_module(named("output"), torch::nn::Linear(sizes.hidden, 2 * changed));
        torch::NoGradGuard no_gradient;
        step.output->weight.zero_();
        step.output->bias.zero_();
        steps_.push_back(std::move(step));
    }
}

torch::Tensor FlowModule::linear(const Step& step, const torch::Tensor& x) const {
    const torch::Tensor lower = step.lower.tril(-1) + torch::eye(sizes_.size);
    const torch::Tensor upper = step.upper.triu(1) + (step.sign * step.log_size.exp()).diag();
    const torch::Tensor weight = lower.matmul(upper).index_select(0, step.permutation.to(torch::kInt64));
    return x.matmul(weight.t());
}

torch::Tensor FlowModule::coupled(Step& step, const torch::Tensor& x, const torch::Tensor& condition,
                                  torch::Tensor& log_determinant) {
    const std::int64_t kept = sizes_.size / 2;
    const torch::Tensor first = x.narrow(-1, 0, kept);
    const torch::Tensor second = x.narrow(-1, kept, sizes_.size - kept);
    const torch::Tensor hidden = std::get<0>(step.lstm->forward(torch::cat({first, condition}, -1)));
    const auto parts = step.output->forward(hidden).chunk(2, -1);
    const torch::Tensor scale = torch::sigmoid(parts[1] + 2.0) + 1e-6;
    log_determinant = log_determinant + scale.log().sum(-1);
    return torch::cat({first, (second + parts[0]) * scale}, -1);
}

FlowModule::Latents FlowModule::forward(torch::Tensor x, const torch::Tensor& condition) {
    torch::Tensor log_determinant = torch::zeros({x.size(0), x.size(1)});
    for (Step& step : steps_) {
        x = linear(step, (x + step.bias) * step.log_scale.exp());
        log_determinant = log_determinant + step.log_scale.sum() + step.log_size.sum();
        x = coupled(step, x, condition, log_determinant);
    }
    return {x, log_determinant};
}

void FlowModule::initialiseFrom(torch::Tensor x, const torch::Tensor& condition) {
    torch::NoGradGuard no_gradient;
    torch::Tensor unused = torch::zeros({x.size(0), x.size(1)});
    for (Step& step : steps_) {
        const torch::Tensor flat = x.reshape({-1, sizes_.size});
        step.bias.copy_(-flat.mean(0));
        step.log_scale.copy_(-(flat.std(0) + 1e-6).log());
        x = coupled(step, linear(step, (x + step.bias) * step.log_scale.exp()), condition, unused);
    }
}

void FlowModule::append(std::vector<motion::NamedArray>& out) const {
    for (std::size_t k = 0; k < steps_.size(); ++k) {
        const Step& step = steps_[k];
        const auto add = [&](const char* part, const torch::Tensor& tensor) {
            out.push_back(arrayOf(fmt::format("flow.{}.{}", k, part), tensor));
        };
        add("actnorm.bias", step.bias);
        add("actnorm.log_scale", step.log_scale);
        add("linear.permutation", step.permutation);
        add("linear.lower", step.lower.tril(-1));
        add("linear.upper", step.upper.triu(1));
        add("linear.sign", step.sign);
        add("linear.log_size", step.log_size);
        // Input weight, hidden weight and the two biases of a layer, in LibTorch's order.
        const auto numbers = step.lstm->parameters();
        const char* const layers[] = {"coupling.first", "coupling.second"};
        for (std::size_t layer = 0; layer < 2; ++layer) {
            const auto* at = numbers.data() + 4 * layer;
            add(fmt::format("{}.input_weight", layers[layer]).c_str(), at[0]);
            add(fmt::format("{}.hidden_weight", layers[layer]).c_str(), at[1]);
            add(fmt::format("{}.bias", layers[layer]).c_str(), at[2] + at[3]);
        }
        add("coupling.output.weight", step.output->weight);
        add("coupling.output.bias", step.output->bias);
    }
}

}  // namespace deixis::learning
