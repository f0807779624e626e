#include "results/statistics/hodges_lehmann.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "rank_sums.hpp"
#include "scaled_integers.hpp"
#include "shift_interval.hpp"

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
    [[nodiscard]] Int min() const { return values_.front() + values_.front(); }
    [[nodiscard]] Int max() const { return values_.back() + values_.back(); }
    [[nodiscard]] const std::vector<Int>& values() const { return values_; }
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
    [[nodiscard]] Int min() const { return a_.front() - b_.back(); }
    [[nodiscard]] Int max() const { return a_.back() - b_.front(); }
    [[nodiscard]] const std::vector<Int>& a() const { return a_; }
    [[nodiscard]] const std::vector<Int>& b() const { return b_; }
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

/// The k-th smallest, k from 1: by halving whole numbers, exactly; counts are a stair, for which root finders
/// are not made.
template <typename Int, typename Sums>
Int select(const Sums& sums, std::uint64_t k) {
    Int low = sums.min();
    Int high = sums.max();
    while (low < high) {
        const Int middle = low + Int(high - low) / 2;
        if (sums.countUpTo(middle) >= k)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

/// The different values among the sums, one after the other.
template <typename Int, typename Sums>
class DifferentSums {
  public:
    explicit DifferentSums(const Sums& sums) : sums_(sums) {}
    [[nodiscard]] Int min() const { return sums_.min(); }
    [[nodiscard]] Int max() const { return sums_.max(); }
    [[nodiscard]] Int before(const Int& sum) const { return select<Int>(sums_, sums_.countUpTo(sum - 1)); }
    [[nodiscard]] Int after(const Int& sum) const { return select<Int>(sums_, sums_.countUpTo(sum) + 1); }

  private:
    const Sums& sums_;
};

/// What is ranked, and among equal values what comes first; doubled midranks in the order of the input.
template <typename Int>
std::vector<std::int64_t> doubledMidranks(const std::vector<std::pair<Int, int>>& keys) {
    std::vector<std::size_t> order(keys.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return keys[i] < keys[j]; });
    std::vector<std::int64_t> ranks(keys.size());
    for (std::size_t first = 0; first < order.size();) {
        std::size_t last = first;
        while (last + 1 < order.size() && keys[order[last + 1]] == keys[order[first]]) ++last;
        for (std::size_t i = first; i <= last; ++i)
            ranks[order[i]] = static_cast<std::int64_t>(first + last + 2);
        first = last + 1;
    }
    return ranks;
}

/// Of larger samples an exact p takes tens of milliseconds, and the ends of an interval ask for several: they
/// are sought with the expansion, which is as good as exact there. Whether 0 is inside is always told by the
/// test's own p.
constexpr std::size_t few_differences = 200;
constexpr std::size_t few_in_both = 60;
constexpr std::size_t enough_in_each = 20;

template <typename Int>
bool isTheTest(const Int& shift, Near near) {
    return shift == 0 && near == Near::at;
}

/// p of the signed-rank test of the values less half the sum `shift`; a hair's breadth beside it, values that
/// lie on it have a sign, and of equal magnitudes those on the side of the shift are the smaller ones.
template <typename Int>
double signedRankP(const std::vector<Int>& values, const Int& shift, Near near) {
    std::vector<std::pair<Int, int>> keys;
    std::vector<bool> positive;
    for (const Int& value : values) {
        const Int twice = Int(value + value) - shift;
        if (near == Near::at && twice == 0) continue;
        const bool above = twice > 0 || (twice == 0 && near == Near::below);
        const bool shrinks = near == Near::above ? above : !above;
        keys.emplace_back(twice < 0 ? Int(-twice) : twice, near == Near::at || shrinks ? 0 : 1);
        positive.push_back(above);
    }
    const SignedRankSums sums(doubledMidranks(keys), positive);
    const bool expands = keys.size() > few_differences;
    return (expands ? sums.expanded() : sums.tails()).twoSided();
}

/// p of the rank-sum test of the values of a less `shift` and those of b; a hair's breadth beside it none of
/// a ties with one of b.
template <typename Int>
double rankSumP(const std::vector<Int>& a, const std::vector<Int>& b, const Int& shift, Near near) {
    std::vector<std::pair<Int, int>> keys;
    const int place_of_a = near == Near::above ? -1 : near == Near::below ? 1 : 0;
    for (const Int& value : a) keys.emplace_back(Int(value - shift), place_of_a);
    for (const Int& value : b) keys.emplace_back(value, 0);
    const bool expands = keys.size() > few_in_both && std::min(a.size(), b.size()) >= enough_in_each;
    const auto ranks = doubledMidranks(keys);
    return (expands ? expandedRankSumTails(ranks, a.size()) : rankSumTails(ranks, a.size())).twoSided();
}

/// So many places further out are looked at for shifts that are not rejected; of larger samples none, since
/// p then falls evenly.
constexpr int max_looks_of_few = 64;

/// About how many places lie below the interval: by the normal approximation of a rank sum without ties.
std::uint64_t startFrom(double centre, double sd, double level) {
    const boost::math::normal normal;
    const double z = boost::math::quantile(boost::math::complement(normal, 0.5 * (1.0 - level)));
    return static_cast<std::uint64_t>(std::max(1.0, std::floor(centre - z * sd + 0.5)));
}

/// `unit` is what a sum of one stands for; `start`: of the places, counted from both sides, near the
/// interval's ends. level 0: no interval.
template <typename Int, typename Sums, typename P>
HodgesLehmann fromSums(const Sums& sums, const Rational& unit, const P& p, std::size_t n, double level,
                       std::uint64_t start) {
    const std::uint64_t all = sums.size();
    const auto value = [&](const Int& sum) { return ratioOf(widened(sum), 1) * unit; };
    HodgesLehmann out;
    const Int middle = select<Int>(sums, (all + 1) / 2);
    const Int next = all % 2 == 1 ? middle : select<Int>(sums, all / 2 + 1);
    out.estimate = ((value(middle) + value(next)) * Rational(1, 2)).toDouble();
    if (level <= 0.0) return out;
    // 1 - level is seldom a double: a p that equals it on paper is rejected.
    const double alpha = (1.0 - level) * (1.0 + 1e-12);
    const auto interval = invertTest<Int>(DifferentSums<Int, Sums>(sums), p, alpha, select<Int>(sums, start),
                                          select<Int>(sums, all + 1 - start), middle,
                                          n <= few_differences ? max_looks_of_few : 0);
    if (!interval) return out;
    out.lower = value(interval->lower).toDouble();
    out.upper = value(interval->upper).toDouble();
    out.lower_included = interval->lower_included;
    out.upper_included = interval->upper_included;
    out.level = 1.0 - interval->outside_p;
    return out;
}

}  // namespace

