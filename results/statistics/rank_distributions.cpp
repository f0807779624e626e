#include "rank_distributions.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>
#include <utility>

namespace deixis::results {

namespace {

/// out[i] += in[i]; the two do not overlap.
void addTo(double* __restrict out, const double* __restrict in, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) out[i] += in[i];
}

/// counts[k] += counts[k - shift] for k from `first` to `last`, all at once: from above, in blocks that do
/// not overlap their sources.
void addShifted(std::vector<double>& counts, std::int64_t first, std::int64_t last, std::int64_t shift) {
    constexpr std::int64_t longest_block = 2048;
    const std::int64_t block = std::min(shift, longest_block);
    for (std::int64_t end = last + 1; end > first;) {
        const std::int64_t begin = std::max(first, end - block);
        addTo(counts.data() + begin, counts.data() + (begin - shift), end - begin);
        end = begin;
    }
}

/// How many of the 2^n sign patterns give each sum from `low` to w, times 2^exponent.
struct SignCounts {
    std::vector<double> counts;
    std::int64_t low = 0;
    int exponent = 0;
    double left_out = 0.0;  ///< bound on the probability that was left out of any lower tail
};

/// The distribution is symmetric at every stage, so only its lower half is kept. Of that, the far end is
/// left out as long as no more than the probability `to_spare` is lost with it.
SignCounts countSigns(const std::vector<std::int64_t>& ranks, std::int64_t w, double to_spare) {
    SignCounts out;
    const auto n = static_cast<int>(ranks.size());
    // 2^2000 patterns do not fit a double; 2^-1000 to 2^1000 do.
    const int start = n > 1000 ? -1000 : 0;
    out.exponent = -n - start;
    out.counts.assign(static_cast<std::size_t>(w) + 1, 0.0);
    auto& counts = out.counts;
    counts[0] = std::ldexp(1.0, start);
    std::int64_t sum = 0;
    std::int64_t top = 0;
    for (int step = 1; step <= n; ++step) {
        const std::int64_t rank = ranks[static_cast<std::size_t>(step - 1)];
        const std::int64_t new_top = std::min(w, (sum + rank) / 2);
        for (std::int64_t k = top + 1; k <= std::min(new_top, sum - out.low); ++k)
            counts[static_cast<std::size_t>(k)] = counts[static_cast<std::size_t>(sum - k)];
        addShifted(counts, out.low + rank, new_top, rank);
        sum += rank;
        top = new_top;
        const double spare = to_spare * step / n;
        while (out.low < top) {
            // What is left out below is also missing from its mirror image.
            const double lost = 2.0 * std::ldexp(counts[static_cast<std::size_t>(out.low)], -step - start);
            if (out.left_out + lost > spare) break;
            out.left_out += lost;
            counts[static_cast<std::size_t>(out.low)] = 0.0;
            ++out.low;
        }
    }
    return out;
}

/// Divides all by their greatest common divisor, and sorts them; returns the divisor.
std::int64_t reduce(std::vector<std::int64_t>& ranks) {
    std::int64_t divisor = 0;
    for (const std::int64_t rank : ranks) divisor = std::gcd(divisor, rank);
    for (std::int64_t& rank : ranks) rank /= divisor;
    std::sort(ranks.begin(), ranks.end());
    return divisor;
}

double normalTail(double z) {
    return boost::math::cdf(boost::math::normal(), z);
}

/// For each total excess over the smallest possible sum, how many subsets of `chosen` give it, up to `max`.
std::vector<double> countSubsets(const std::vector<std::int64_t>& sorted, std::size_t chosen,
                                 std::int64_t max) {
    const std::size_t n = sorted.size();
    // counts[j]: of subsets of j so far. The j-th chosen (in order) exceeds the j-th smallest by its share.
    std::vector<std::vector<double>> counts(chosen + 1);
    for (auto& row : counts) row.assign(static_cast<std::size_t>(max) + 1, 0.0);
    std::vector<std::int64_t> tops(chosen + 1, -1);  // the largest excess that occurs
    counts[0][0] = 1.0;
    tops[0] = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t still_to_come = n - 1 - i;
        const std::size_t min = chosen > still_to_come ? chosen - still_to_come : 1;
        for (std::size_t j = std::min(chosen, i + 1); j >= std::max<std::size_t>(min, 1); --j) {
            const std::int64_t excess = sorted[i] - sorted[j - 1];
            const std::int64_t top = std::min(max, tops[j - 1] + excess);
            if (tops[j - 1] < 0 || excess > max) continue;
            addTo(counts[j].data() + excess, counts[j - 1].data(), top - excess + 1);
            tops[j] = std::max(tops[j], top);
        }
    }
    return std::move(counts[chosen]);
}

/// n choose k; exact while below 2^53.
double subsets(std::size_t n, std::size_t k) {
    double out = 1.0;
    for (std::size_t i = 1; i <= k; ++i) out = out * static_cast<double>(n - k + i) / static_cast<double>(i);
    return out;
}

}  // namespace

TailProbability signedRankTail(std::vector<std::int64_t> ranks, std::int64_t w) {
    if (ranks.empty() || w < 0) return {w < 0 ? 0.0 : 1.0, w < 0 ? 0.0 : 1.0};
    w /= reduce(ranks);
    double squares = 0.0;
    double half = 0.0;
    for (const std::int64_t rank : ranks) {
        squares += static_cast<double>(rank) * static_cast<double>(rank);
        half += 0.5 * static_cast<double>(rank);
    }
    // A guess says how much may be left out; what comes out tells whether it was too much.
    double guess = 0.01 * normalTail((static_cast<double>(w) - half) / (0.5 * std::sqrt(squares)));
    for (;;) {
        const SignCounts counted = countSigns(ranks, w, 1e-15 * guess);
        const double sum = std::accumulate(counted.counts.begin() + counted.low, counted.counts.end(), 0.0);
        TailProbability tail;
        tail.lower_tail = std::ldexp(sum, counted.exponent);
        tail.at = std::ldexp(counted.counts.back(), counted.exponent);
        if (counted.left_out <= 1e-14 * tail.lower_tail || guess == 0.0) return tail;
        guess = std::min(tail.lower_tail, 0.01 * guess);
    }
}

TailProbability rankSumTail(std::vector<std::int64_t> ranks, std::size_t chosen, std::int64_t w) {
    std::sort(ranks.begin(), ranks.end());
    const auto split = ranks.begin() + static_cast<std::ptrdiff_t>(chosen);
    const std::int64_t excess = w - std::accumulate(ranks.begin(), split, std::int64_t{0});
    const std::int64_t min = ranks.front();
    std::int64_t divisor = 0;
    for (const std::int64_t rank : ranks) divisor = std::gcd(divisor, rank - min);
    if (excess < 0) return {0.0, 0.0};
    if (divisor == 0) return {};
    for (std::int64_t& rank : ranks) rank = (rank - min) / divisor;
    const auto counts = countSubsets(ranks, chosen, excess / divisor);
    const double all = subsets(ranks.size(), chosen);
    TailProbability tail;
    tail.lower_tail = std::min(1.0, std::accumulate(counts.begin(), counts.end(), 0.0) / all);
    tail.at = counts.back() / all;
    return tail;
}

}  // namespace deixis::results
