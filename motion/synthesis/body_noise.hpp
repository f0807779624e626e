// The small movements of a living body: joint noise, drift of a held arm, sway and breathing.
#pragma once

#include <array>
#include <cstdint>

#include "core/pose.hpp"
#include "core/random.hpp"
#include "motion/synthesis/demonstration_parameters.hpp"

namespace deixis::motion {

/// An Ornstein-Uhlenbeck process behind a critically damped second-order low-pass, stepped at 120 Hz.
class SmoothNoise {
  public:
    explicit SmoothNoise(const NoiseParameters& parameters);
    /// The value one output frame (1/30 s) later, radians.
    double step(Random& random);

  private:
    static constexpr int steps_per_frame = 4;
    double decay_;
    double kick_;
    double omega_;
    double raw_ = 0.0;
    double value_ = 0.0;
    double speed_ = 0.0;
};

/// The sum of three sinusoids of random frequency and phase; amplitude about 1.
class Wave {
  public:
    Wave(const Interval& hz, Random& random);
    [[nodiscard]] double at(double time_s) const;

  private:
    std::array<double, 3> angular_;
    std::array<double, 3> phase_;
};

[[nodiscard]] inline double drawn(const Interval& interval, Random& random) {
    return random.uniform(interval.low, interval.high);
}
[[nodiscard]] inline double drawn(const Spread& spread, Random& random) {
    return random.normal(spread.mean, spread.sd);
}

}  // namespace deixis::motion
