// A gesture's course as coefficients, aligned by its phases: numbers that can be averaged over gestures of
// different durations. As in probabilistic movement primitives (Paraschos et al. 2013), with B-splines.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "motion/skeleton/gesture_phases.hpp"

namespace deixis::motion {

/// Seconds of rest, raise, hold, retraction and rest.
using PhaseDurations = std::array<double, 5>;

[[nodiscard]] PhaseDurations durationsOf(const GesturePhases& phases, int frame_count, double frame_time_s);

/// A time of a gesture as the time of the same gesture whose hold lasts `hold_s`: the hold played slower or
/// faster.
[[nodiscard]] double withHold(double time_s, const PhaseDurations& durations, double hold_s);

/// Uniform cubic B-splines over the aligned time, in which each phase has its own number of intervals. What
/// they describe is zero at both ends, with its first two derivatives.
class PhaseTrajectory {
  public:
    /// Of each dimension.
    static constexpr std::size_t coefficient_count = 25;
    using Coefficients = std::array<double, coefficient_count>;

    /// Aligned times are from 0 to this.
    static constexpr double whole = 28.0;

    /// Aligned time of a time, seconds from the begin of the gesture's clip.
    [[nodiscard]] static double aligned(double time_s, const PhaseDurations& durations);
    /// How much each coefficient counts at an aligned time.
    [[nodiscard]] static Coefficients basis(double aligned_time);
};

/// The coefficients, dimension after dimension, that fit frames best (least squares; a coefficient about
/// which no frame says anything is 0). `frames`: one entry a frame, each with the same number of dimensions.
[[nodiscard]] std::vector<double> fitTrajectory(const std::vector<std::vector<double>>& frames,
                                                double frame_time_s, const PhaseDurations& durations);
/// The dimensions at an aligned time.
[[nodiscard]] std::vector<double> trajectoryAt(std::span<const double> coefficients, double aligned_time);

}  // namespace deixis::motion
