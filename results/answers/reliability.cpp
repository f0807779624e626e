#include <cmath>

#include "results/answers/data_quality.hpp"

namespace deixis::results {

namespace {

struct Sums {
    double n = 0.0;
    double sum = 0.0;
    double squares = 0.0;

    void add(double x) {
        n += 1.0;
        sum += x;
        squares += x * x;
    }
    /// Of the squared differences of all ordered pairs.
    [[nodiscard]] double pairs() const { return 2.0 * (n * squares - sum * sum); }
    /// Of squares about the mean.
    [[nodiscard]] double about() const { return squares - sum * sum / n; }
};

/// Ratings less the first one: sums of squares then stay small, and equal ratings differ by nothing.
Sums sumsOf(const std::vector<double>& unit, double origin) {
    Sums out;
    for (const double x : unit) out.add(x - origin);
    return out;
}

bool allEqual(const std::vector<std::vector<double>>& units) {
    for (const auto& unit : units)
        for (const double x : unit)
            if (x != units.front().front()) return false;
    return true;
}

}  // namespace

std::optional<double> krippendorffAlpha(const std::vector<std::vector<double>>& units) {
    if (units.size() < 2 || allEqual(units)) return std::nullopt;
    const double origin = units.front().front();
    Sums all;
    double within = 0.0;
    for (const auto& unit : units) {
        within += sumsOf(unit, origin).pairs() / static_cast<double>(unit.size() - 1);
        for (const double x : unit) all.add(x - origin);
    }
    const double observed = within / all.n;
    const double expected = all.pairs() / (all.n * (all.n - 1.0));
    return 1.0 - observed / expected;
}

std::optional<IntraclassCorrelation> intraclassCorrelation(const std::vector<std::vector<double>>& units) {
    if (units.size() < 2 || allEqual(units)) return std::nullopt;
    const double origin = units.front().front();
    Sums all;
    double within = 0.0;
    double squared_sizes = 0.0;
    for (const auto& unit : units) {
        within += sumsOf(unit, origin).about();
        for (const double x : unit) all.add(x - origin);
        squared_sizes += static_cast<double>(unit.size() * unit.size());
    }
    const auto n = static_cast<double>(units.size());
    const double between_square = (all.about() - within) / (n - 1.0);
    const double within_square = within / (all.n - n);
    IntraclassCorrelation out;
    out.k = (all.n - squared_sizes / all.n) / (n - 1.0);
    out.single = (between_square - within_square) / (between_square + (out.k - 1.0) * within_square);
    // Where no unit differs from another, the mean of k agrees worse than any number says.
    if (between_square <= 0.0) return std::nullopt;
    out.mean = (between_square - within_square) / between_square;
    return out;
}

}  // namespace deixis::results
