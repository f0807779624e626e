// A proportion with its exact interval and its exact test against chance.
#pragma once

#include <cstdint>
#include <optional>

namespace deixis::results {

/// Answers count as independent: clustering by participant or item is ignored.
struct Proportion {
    std::int64_t successes = 0;
    std::int64_t n = 0;
    std::optional<double> estimate{};  ///< none where n is 0; so for all below
    std::optional<double> lower{};     ///< Clopper & Pearson (1934)
    std::optional<double> upper{};
    /// Exact binomial test, two-sided: the probability of all counts that are no more likely than the one
    /// found, as R's binom.test. None without a chance level.
    std::optional<double> p_chance{};
    std::optional<double> p_greater{};  ///< P(X >= successes) at chance
    std::optional<double> p_less{};     ///< P(X <= successes)
};

/// 0 <= successes <= n; 0 < level < 1; 0 < chance < 1.
[[nodiscard]] Proportion proportion(std::int64_t successes, std::int64_t n, double level,
                                    std::optional<double> chance);

}  // namespace deixis::results
