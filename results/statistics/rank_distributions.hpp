// Null distributions of rank sums, by dynamic programming over the observed ranks. Only sums of positive
// numbers occur, so every probability has a relative error below 1e-12, in the far tails too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace deixis::results {

struct TailProbability {
    double lower_tail = 1.0;  ///< P(W <= w)
    double at = 1.0;          ///< P(W = w)

    [[nodiscard]] double upperTail() const { return 1.0 - lower_tail + at; }  ///< P(W >= w)
};

inline constexpr std::size_t signed_rank_exact_limit = 2000;
inline constexpr std::size_t rank_sum_exact_limit = 400;

/// W is the sum of those `ranks` (positive; at most 2,000) whose sign turns out positive; each sign has
/// probability one half. `w` is at most half of their sum.
[[nodiscard]] TailProbability signedRankTail(std::vector<std::int64_t> ranks, std::int64_t w);

/// W is the sum of `chosen` of the `ranks` (at most 400), each subset of that size being equally likely.
/// 1 <= chosen <= half of them.
[[nodiscard]] TailProbability rankSumTail(std::vector<std::int64_t> ranks, std::size_t chosen,
                                          std::int64_t w);

}  // namespace deixis::results
