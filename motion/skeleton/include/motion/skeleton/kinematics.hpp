// Speed, smoothness and steadiness of a point sampled at a constant rate. Pure functions on positions in
// metres; `frame_time_s` is the time between samples, above 0.
#pragma once

#include <optional>
#include <vector>

#include "core/pose.hpp"

namespace deixis::motion {

/// Half the span of the central differences below. Their low-pass (a moving average of the velocity) has its
/// first zero at 15 Hz, so no other filter is used; the same span at every frame rate makes measures of the
/// same movement at different rates comparable.
constexpr double difference_half_span_s = 1.0 / 30.0;

/// Velocity at every sample, m/s: (p(t + h) - p(t - h)) / 2h with h the whole number of samples nearest to
/// difference_half_span_s, at least one; towards the ends the span is cut off there. All zero for one sample.
[[nodiscard]] std::vector<Vec3> velocities(const std::vector<Vec3>& positions, double frame_time_s);
[[nodiscard]] std::vector<double> speeds(const std::vector<Vec3>& positions, double frame_time_s);

/// The median, of two in the middle the greater one, so that it is a value that was there. Of one value or
/// more.
[[nodiscard]] double upperMedian(std::vector<double> values);

/// Log dimensionless jerk (Balasubramanian, Melendez-Calderon, Roby-Brami & Burdet 2015, "On the analysis of
/// movement smoothness", J. NeuroEng. Rehabil. 12:112): -ln(T^3 / v_peak^2 * integral of |jerk|^2 dt), with
/// plain differences from sample to sample. Dimensionless, below 0; nearer to 0 is smoother. A minimum-jerk
/// movement has -ln(204.8) = -5.322. None for fewer than 4 samples or where nothing moves.
[[nodiscard]] std::optional<double> logDimensionlessJerk(const std::vector<Vec3>& positions,
                                                         double frame_time_s);

/// SPARC, spectral arc length (the same authors, 2015): minus the length of the curve of the speed's
/// magnitude spectrum, both axes scaled to 1, from 0 Hz to the last frequency of at most 10 Hz (and at most
/// half the sampling rate) at which it reaches 0.05 of its largest value; zero-padded to 2^(ceil(log2 N) +
/// 4). Dimensionless, below 0; nearer to 0 is smoother. Speeds are not negative. None for fewer than 2
/// samples or where nothing moves.
[[nodiscard]] std::optional<double> spectralArcLength(const std::vector<double>& speeds, double frame_time_s);

/// What a point does while it should be still: a straight line through its course by least squares.
struct Steadiness {
    double drift_per_s = 0.0;  ///< length of the line's slope
    double jitter_rms = 0.0;   ///< root mean square of the distance from the line
};
/// In metres. None for fewer than 3 samples.
[[nodiscard]] std::optional<Steadiness> steadiness(const std::vector<Vec3>& positions, double frame_time_s);
/// The same for directions of unit length, in radians, in the plane that touches the sphere at their mean.
[[nodiscard]] std::optional<Steadiness> directionSteadiness(const std::vector<Vec3>& directions,
                                                            double frame_time_s);

}  // namespace deixis::motion