HodgesLehmann hodgesLehmann(std::span<const Rational> differences, double level, double p) {
    if (differences.empty()) return {};
    const ScaledIntegers scaled = overCommonDenominator(differences);
    const Rational unit = ratioOf(1, scaled.denominator * 2);
    const auto n = static_cast<double>(differences.size());
    const std::uint64_t start =
        startFrom(n * (n + 1.0) / 4.0, std::sqrt(n * (n + 1.0) * (2.0 * n + 1.0) / 24.0), level);
    return std::visit(
        [&]<typename Int>(const std::vector<Int>& values) {
            const WalshSums<Int> sums(values);
            const auto p_of = [&](const Int& shift, Near near) {
                return isTheTest(shift, near) ? p : signedRankP<Int>(sums.values(), shift, near);
            };
            return fromSums<Int>(sums, unit, p_of, values.size(), level, start);
        },
        scaled.numerators);
}

HodgesLehmann hodgesLehmannShift(std::span<const Rational> a, std::span<const Rational> b, double level,
                                 double p) {
    if (a.empty() || b.empty()) return {};
    std::vector<Rational> all(a.begin(), a.end());
    all.insert(all.end(), b.begin(), b.end());
    const ScaledIntegers scaled = overCommonDenominator(all);
    const Rational unit = ratioOf(1, scaled.denominator);
    const auto n_a = static_cast<double>(a.size());
    const auto n_b = static_cast<double>(b.size());
    const std::uint64_t start =
        startFrom(n_a * n_b / 2.0, std::sqrt(n_a * n_b * (n_a + n_b + 1.0) / 12.0), level);
    return std::visit(
        [&]<typename Int>(const std::vector<Int>& values) {
            const auto split = values.begin() + static_cast<std::ptrdiff_t>(a.size());
            const Differences<Int> sums({values.begin(), split}, {split, values.end()});
            const auto p_of = [&](const Int& shift, Near near) {
                return isTheTest(shift, near) ? p : rankSumP<Int>(sums.a(), sums.b(), shift, near);
            };
            return fromSums<Int>(sums, unit, p_of, values.size(), level, start);
        },
        scaled.numerators);
}

}  // namespace deixis::results
