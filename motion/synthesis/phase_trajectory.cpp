#include "motion/synthesis/phase_trajectory.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace deixis::motion {

namespace {

constexpr std::array<double, 5> intervals{3.0, 8.0, 6.0, 8.0, 3.0};
constexpr double whole = PhaseTrajectory::whole;
/// Splines that reach over an end, left out: those of which the value and two derivatives there are made.
constexpr std::size_t left_out = 3;
static_assert(PhaseTrajectory::coefficient_count == static_cast<std::size_t>(whole) + 3 - 2 * left_out);

/// The uniform cubic B-spline about 0, which reaches from -2 to 2.
double spline(double x) {
    const double far = std::abs(x);
    if (far >= 2.0) return 0.0;
    if (far >= 1.0) return (2.0 - far) * (2.0 - far) * (2.0 - far) / 6.0;
    return 2.0 / 3.0 - far * far + 0.5 * far * far * far;
}

}  // namespace

PhaseDurations durationsOf(const GesturePhases& phases, int frame_count, double frame_time_s) {
    const std::array<int, 6> borders{
        0, phases.onset_frame, phases.peak_frame, phases.hold_frame, phases.end_frame, frame_count - 1};
    PhaseDurations out{};
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = frame_time_s * std::max(1, borders[i + 1] - borders[i]);
    return out;
}

double withHold(double time_s, const PhaseDurations& durations, double hold_s) {
    const double begin_s = durations[0] + durations[1];
    if (time_s <= begin_s) return time_s;
    if (time_s >= begin_s + durations[2]) return time_s - durations[2] + hold_s;
    return begin_s + (time_s - begin_s) * hold_s / durations[2];
}

double PhaseTrajectory::aligned(double time_s, const PhaseDurations& durations) {
    double begin = 0.0;
    for (std::size_t i = 0; i < durations.size(); ++i) {
        if (time_s < durations[i]) return begin + intervals[i] * std::max(0.0, time_s) / durations[i];
        time_s -= durations[i];
        begin += intervals[i];
    }
    return whole;
}

PhaseTrajectory::Coefficients PhaseTrajectory::basis(double aligned_time) {
    Coefficients out{};
    // Spline 0 of all is centred at -1.
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = spline(aligned_time - (static_cast<double>(i + left_out) - 1.0));
    return out;
}

std::vector<double> fitTrajectory(const std::vector<std::vector<double>>& frames, double frame_time_s,
                                  const PhaseDurations& durations) {
    constexpr int n = PhaseTrajectory::coefficient_count;
    constexpr double ridge = 1e-6;
    const auto dimensions = static_cast<Eigen::Index>(frames.front().size());
    Eigen::MatrixXd normal = ridge * Eigen::MatrixXd::Identity(n, n);
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, dimensions);
    for (std::size_t f = 0; f < frames.size(); ++f) {
        const auto coefficients = PhaseTrajectory::basis(
            PhaseTrajectory::aligned(static_cast<double>(f) * frame_time_s, durations));
        const auto basis = Eigen::Matrix<double, n, 1>::Map(coefficients.data());
        normal += basis * basis.transpose();
        right += basis * Eigen::RowVectorXd::Map(frames[f].data(), dimensions);
    }
    const Eigen::MatrixXd fitted = normal.llt().solve(right);
    return {fitted.data(), fitted.data() + fitted.size()};  // column by column
}

std::vector<double> trajectoryAt(std::span<const double> coefficients, double aligned_time) {
    constexpr std::size_t n = PhaseTrajectory::coefficient_count;
    const auto basis = PhaseTrajectory::basis(aligned_time);
    std::vector<double> out(coefficients.size() / n, 0.0);
    for (std::size_t d = 0; d < out.size(); ++d)
        out[d] = std::inner_product(basis.begin(), basis.end(),
                                    coefficients.begin() + static_cast<std::ptrdiff_t>(d * n), 0.0);
    return out;
}

}  // namespace deixis::motion
