#include "studies/study_file/answer_curve.hpp"

#include <algorithm>
#include <boost/math/quadrature/trapezoidal.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>

#include "core/normal_probability.hpp"
#include "core/pose.hpp"

namespace deixis::studies {

namespace {

/// The expected value of a function of a standard normal number. The trapezoid rule is exact to many digits
/// for smooth functions that die away at both ends.
template <typename Function>
double overNormal(Function function) {
    constexpr double farthest = 8.0;
    constexpr double tolerance = 1e-10;
    const double weight = 1.0 / std::sqrt(2.0 * pi);
    return boost::math::quadrature::trapezoidal(
        [&](double z) { return weight * std::exp(-0.5 * z * z) * function(z); }, -farthest, farthest,
        tolerance);
}

}  // namespace

AnswerCurve AnswerCurve::choice(double lapse_rate, int balls) {
    const double by_chance = lapse_rate / std::max(1, balls);
    return {true, by_chance, by_chance + 1.0 - lapse_rate};
}

AnswerCurve AnswerCurve::scale(int low, int high) {
    return {false, static_cast<double>(low), static_cast<double>(high)};
}

double AnswerCurve::chance(double behind) const {
    return low_ + (high_ - low_) / (1.0 + std::exp(-behind));
}

double AnswerCurve::step(double behind) const {
    return std::floor(std::clamp(behind, low_, high_) + 0.5);
}

double AnswerCurve::mean(double location, double sd) const {
    if (is_choice_) return overNormal([&](double z) { return chance(location + sd * z); });
    if (sd <= 0.0) return step(location);
    double out = low_;
    for (double k = low_; k < high_; k += 1.0) out += normalBelow((location - k - 0.5) / sd);
    return out;
}

double AnswerCurve::variance(double location, double sd) const {
    const double expected = mean(location, sd);
    if (is_choice_) return expected * (1.0 - expected);
    if (sd <= 0.0) return 0.0;
    double squares = low_ * low_;
    for (double k = low_; k < high_; k += 1.0)
        squares += (2.0 * k + 1.0) * normalBelow((location - k - 0.5) / sd);
    return squares - expected * expected;
}

double AnswerCurve::covariance(double location, double sd, double shared) const {
    const double rest = std::sqrt(std::max(0.0, sd * sd - shared * shared));
    const double expected = mean(location, sd);
    return overNormal([&](double z) {
        const double off = mean(location + shared * z, rest) - expected;
        return off * off;
    });
}

std::optional<double> AnswerCurve::location(double expected, double sd,
                                            std::span<const double> shifts) const {
    if (!(expected > low_ && expected < high_)) return std::nullopt;
    double reach = 50.0 + 50.0 * sd;
    for (const double shift : shifts) reach = std::max(reach, 50.0 + 50.0 * sd + std::abs(shift));
    // By signs alone: without an SD the mean is a stair, and the first place that is high enough is sought.
    const auto side = [&](double location) {
        double sum = 0.0;
        for (const double shift : shifts) sum += mean(location + shift, sd);
        return sum / static_cast<double>(shifts.size()) < expected ? -1.0 : 1.0;
    };
    const auto [below, above] = boost::math::tools::bisect(
        side, low_ - reach, high_ + reach,
        boost::math::tools::eps_tolerance<double>(std::numeric_limits<double>::digits));
    return 0.5 * (below + above);
}

double PreferenceCurve::answer(double behind) const {
    const double size = std::abs(behind);
    const double clear = size <= tie_zone ? 0.0 : size <= clear_zone ? 1.0 : 2.0;
    return behind < 0.0 ? -clear : clear;
}

double PreferenceCurve::probability(int answer, double location, double sd) const {
    if (answer < 0) return probability(-answer, -location, sd);
    if (answer == 2) return normalBelow((location - clear_zone) / sd);
    const double above_tie = normalBelow((location - tie_zone) / sd);
    if (answer == 1) return above_tie - normalBelow((location - clear_zone) / sd);
    return normalBelow((location + tie_zone) / sd) - above_tie;
}

double PreferenceCurve::mean(double location, double sd) const {
    double out = -2.0;
    for (const double cut : {-clear_zone, -tie_zone, tie_zone, clear_zone})
        out += normalBelow((location - cut) / sd);
    return out;
}

double PreferenceCurve::covariance(double first_location, double second_location, double sd,
                                   double shared) const {
    const double rest = std::sqrt(std::max(0.0, sd * sd - shared * shared));
    const double first = mean(first_location, sd);
    const double second = mean(second_location, sd);
    return overNormal([&](double z) {
        return (mean(first_location + shared * z, rest) - first) *
               (mean(second_location + shared * z, rest) - second);
    });
}

}  // namespace deixis::studies
