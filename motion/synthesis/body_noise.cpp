#include "body_noise.hpp"

#include <cmath>

namespace deixis::motion {

SmoothNoise::SmoothNoise(const NoiseParameters& parameters)
    : decay_(std::sqrt(std::sqrt(parameters.ou_decay))), omega_(2.0 * pi * parameters.smoothing_hz) {
    // The same process seen four times as often: equal correlation time and equal spread.
    const double variance =
        parameters.ou_step_rad * parameters.ou_step_rad / (1.0 - parameters.ou_decay * parameters.ou_decay);
    kick_ = std::sqrt(variance * (1.0 - decay_ * decay_));
}

double SmoothNoise::step(Random& random) {
    constexpr double dt = 1.0 / (30.0 * steps_per_frame);
    for (int i = 0; i < steps_per_frame; ++i) {
        raw_ = decay_ * raw_ + kick_ * random.normal();
        speed_ += dt * omega_ * (omega_ * (raw_ - value_) - 2.0 * speed_);
        value_ += dt * speed_;
    }
    return value_;
}

Wave::Wave(const Interval& hz, Random& random) {
    for (std::size_t i = 0; i < angular_.size(); ++i) {
        angular_[i] = 2.0 * pi * drawn(hz, random);
        phase_[i] = random.uniform(0.0, 2.0 * pi);
    }
}

double Wave::at(double time_s) const {
    constexpr double weight = 0.57735026918962576;  // three such sinusoids have a single one's power
    double sum = 0.0;
    for (std::size_t i = 0; i < angular_.size(); ++i) sum += std::sin(angular_[i] * time_s + phase_[i]);
    return weight * sum;
}

}  // namespace deixis::motion
