// From a normally distributed variable to an answer: how a choice of the game, or a step on a scale,
// depends on it. Shared by power analysis and the estimation of its effects.
#pragma once

#include <optional>
#include <span>

namespace deixis::studies {

/// What lies behind an answer is normal with a location and an SD: for a choice on the logit scale, for a
/// rating on the measure's own scale. All numbers are sums over fixed points or of normal probabilities, so
/// the same on every machine up to its exp and erfc.
class AnswerCurve {
  public:
    /// Right (1) with the logistic of what lies behind; `lapse_rate` of the choices fall on any of `balls`.
    [[nodiscard]] static AnswerCurve choice(double lapse_rate, int balls);
    /// The nearest step from `low` to `high`.
    [[nodiscard]] static AnswerCurve scale(int low, int high);

    [[nodiscard]] double low() const { return low_; }    ///< no expected answer is at or below it
    [[nodiscard]] double high() const { return high_; }  ///< or at or above it
    /// The expected answer. SD 0: of a scale the step itself.
    [[nodiscard]] double mean(double location, double sd) const;
    /// The variance of one answer.
    [[nodiscard]] double variance(double location, double sd) const;
    /// The covariance of two answers that share a part of what lies behind them, of SD `shared`, out of `sd`.
    [[nodiscard]] double covariance(double location, double sd, double shared) const;
    /// The location, to which each of `shifts` is added in turn, at which the mean over them is `expected`.
    /// None if that lies outside (low(), high()). `sd` must be above 0 for a scale.
    [[nodiscard]] std::optional<double> location(double expected, double sd,
                                                 std::span<const double> shifts) const;

    /// The probability that a choice is right, given what lies behind it.
    [[nodiscard]] double chance(double behind) const;
    /// The step that a rating is given.
    [[nodiscard]] double step(double behind) const;

  private:
    AnswerCurve(bool is_choice, double low, double high) : is_choice_(is_choice), low_(low), high_(high) {}

    bool is_choice_;
    double low_;
    double high_;
};

/// From the difference of two strengths to the answer to a pair, 2 (clearly the first) to -2: what lies
/// behind is normal with a location and an SD above 0, and cut at the zones.
struct PreferenceCurve {
    double tie_zone = 0.0;    ///< a difference no larger is no preference
    double clear_zone = 0.0;  ///< one no larger is a slight one; at least tie_zone

    [[nodiscard]] double answer(double behind) const;
    /// The probability of an answer from -2 to 2.
    [[nodiscard]] double probability(int answer, double location, double sd) const;
    [[nodiscard]] double mean(double location, double sd) const;
    /// The covariance of two answers at these locations that share a part of what lies behind them, of SD
    /// `shared`, out of `sd`.
    [[nodiscard]] double covariance(double first_location, double second_location, double sd,
                                    double shared) const;
};

}  // namespace deixis::studies
