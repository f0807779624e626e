#include "motion/networks/flow.hpp"

#include <fmt/format.h>

#include <cmath>

#include "motion/networks/taking.hpp"

namespace deixis::motion {

namespace {

/// Shift and scale of a coupling for one frame.
struct Affine {
    VectorXf shift;
    VectorXf scale;
};

Affine affineOf(const AffineCoupling& coupling, const VectorXf& kept, const VectorXf& condition,
                AffineCoupling::State& state) {
    VectorXf input(kept.size() + condition.size());
    input << kept, condition;
    coupling.first.step(input, state.first);
    coupling.second.step(state.first.hidden, state.second);
    const VectorXf out = coupling.output.forward(state.second.hidden);
    const Eigen::Index half = out.size() / 2;
    Affine affine{out.head(half), VectorXf(half)};
    for (Eigen::Index i = 0; i < half; ++i) affine.scale[i] = sigmoid(out[half + i] + 2.0F) + 1e-6F;
    return affine;
}

/// The permutation of a file, whose numbers must be 0 to size - 1, each once.
Result<Eigen::VectorXi> readPermutation(const NetworkWeights& weights, const std::string& name, int size) {
    const auto numbers = readVector(weights, name, size);
    if (!numbers) return tl::unexpected(numbers.error());
    Eigen::VectorXi out(size);
    std::vector<bool> seen(static_cast<std::size_t>(size), false);
    for (int i = 0; i < size; ++i) {
        const float number = (*numbers)[i];
        if (!(number >= 0.0F && number < static_cast<float>(size)) || number != std::floor(number) ||
            seen[static_cast<std::size_t>(number)])
            return fail(fmt::format("{}: {}", weights.file, name),
                        fmt::format("found {}, expected each of 0 to {} once", number, size - 1));
        seen[static_cast<std::size_t>(number)] = true;
        out[i] = static_cast<int>(number);
    }
    return out;
}

}  // namespace

VectorXf ActNorm::forward(const VectorXf& x) const {
    return (x + bias).array() * log_scale.array().exp();
}

VectorXf ActNorm::inverse(const VectorXf& y) const {
    return (y.array() * (-log_scale.array()).exp()).matrix() - bias;
}

VectorXf InvertibleLinear::forward(const VectorXf& x) const {
    VectorXf v = upper.triangularView<Eigen::StrictlyUpper>() * x;
    v.array() += sign.array() * log_size.array().exp() * x.array();
    const VectorXf w = lower.triangularView<Eigen::UnitLower>() * v;
    VectorXf y(w.size());
    for (Eigen::Index i = 0; i < y.size(); ++i) y[i] = w[permutation[i]];
    return y;
}

VectorXf InvertibleLinear::inverse(const VectorXf& y) const {
    VectorXf w(y.size());
    for (Eigen::Index i = 0; i < y.size(); ++i) w[permutation[i]] = y[i];
    lower.triangularView<Eigen::UnitLower>().solveInPlace(w);
    for (Eigen::Index i = w.size() - 1; i >= 0; --i) {
        const Eigen::Index behind = w.size() - i - 1;
        w[i] -= upper.row(i).tail(behind).dot(w.tail(behind));
        w[i] *= sign[i] * std::exp(-log_size[i]);
    }
    return w;
}

VectorXf AffineCoupling::forward(const VectorXf& x, const VectorXf& condition, State& state,
                                 float& log_determinant) const {
    const Eigen::Index changed = output.bias.size() / 2;
    const VectorXf kept = x.head(x.size() - changed);
    const Affine affine = affineOf(*this, kept, condition, state);
    VectorXf y(x.size());
    y << kept, ((x.tail(changed) + affine.shift).array() * affine.scale.array()).matrix();
    log_determinant = affine.scale.array().log().sum();
    return y;
}

VectorXf AffineCoupling::inverse(const VectorXf& y, const VectorXf& condition, State& state) const {
    const Eigen::Index changed = output.bias.size() / 2;
    const VectorXf kept = y.head(y.size() - changed);
    const Affine affine = affineOf(*this, kept, condition, state);
    VectorXf x(y.size());
    x << kept, (y.tail(changed).array() / affine.scale.array()).matrix() - affine.shift;
    return x;
}

Result<ConditionalFlow::Step> ConditionalFlow::readStep(const NetworkWeights& weights,
                                                        const std::string& name, const FlowShape& shape) {
    Step step;
    Taking take;
    take(step.actnorm.bias, readVector(weights, name + ".actnorm.bias", shape.size));
    take(step.actnorm.log_scale, readVector(weights, name + ".actnorm.log_scale", shape.size));
    take(step.linear.permutation, readPermutation(weights, name + ".linear.permutation", shape.size));
    take(step.linear.lower, readMatrix(weights, name + ".linear.lower", shape.size, shape.size));
    take(step.linear.upper, readMatrix(weights, name + ".linear.upper", shape.size, shape.size));
    take(step.linear.sign, readVector(weights, name + ".linear.sign", shape.size));
    take(step.linear.log_size, readVector(weights, name + ".linear.log_size", shape.size));
    take(step.coupling.first,
         LstmCell::read(weights, name + ".coupling.first", shape.kept() + shape.condition, shape.hidden));
    take(step.coupling.second,
         LstmCell::read(weights, name + ".coupling.second", shape.hidden, shape.hidden));
    take(step.coupling.output,
         Linear::read(weights, name + ".coupling.output", shape.hidden, 2 * shape.changed()));
    if (take.problem()) return tl::unexpected(*take.problem());
    return step;
}

Result<ConditionalFlow> ConditionalFlow::read(const NetworkWeights& weights, const FlowShape& shape) {
    ConditionalFlow out;
    out.shape_ = shape;
    for (int k = 0; k < shape.steps; ++k) {
        auto step = readStep(weights, fmt::format("flow.{}", k), shape);
        if (!step) return tl::unexpected(step.error());
        out.steps_.push_back(std::move(*step));
    }
    return out;
}

ConditionalFlow::State ConditionalFlow::zeroState() const {
    return State(steps_.size(), {LstmState::zero(shape_.hidden), LstmState::zero(shape_.hidden)});
}

VectorXf ConditionalFlow::forward(VectorXf x, const VectorXf& condition, State& state,
                                  float& log_determinant) const {
    log_determinant = 0.0F;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
        const Step& step = steps_[k];
        float coupled = 0.0F;
        x = step.coupling.forward(step.linear.forward(step.actnorm.forward(x)), condition, state[k], coupled);
        log_determinant += step.actnorm.logDeterminant() + step.linear.logDeterminant() + coupled;
    }
    return x;
}

VectorXf ConditionalFlow::inverse(VectorXf z, const VectorXf& condition, State& state) const {
    for (std::size_t k = steps_.size(); k-- > 0;) {
        const Step& step = steps_[k];
        z = step.actnorm.inverse(step.linear.inverse(step.coupling.inverse(z, condition, state[k])));
    }
    return z;
}

}  // namespace deixis::motion
