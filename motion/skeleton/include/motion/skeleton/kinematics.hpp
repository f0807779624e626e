// How a point moves that was sampled over time: velocity, derivatives, smoothness, steadiness. Pure functions
// on positions in metres; `frame_time_s` is the time from one sample to the next, above 0.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/pose.hpp"

namespace deixis::motion {

/// The whole number of frames nearest to a time, at least 1 and at most a million.
[[nodiscard]] std::size_t framesIn(double time_s, double frame_time_s);

/// The times before and after a sample between which its velocity is taken, in whole frames as by framesIn();
/// 0 is none.
struct VelocitySpan {
    double before_s = 0.0;
    double after_s = 0.0;
};
/// Central differences over a fifteenth of a second. Their low-pass (a moving average of the velocity) has
/// its first zero at 15 Hz, so no other filter is used; the same span at every frame rate makes measures of
/// the same movement at different rates comparable.
constexpr VelocitySpan central_span{1.0 / 30.0, 1.0 / 30.0};

/// Velocity at every sample, m/s: the difference of the positions at both ends of the span, over its time;
/// towards the ends of the samples the span is cut off there. Zero where it is empty.
[[nodiscard]] std::vector<Vec3> velocities(const std::vector<Vec3>& positions, double frame_time_s,
                                           VelocitySpan span = central_span);
[[nodiscard]] std::vector<double> speeds(const std::vector<Vec3>& positions, double frame_time_s,
                                         VelocitySpan span = central_span);
/// Of samples at times of their own, as many as positions and rising: from the sample before, m/s; 0 for the
/// first, and where no time has passed.
[[nodiscard]] std::vector<double> speedsAt(std::span<const double> times_s,
                                           const std::vector<Vec3>& positions);

enum class Derivative : unsigned char { speed, acceleration, jerk };
constexpr std::size_t derivative_count = 3;

/// Magnitudes of a derivative by plain differences from sample to sample, in m/s, m/s^2 or m/s^3: 1, 2 or 3
/// fewer than there are samples.
[[nodiscard]] std::vector<double> magnitudes(const std::vector<Vec3>& positions, double frame_time_s,
                                             Derivative derivative);

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
