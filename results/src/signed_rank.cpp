#include "results/signed_rank.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "midranks.hpp"
#include "rank_distributions.hpp"

namespace deixis::results {

namespace {

struct Tails {
    double at_most = 1.0;   ///< P(W+ <= w_plus)
    double at_least = 1.0;  ///< P(W+ >= w_plus)

    [[nodiscard]] double twoSided() const { return std::min(1.0, 2.0 * std::min(at_most, at_least)); }
};

/// The rank sums of one way to rank, and their null distribution.
class RankSums {
  public:
    /// Doubled ranks of the differences other than zero, and whether each is positive.
    RankSums(std::vector<std::int64_t> doubled, const std::vector<bool>& positive)
        : doubled_(std::move(doubled)) {
        for (std::size_t i = 0; i < doubled_.size(); ++i)
            (positive[i] ? doubled_plus_ : doubled_minus_) += doubled_[i];
    }
    [[nodiscard]] double plus() const { return static_cast<double>(doubled_plus_) / 2.0; }
    [[nodiscard]] double minus() const { return static_cast<double>(doubled_minus_) / 2.0; }

    [[nodiscard]] Tails exact() const {
        // The distribution is symmetric: both tails follow from the smaller sum's.
        const TailProbability tail = signedRankTail(doubled_, std::min(doubled_plus_, doubled_minus_));
        if (doubled_plus_ <= doubled_minus_) return {tail.at_most, tail.atLeast()};
        return {tail.atLeast(), tail.at_most};
    }
    /// W+ may be shifted by a continuity correction.
    [[nodiscard]] double standardised(double shift) const {
        double squares = 0.0;
        for (const std::int64_t rank : doubled_)
            squares += static_cast<double>(rank) * static_cast<double>(rank);
        const double from_mean = static_cast<double>(doubled_plus_ - doubled_minus_) / 4.0;
        return (from_mean + shift) / (std::sqrt(squares) / 4.0);
    }
    [[nodiscard]] Tails approximate() const {
        const boost::math::normal normal;
        return {boost::math::cdf(normal, standardised(0.5)),
                boost::math::cdf(boost::math::complement(normal, standardised(-0.5)))};
    }
    [[nodiscard]] Tails tails() const {
        return doubled_.size() <= signed_rank_exact_limit ? exact() : approximate();
    }
    [[nodiscard]] double z() const {
        if (doubled_plus_ == doubled_minus_) return 0.0;
        return standardised(doubled_plus_ > doubled_minus_ ? -0.5 : 0.5);
    }

  private:
    std::vector<std::int64_t> doubled_;
    std::int64_t doubled_plus_ = 0;
    std::int64_t doubled_minus_ = 0;
};

/// Ranks of all magnitudes, zeros too; then those of the zeros go.
std::vector<std::int64_t> prattRanks(const std::vector<std::int64_t>& without_zeros, int n_zero) {
    std::vector<std::int64_t> ranks = without_zeros;
    for (std::int64_t& rank : ranks) rank += 2 * std::int64_t{n_zero};
    return ranks;
}

}  // namespace

SignedRankTest signedRankTest(std::span<const Rational> differences, double level) {
    SignedRankTest test;
    test.n_pairs = static_cast<int>(differences.size());
    test.hodges_lehmann = hodgesLehmann(differences, level);
    std::vector<Rational> magnitudes;
    std::vector<bool> positive;
    for (const Rational& difference : differences) {
        const int sign = difference.sign();
        (sign > 0 ? test.n_positive : sign < 0 ? test.n_negative : test.n_zero) += 1;
        if (sign == 0) continue;
        magnitudes.push_back(abs(difference));
        positive.push_back(sign > 0);
    }
    if (test.n_pairs > 0) test.paired_superiority = (test.n_positive + 0.5 * test.n_zero) / test.n_pairs;
    if (magnitudes.empty()) {
        test.method = "no differences";
        return test;
    }
    const Midranks ranks = midranks(magnitudes);
    test.ties = static_cast<int>(ranks.tie_sizes.size());
    const RankSums sums(ranks.doubled, positive);
    test.w_plus = sums.plus();
    test.w_minus = sums.minus();
    const bool exact = magnitudes.size() <= signed_rank_exact_limit;
    test.method = !exact ? "normal approximation" : test.ties > 0 ? "exact with ties" : "exact";
    const Tails tails = sums.tails();
    test.p_two_sided = tails.twoSided();
    test.p_greater = tails.at_least;
    test.p_less = tails.at_most;
    test.smallest_p = std::ldexp(1.0, 1 - static_cast<int>(magnitudes.size()));

    const RankSums pratt(prattRanks(ranks.doubled, test.n_zero), positive);
    test.pratt_w_plus = pratt.plus();
    test.pratt_p_two_sided = test.n_zero > 0 ? pratt.tails().twoSided() : test.p_two_sided;

    test.z = sums.z();
    test.normal_p_two_sided = std::min(1.0, std::erfc(std::abs(*test.z) / std::sqrt(2.0)));
    test.rank_biserial = (test.w_plus - test.w_minus) / (test.w_plus + test.w_minus);
    return test;
}

}  // namespace deixis::results
