#include "rank_sums.hpp"

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>
#include <utility>

#include "rank_distributions.hpp"

namespace deixis::results {

SignedRankSums::SignedRankSums(std::vector<std::int64_t> doubled, const std::vector<bool>& positive)
    : doubled_(std::move(doubled)) {
    for (std::size_t i = 0; i < doubled_.size(); ++i)
        (positive[i] ? doubled_plus_ : doubled_minus_) += doubled_[i];
}

RankTails SignedRankSums::exact() const {
    // The distribution is symmetric: both tails follow from the smaller sum's.
    const TailProbability tail = signedRankTail(doubled_, std::min(doubled_plus_, doubled_minus_));
    if (doubled_plus_ <= doubled_minus_) return {tail.at_most, tail.atLeast()};
    return {tail.atLeast(), tail.at_most};
}

double SignedRankSums::standardised(double shift) const {
    double squares = 0.0;
    for (const std::int64_t rank : doubled_) squares += static_cast<double>(rank) * static_cast<double>(rank);
    const double from_mean = static_cast<double>(doubled_plus_ - doubled_minus_) / 4.0;
    return (from_mean + shift) / (std::sqrt(squares) / 4.0);
}

RankTails SignedRankSums::approximate() const {
    const boost::math::normal normal;
    return {boost::math::cdf(normal, standardised(0.5)),
            boost::math::cdf(boost::math::complement(normal, standardised(-0.5)))};
}

RankTails SignedRankSums::tails() const {
    if (doubled_.empty()) return {};
    return doubled_.size() <= signed_rank_exact_limit ? exact() : approximate();
}

double SignedRankSums::z() const {
    if (doubled_plus_ == doubled_minus_) return 0.0;
    return standardised(doubled_plus_ > doubled_minus_ ? -0.5 : 0.5);
}

namespace {

/// P(W <= w) and P(W >= w) of the sum of `chosen` of the ranks.
RankTails exactSubsetTails(const std::vector<std::int64_t>& ranks, std::size_t chosen, std::int64_t w) {
    const auto total = std::accumulate(ranks.begin(), ranks.end(), std::int64_t{0});
    // The rank sum of those not chosen is the rest: the smaller sample is the one to count.
    if (2 * chosen > ranks.size()) {
        const RankTails others = exactSubsetTails(ranks, ranks.size() - chosen, total - w);
        return {others.at_least, others.at_most};
    }
    const auto all = static_cast<std::int64_t>(ranks.size());
    const auto part = static_cast<std::int64_t>(chosen);
    if (w * all <= total * part) {
        const TailProbability tail = rankSumTail(ranks, chosen, w);
        return {tail.at_most, tail.atLeast()};
    }
    // The upper tail is the lower one of the ranks counted from above.
    const std::int64_t turn = 2 * (all + 1);
    std::vector<std::int64_t> turned = ranks;
    for (std::int64_t& rank : turned) rank = turn - rank;
    const TailProbability tail = rankSumTail(turned, chosen, part * turn - w);
    return {tail.atLeast(), tail.at_most};
}

}  // namespace

RankTails rankSumTails(const std::vector<std::int64_t>& doubled, std::size_t n_a) {
    const auto split = doubled.begin() + static_cast<std::ptrdiff_t>(n_a);
    const auto doubled_w = std::accumulate(doubled.begin(), split, std::int64_t{0});
    if (doubled.size() <= rank_sum_exact_limit) return exactSubsetTails(doubled, n_a, doubled_w);
    const auto n = static_cast<double>(doubled.size());
    const auto a = static_cast<double>(n_a);
    const double mean = n + 1.0;  // of the doubled ranks
    double squares = 0.0;
    for (const std::int64_t rank : doubled) squares += std::pow(static_cast<double>(rank) - mean, 2);
    // Of a sum of n_a ranks that are drawn without putting back; ties are in the ranks' own variance.
    const double sd = std::sqrt(a * (n - a) / (n * (n - 1.0)) * squares) / 2.0;
    if (sd == 0.0) return {};
    const double from_mean = static_cast<double>(doubled_w) / 2.0 - a * (n + 1.0) / 2.0;
    const boost::math::normal normal;
    return {boost::math::cdf(normal, (from_mean + 0.5) / sd),
            boost::math::cdf(boost::math::complement(normal, (from_mean - 0.5) / sd))};
}

}  // namespace deixis::results
