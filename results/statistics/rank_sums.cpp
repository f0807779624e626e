#include "rank_sums.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>
#include <utility>

#include "rank_distributions.hpp"

namespace deixis::results {

namespace {

const boost::math::normal standard_normal;

/// P(X <= z) of a standardised sum with these cumulants (Hall 1992, section 2.3).
double edgeworth(double z, double skewness, double excess) {
    const double z2 = z * z;
    const double by_skewness = skewness / 6.0 * (z2 - 1.0);
    const double by_excess = excess / 24.0 * z * (z2 - 3.0);
    const double by_both = skewness * skewness / 72.0 * z * (z2 * z2 - 10.0 * z2 + 15.0);
    return std::clamp(boost::math::cdf(standard_normal, z) -
                          boost::math::pdf(standard_normal, z) * (by_skewness + by_excess + by_both),
                      0.0, 1.0);
}

/// Both tails, continuity-corrected by 1/2 of a rank sum.
RankTails expandedTails(double from_mean, double sd, double skewness, double excess) {
    if (sd == 0.0) return {};
    return {edgeworth((from_mean + 0.5) / sd, skewness, excess),
            edgeworth((0.5 - from_mean) / sd, -skewness, excess)};
}

}  // namespace

SignedRankSums::SignedRankSums(std::vector<std::int64_t> doubled, const std::vector<bool>& positive)
    : doubled_(std::move(doubled)) {
    for (std::size_t i = 0; i < doubled_.size(); ++i)
        (positive[i] ? doubled_plus_ : doubled_minus_) += doubled_[i];
}

RankTails SignedRankSums::exact() const {
    // The distribution is symmetric: both tails follow from the smaller sum's.
    const TailProbability tail = signedRankTail(doubled_, std::min(doubled_plus_, doubled_minus_));
    if (doubled_plus_ <= doubled_minus_) return {tail.lower_tail, tail.upperTail()};
    return {tail.upperTail(), tail.lower_tail};
}

double SignedRankSums::standardised(double shift) const {
    double squares = 0.0;
    for (const std::int64_t rank : doubled_) squares += static_cast<double>(rank) * static_cast<double>(rank);
    const double from_mean = static_cast<double>(doubled_plus_ - doubled_minus_) / 4.0;
    return (from_mean + shift) / (std::sqrt(squares) / 4.0);
}

RankTails SignedRankSums::approximate() const {
    return {boost::math::cdf(standard_normal, standardised(0.5)),
            boost::math::cdf(boost::math::complement(standard_normal, standardised(-0.5)))};
}

RankTails SignedRankSums::expanded() const {
    double squares = 0.0;
    double fourths = 0.0;
    for (const std::int64_t rank : doubled_) {
        const double square = static_cast<double>(rank) * static_cast<double>(rank);
        squares += square;
        fourths += square * square;
    }
    if (doubled_.empty()) return {};
    // Of a sum of ranks with random signs: cumulants sum r^2, 0 and -2 sum r^4.
    return expandedTails(static_cast<double>(doubled_plus_ - doubled_minus_) / 4.0, std::sqrt(squares) / 4.0,
                         0.0, -2.0 * fourths / (squares * squares));
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
        return {others.upper_tail, others.lower_tail};
    }
    const auto all = static_cast<std::int64_t>(ranks.size());
    const auto part = static_cast<std::int64_t>(chosen);
    if (w * all <= total * part) {
        const TailProbability tail = rankSumTail(ranks, chosen, w);
        return {tail.lower_tail, tail.upperTail()};
    }
    // The upper tail is the lower one of the ranks counted from above.
    const std::int64_t turn = 2 * (all + 1);
    std::vector<std::int64_t> turned = ranks;
    for (std::int64_t& rank : turned) rank = turn - rank;
    const TailProbability tail = rankSumTail(turned, chosen, part * turn - w);
    return {tail.upperTail(), tail.lower_tail};
}

/// The sum of n_a of the ranks, drawn without putting back; ties are in the ranks' own moments. Its central
/// moments are those of sampling from a finite population (Sukhatme 1938).
struct SubsetSum {
    double from_mean;
    double sd;
    double skewness = 0.0;
    double excess = 0.0;

    SubsetSum(const std::vector<std::int64_t>& doubled, std::size_t n_a, std::int64_t doubled_w) {
        const auto n = static_cast<double>(doubled.size());
        const auto a = static_cast<double>(n_a);
        const double mean = n + 1.0;  // of the doubled ranks
        double second = 0.0;
        double third = 0.0;
        double fourth = 0.0;
        for (const std::int64_t rank : doubled) {
            const double away = static_cast<double>(rank) - mean;
            second += away * away;
            third += away * away * away;
            fourth += away * away * away * away;
        }
        from_mean = static_cast<double>(doubled_w) / 2.0 - a * (n + 1.0) / 2.0;
        const double share = a * (n - a) / (n * (n - 1.0));
        const double variance = share * second;  // of the doubled sum
        sd = std::sqrt(variance) / 2.0;
        if (sd == 0.0 || n < 4.0) return;
        const double third_moment = share * (n - 2.0 * a) / (n - 2.0) * third;
        const double fourth_moment = share / ((n - 2.0) * (n - 3.0)) *
                                     ((n * (n + 1.0) - 6.0 * a * (n - a)) * fourth +
                                      3.0 * (a - 1.0) * (n - a - 1.0) * second * second);
        skewness = third_moment / std::pow(variance, 1.5);
        excess = fourth_moment / (variance * variance) - 3.0;
    }
};

}  // namespace

RankTails rankSumTails(const std::vector<std::int64_t>& doubled, std::size_t n_a) {
    const auto split = doubled.begin() + static_cast<std::ptrdiff_t>(n_a);
    const auto doubled_w = std::accumulate(doubled.begin(), split, std::int64_t{0});
    if (doubled.size() <= rank_sum_exact_limit) return exactSubsetTails(doubled, n_a, doubled_w);
    const SubsetSum sum(doubled, n_a, doubled_w);
    if (sum.sd == 0.0) return {};
    return {boost::math::cdf(standard_normal, (sum.from_mean + 0.5) / sum.sd),
            boost::math::cdf(boost::math::complement(standard_normal, (sum.from_mean - 0.5) / sum.sd))};
}

RankTails expandedRankSumTails(const std::vector<std::int64_t>& doubled, std::size_t n_a) {
    const auto split = doubled.begin() + static_cast<std::ptrdiff_t>(n_a);
    const SubsetSum sum(doubled, n_a, std::accumulate(doubled.begin(), split, std::int64_t{0}));
    return expandedTails(sum.from_mean, sum.sd, sum.skewness, sum.excess);
}

}  // namespace deixis::results
