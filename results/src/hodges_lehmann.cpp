#include "results/hodges_lehmann.hpp"

#include <algorithm>
#include <vector>

#include "rank_distributions.hpp"
#include "scaled_integers.hpp"

namespace deixis::results {

namespace {

/// All pairwise sums of sorted whole numbers, of which the k-th smallest is found without listing them: by
/// bisection over their values, counting in linear time how many lie at or below.
template <typename Int>
class WalshSums {
  public:
    explicit WalshSums(std::vector<Int> values) : values_(std::move(values)) {
        std::sort(values_.begin(), values_.end());
    }
    [[nodiscard]] std::uint64_t size() const { return values_.size() * (values_.size() + 1) / 2; }
    [[nodiscard]] Int least() const { return values_.front() + values_.front(); }
    [[nodiscard]] Int greatest() const { return values_.back() + values_.back(); }
    [[nodiscard]] std::uint64_t countUpTo(const Int& sum) const {
        std::uint64_t count = 0;
        std::size_t end = values_.size();  // of the partners that are small enough
        for (std::size_t i = 0; i < values_.size(); ++i) {
            while (end > i && Int(values_[i] + values_[end - 1]) > sum) --end;
            if (end <= i) break;
            count += end - i;
        }
        return count;
    }

  private:
    std::vector<Int> values_;
};

/// Likewise all differences a_i - b_j.
template <typename Int>
class Differences {
  public:
    Differences(std::vector<Int> a, std::vector<Int> b) : a_(std::move(a)), b_(std::move(b)) {
        std::sort(a_.begin(), a_.end());
        std::sort(b_.begin(), b_.end());
    }
    [[nodiscard]] std::uint64_t size() const { return a_.size() * b_.size(); }
    [[nodiscard]] Int least() const { return a_.front() - b_.back(); }
    [[nodiscard]] Int greatest() const { return a_.back() - b_.front(); }
    [[nodiscard]] std::uint64_t countUpTo(const Int& difference) const {
        std::uint64_t count = 0;
        std::size_t end = 0;  // of the a that are small enough
        for (const Int& b : b_) {
            while (end < a_.size() && Int(a_[end] - b) <= difference) ++end;
            count += end;
        }
        return count;
    }

  private:
    std::vector<Int> a_;
    std::vector<Int> b_;
};

/// The k-th smallest, k from 1.
template <typename Int, typename Sums>
Int select(const Sums& sums, std::uint64_t k) {
    Int low = sums.least();
    Int high = sums.greatest();
    while (low < high) {
        const Int middle = low + Int(high - low) / 2;
        if (sums.countUpTo(middle) >= k)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

/// `unit` is what a sum of one stands for.
template <typename Int, typename Sums>
HodgesLehmann fromSums(const Sums& sums, const Rational& unit, const IntervalRank& rank) {
    const std::uint64_t all = sums.size();
    const auto value = [&](std::uint64_t k) { return ratioOf(widened(select<Int>(sums, k)), 1) * unit; };
    HodgesLehmann out;
    const Rational middle = value((all + 1) / 2);
    out.estimate =
        all % 2 == 1 ? middle.toDouble() : ((middle + value(all / 2 + 1)) * Rational(1, 2)).toDouble();
    out.lower = value(rank.k).toDouble();
    out.upper = value(all + 1 - rank.k).toDouble();
    out.level = rank.level;
    return out;
}

}  // namespace

HodgesLehmann hodgesLehmann(std::span<const Rational> differences, double level) {
    if (differences.empty()) return {};
    const ScaledIntegers scaled = overCommonDenominator(differences);
    const Rational unit = ratioOf(1, scaled.denominator * 2);
    const IntervalRank rank = signedRankInterval(differences.size(), level);
    return std::visit(
        [&]<typename Int>(const std::vector<Int>& values) {
            return fromSums<Int>(WalshSums<Int>(values), unit, rank);
        },
        scaled.numerators);
}

HodgesLehmann hodgesLehmannShift(std::span<const Rational> a, std::span<const Rational> b, double level) {
    if (a.empty() || b.empty()) return {};
    std::vector<Rational> all(a.begin(), a.end());
    all.insert(all.end(), b.begin(), b.end());
    const ScaledIntegers scaled = overCommonDenominator(all);
    const Rational unit = ratioOf(1, scaled.denominator);
    const IntervalRank rank = rankSumInterval(a.size(), b.size(), level);
    return std::visit(
        [&]<typename Int>(const std::vector<Int>& values) {
            const auto split = values.begin() + static_cast<std::ptrdiff_t>(a.size());
            return fromSums<Int>(Differences<Int>({values.begin(), split}, {split, values.end()}), unit,
                                 rank);
        },
        scaled.numerators);
}

}  // namespace deixis::results
