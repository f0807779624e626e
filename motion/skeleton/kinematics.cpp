#include "motion/skeleton/kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace deixis::motion {

namespace {

double squared(const Vec3& v) {
    return glm::dot(v, v);
}

}  // namespace

std::vector<Vec3> velocities(const std::vector<Vec3>& positions, double frame_time_s) {
    std::vector<Vec3> out(positions.size(), Vec3(0.0));
    if (positions.size() < 2) return out;
    const auto last = static_cast<std::ptrdiff_t>(positions.size()) - 1;
    const auto half = static_cast<std::ptrdiff_t>(
        std::max(1.0, std::min(std::round(difference_half_span_s / frame_time_s), 1e6)));
    for (std::ptrdiff_t i = 0; i <= last; ++i) {
        const std::ptrdiff_t before = std::max<std::ptrdiff_t>(0, i - half);
        const std::ptrdiff_t after = std::min(last, i + half);
        out[static_cast<std::size_t>(i)] =
            (positions[static_cast<std::size_t>(after)] - positions[static_cast<std::size_t>(before)]) /
            (frame_time_s * static_cast<double>(after - before));
    }
    return out;
}

std::vector<double> speeds(const std::vector<Vec3>& positions, double frame_time_s) {
    std::vector<double> out;
    out.reserve(positions.size());
    for (const Vec3& v : velocities(positions, frame_time_s)) out.push_back(glm::length(v));
    return out;
}

double upperMedian(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::optional<double> logDimensionlessJerk(const std::vector<Vec3>& positions, double frame_time_s) {
    const std::size_t n = positions.size();
    if (n < 4) return std::nullopt;
    double fastest = 0.0;
    for (std::size_t i = 1; i < n; ++i)
        fastest = std::max(fastest, glm::length(positions[i] - positions[i - 1]) / frame_time_s);
    double cost = 0.0;
    for (std::size_t i = 3; i < n; ++i)
        cost += squared(positions[i] - 3.0 * positions[i - 1] + 3.0 * positions[i - 2] - positions[i - 3]);
    cost *= frame_time_s / std::pow(frame_time_s, 6);
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
