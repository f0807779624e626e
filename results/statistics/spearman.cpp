#include "results/statistics/spearman.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "midranks.hpp"
#include "scaled_integers.hpp"

namespace deixis::results {

namespace {

constexpr std::size_t exact_limit = 9;  // 362,880 pairings

using Ranks = std::vector<std::int64_t>;

std::int64_t productSum(const Ranks& x, const Ranks& y) {
    return std::inner_product(x.begin(), x.end(), y.begin(), std::int64_t{0});
}

/// Shares of the n! pairings whose sum of products is at most, or at least, that found.
void exactTails(const Ranks& x, Ranks y, SpearmanTest& test) {
    const std::int64_t found = productSum(x, y);
    std::int64_t lower_tail = 0;
    std::int64_t upper_tail = 0;
    std::int64_t all = 0;
    // Different orders of equal ranks are the same pairing: each is counted once, all as often as the others.
    std::sort(y.begin(), y.end());
    do {
        const std::int64_t sum = productSum(x, y);
        lower_tail += sum <= found ? 1 : 0;
        upper_tail += sum >= found ? 1 : 0;
        ++all;
    } while (std::next_permutation(y.begin(), y.end()));
    test.p_less = static_cast<double>(lower_tail) / static_cast<double>(all);
    test.p_greater = static_cast<double>(upper_tail) / static_cast<double>(all);
    test.method = "exact";
}

void approximateTails(SpearmanTest& test) {
    test.method = "t";
    if (std::abs(test.rho) == 1.0) {
        test.p_less = test.rho > 0.0 ? 1.0 : 0.0;
        test.p_greater = 1.0 - test.p_less;
        return;
    }
    const double df = test.n - 2;
    const boost::math::students_t distribution(df);
    const double t = test.rho * std::sqrt(df / ((1.0 - test.rho) * (1.0 + test.rho)));
    test.p_less = boost::math::cdf(distribution, t);
    test.p_greater = boost::math::cdf(boost::math::complement(distribution, t));
}

SpearmanTest testRanks(const Ranks& x, const Ranks& y) {
    SpearmanTest test;
    test.n = static_cast<int>(x.size());
    test.method = "undefined";
    // Of doubled ranks, from their common mean n + 1: whole numbers.
    const auto centre = static_cast<std::int64_t>(x.size() + 1);
    Int128 products = 0;
    Int128 squares_x = 0;
    Int128 squares_y = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        products += Int128{x[i] - centre} * (y[i] - centre);
        squares_x += Int128{x[i] - centre} * (x[i] - centre);
        squares_y += Int128{y[i] - centre} * (y[i] - centre);
    }
    if (squares_x == 0 || squares_y == 0) return test;
    if (squares_x == squares_y && (products == squares_x || products == -squares_x)) {
        test.rho = products > 0 ? 1.0 : -1.0;
    } else {
        test.rho = static_cast<double>(products) /
                   std::sqrt(static_cast<double>(squares_x) * static_cast<double>(squares_y));
    }
    if (x.size() <= exact_limit)
        exactTails(x, y, test);
    else
        approximateTails(test);
    test.p = std::min(1.0, 2.0 * std::min(test.p_less, test.p_greater));
    return test;
}

}  // namespace

SpearmanTest spearman(std::span<const double> x, std::span<const double> y) {
    if (x.size() != y.size()) throw std::invalid_argument("spearman: the sides differ in length");
    return testRanks(midranks(x).doubled, midranks(y).doubled);
}

SpearmanTest spearman(std::span<const Rational> x, std::span<const Rational> y) {
    if (x.size() != y.size()) throw std::invalid_argument("spearman: the sides differ in length");
    return testRanks(midranks(x).doubled, midranks(y).doubled);
}

}  // namespace deixis::results
