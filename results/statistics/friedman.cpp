#include "results/statistics/friedman.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <cstdint>

#include "midranks.hpp"

namespace deixis::results {

FriedmanTest friedmanTest(std::span<const std::vector<Rational>> rows) {
    FriedmanTest test;
    test.n = static_cast<int>(rows.size());
    if (rows.empty()) return test;
    const std::size_t k = rows.front().size();
    test.k = static_cast<int>(k);
    test.df = test.k - 1;
    std::vector<std::int64_t> doubled_sums(k, 0);
    std::int64_t tie_term = 0;  // of t^3 - t
    for (const std::vector<Rational>& row : rows) {
        const Midranks ranks = midranks(row);
        test.ties += static_cast<int>(ranks.tie_sizes.size());
        for (const std::int64_t t : ranks.tie_sizes) tie_term += t * t * t - t;
        for (std::size_t j = 0; j < k; ++j) doubled_sums[j] += ranks.doubled[j];
    }
    const double n = test.n;
    const double levels = test.k;
    double squares = 0.0;
    for (const std::int64_t sum : doubled_sums) {
        test.mean_ranks.push_back(static_cast<double>(sum) / (2.0 * n));
        const double from_mean = static_cast<double>(sum - std::int64_t{test.n} * (test.k + 1)) / 2.0;
        squares += from_mean * from_mean;
    }
    // Four quarters: whole numbers until the division.
    const double spread = n * levels * (levels + 1.0) * (levels - 1.0) - static_cast<double>(tie_term);
    if (spread == 0.0) return test;
    test.chi2 = 12.0 * squares * (levels - 1.0) / spread;
    test.p = boost::math::cdf(
        boost::math::complement(boost::math::chi_squared(static_cast<double>(test.df)), *test.chi2));
    test.kendalls_w = 12.0 * squares / (spread * n);

    ImanDavenport& f = test.iman_davenport;
    f.df1 = test.df;
    f.df2 = test.df * (test.n - 1);
    if (test.n < 2) return test;
    const double rest = spread * n - 12.0 * squares;  // whole: 0 exactly where all rank alike
    if (rest <= 0.0) {
        f.p = 0.0;
        return test;
    }
    f.f = (n - 1.0) * 12.0 * squares / rest;
    f.p = boost::math::cdf(boost::math::complement(
        boost::math::fisher_f(static_cast<double>(f.df1), static_cast<double>(f.df2)), *f.f));
    return test;
}

}  // namespace deixis::results
