#include "motion/skeleton/kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace deixis::motion {

namespace {

double squared(const Vec3& v) {
    return glm::dot(v, v);
}

std::vector<double> lengths(const std::vector<Vec3>& vectors) {
    std::vector<double> out;
    out.reserve(vectors.size());
    for (const Vec3& v : vectors) out.push_back(glm::length(v));
    return out;
}

}  // namespace

std::size_t framesIn(double time_s, double frame_time_s) {
    return static_cast<std::size_t>(std::clamp(std::round(time_s / frame_time_s), 1.0, 1e6));
}

std::vector<Vec3> velocities(const std::vector<Vec3>& positions, double frame_time_s, VelocitySpan span) {
    const auto frames = [&](double time_s) { return time_s > 0.0 ? framesIn(time_s, frame_time_s) : 0; };
    const std::size_t back = frames(span.before_s);
    const std::size_t on = frames(span.after_s);
    std::vector<Vec3> out(positions.size(), Vec3(0.0));
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const std::size_t before = i - std::min(i, back);
        const std::size_t after = std::min(positions.size() - 1, i + on);
        if (after > before)
            out[i] =
                (positions[after] - positions[before]) / (frame_time_s * static_cast<double>(after - before));
    }
    return out;
}

std::vector<double> speeds(const std::vector<Vec3>& positions, double frame_time_s, VelocitySpan span) {
    return lengths(velocities(positions, frame_time_s, span));
}

std::vector<double> speedsAt(std::span<const double> times_s, const std::vector<Vec3>& positions) {
    std::vector<double> out(positions.size(), 0.0);
    for (std::size_t i = 1; i < positions.size(); ++i)
        if (const double passed_s = times_s[i] - times_s[i - 1]; passed_s > 0.0)
            out[i] = glm::length(positions[i] - positions[i - 1]) / passed_s;
    return out;
}

std::vector<double> magnitudes(const std::vector<Vec3>& positions, double frame_time_s,
                               Derivative derivative) {
    std::vector<Vec3> values = positions;
    for (std::size_t order = 0; order <= static_cast<std::size_t>(derivative) && !values.empty(); ++order) {
        for (std::size_t i = 1; i < values.size(); ++i)
            values[i - 1] = (values[i] - values[i - 1]) / frame_time_s;
        values.pop_back();
    }
    return lengths(values);
}

std::optional<double> logDimensionlessJerk(const std::vector<Vec3>& positions, double frame_time_s) {
    const std::size_t n = positions.size();
    if (n < 4) return std::nullopt;
    const std::vector<double> speed = magnitudes(positions, frame_time_s, Derivative::speed);
    const double fastest = *std::max_element(speed.begin(), speed.end());
    double cost = 0.0;
    for (const double jerk : magnitudes(positions, frame_time_s, Derivative::jerk))
        cost += jerk * jerk * frame_time_s;
    if (fastest <= 0.0 || cost <= 0.0) return std::nullopt;
    const double duration = frame_time_s * static_cast<double>(n - 1);
    return -std::log(std::pow(duration, 3) / (fastest * fastest) * cost);
}

std::optional<double> spectralArcLength(const std::vector<double>& speeds, double frame_time_s) {
    constexpr int padding_level = 4;
    constexpr double highest_hz = 10.0;
    constexpr double min_share = 0.05;
    const std::size_t n = speeds.size();
    if (n < 2) return std::nullopt;
    std::size_t length = 1;
    while (length < n) length *= 2;
    length <<= padding_level;
    std::vector<double> cosine(length);
    for (std::size_t i = 0; i < length; ++i)
        cosine[i] = std::cos(2.0 * pi * static_cast<double>(i) / static_cast<double>(length));
    const double step_hz = 1.0 / (frame_time_s * static_cast<double>(length));

    // No value of the spectrum of what is never negative is greater than the one at 0 Hz.
    double max = 0.0;
    for (const double speed : speeds) max += speed;
    if (max <= 0.0) return std::nullopt;
    std::vector<double> magnitude;
    for (std::size_t k = 0; k <= length / 2 && static_cast<double>(k) * step_hz <= highest_hz; ++k) {
        double real = 0.0;
        double imaginary = 0.0;
        std::size_t phase = 0;
        for (const double speed : speeds) {
            real += speed * cosine[phase];
            imaginary += speed * cosine[(phase + length / 4) % length];
            phase = (phase + k) % length;
        }
        magnitude.push_back(std::sqrt(real * real + imaginary * imaginary) / max);
    }
    std::size_t last = magnitude.size() - 1;
    while (magnitude[last] < min_share) --last;
    if (last == 0) return std::nullopt;
    const double step = 1.0 / static_cast<double>(last);
    double arc = 0.0;
    for (std::size_t k = 1; k <= last; ++k) {
        const double rise = magnitude[k] - magnitude[k - 1];
        arc += std::sqrt(step * step + rise * rise);
    }
    return -arc;
}

std::optional<Steadiness> steadiness(const std::vector<Vec3>& positions, double frame_time_s) {
    if (positions.size() < 3) return std::nullopt;
    const auto n = static_cast<double>(positions.size());
    const double middle = 0.5 * (n - 1.0);
    Vec3 mean{0.0};
    for (const Vec3& p : positions) mean += p / n;
    Vec3 slope{0.0};
    double spread = 0.0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const double t = static_cast<double>(i) - middle;
        slope += t * (positions[i] - mean);
        spread += t * t;
    }
    slope /= spread;
    double residual = 0.0;
    for (std::size_t i = 0; i < positions.size(); ++i)
        residual += squared(positions[i] - mean - (static_cast<double>(i) - middle) * slope);
    return Steadiness{glm::length(slope) / frame_time_s, std::sqrt(residual / n)};
}

std::optional<Steadiness> directionSteadiness(const std::vector<Vec3>& directions, double frame_time_s) {
    Vec3 sum{0.0};
    for (const Vec3& d : directions) sum += d;
    if (glm::length(sum) <= 0.0) return std::nullopt;
    const Vec3 mean = glm::normalize(sum);
    std::vector<Vec3> flat;
    flat.reserve(directions.size());
    for (const Vec3& d : directions) {
        const Vec3 sideways = d - glm::dot(d, mean) * mean;
        const double length = glm::length(sideways);
        flat.push_back(length > 0.0 ? angleBetween(d, mean) / length * sideways : Vec3(0.0));
    }
    return steadiness(flat, frame_time_s);
}

}  // namespace deixis::motion
