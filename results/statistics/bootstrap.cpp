#include "results/statistics/bootstrap.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstddef>

#include "core/random.hpp"
#include "results/statistics/descriptive.hpp"

namespace deixis::results {

namespace {

/// Values by participant, missing ones as 0, with what counts beside them. Each column stands in the order of
/// its values, the missing ones last: what is drawn does not depend on how participants are called.
struct Table {
    std::size_t participants = 0;
    std::size_t columns = 0;
    bool complete = true;
    std::vector<double> values;
    std::vector<double> counts;  ///< 1, or 0 where the value is missing
};

Table flatten(std::span<const std::vector<double>> rows) {
    Table table;
    table.participants = rows.size();
    table.columns = rows.front().size();
    table.values.assign(table.participants * table.columns, 0.0);
    table.counts.assign(table.participants * table.columns, 0.0);
    std::vector<double> values;
    for (std::size_t c = 0; c < table.columns; ++c) {
        values.clear();
        for (const std::vector<double>& row : rows)
            if (!std::isnan(row[c])) values.push_back(row[c]);
        table.complete = table.complete && values.size() == rows.size();
        std::sort(values.begin(), values.end());
        for (std::size_t i = 0; i < values.size(); ++i) {
            table.values[i * table.columns + c] = values[i];
            table.counts[i * table.columns + c] = 1.0;
        }
    }
    return table;
}

/// The resampled means of each column.
std::vector<std::vector<double>> resample(const Table& table, const BootstrapOptions& options) {
    Random random(options.seed, "bootstrap");
    const std::size_t columns = table.columns;
    std::vector<std::vector<double>> means(columns);
    for (auto& of_column : means) of_column.reserve(static_cast<std::size_t>(options.resamples));
    std::vector<double> sums(columns);
    std::vector<double> counts(columns);
    for (int b = 0; b < options.resamples; ++b) {
        std::fill(sums.begin(), sums.end(), 0.0);
        std::fill(counts.begin(), counts.end(),
                  table.complete ? static_cast<double>(table.participants) : 0.0);
        for (std::size_t drawn = 0; drawn < table.participants; ++drawn) {
            const std::size_t at = random.below(table.participants) * columns;
            for (std::size_t c = 0; c < columns; ++c) sums[c] += table.values[at + c];
            if (table.complete) continue;
            for (std::size_t c = 0; c < columns; ++c) counts[c] += table.counts[at + c];
        }
        for (std::size_t c = 0; c < columns; ++c)
            if (counts[c] > 0.0) means[c].push_back(sums[c] / counts[c]);
    }
    return means;
}

/// How much smaller the mean is without each value than the mean of all such means, but for a factor.
std::vector<double> influencesOnMean(const std::vector<double>& values) {
    const double centre = mean(values);
    std::vector<double> out;
    out.reserve(values.size());
    for (const double value : values) out.push_back(value - centre);
    return out;
}

}  // namespace

double bootstrapAcceleration(std::span<const double> influences) {
    double largest = 0.0;
    for (const double influence : influences) largest = std::max(largest, std::abs(influence));
    if (largest == 0.0 || std::isinf(largest)) return 0.0;
    double squares = 0.0;
    double cubes = 0.0;
    for (const double one : influences) {
        // Of their scale the result is free, and cubes of shares neither overflow nor vanish.
        const double influence = one / largest;
        squares += influence * influence;
        cubes += influence * influence * influence;
    }
    return cubes / (6.0 * std::pow(squares, 1.5));
}

std::optional<BootstrapInterval> correctedInterval(const std::vector<double>& sorted, double estimate,
                                                   double acceleration, double allowance, double level) {
    const auto below = std::lower_bound(sorted.begin(), sorted.end(), estimate - allowance) - sorted.begin();
    const auto up_to = std::upper_bound(sorted.begin(), sorted.end(), estimate + allowance) - sorted.begin();
    const double share = static_cast<double>(below + up_to) / (2.0 * static_cast<double>(sorted.size()));
    if (share <= 0.0 || share >= 1.0) return std::nullopt;
    const boost::math::normal normal;
    const double bias = boost::math::quantile(normal, share);
    const auto moved = [&](double q) {
        const double z = bias + boost::math::quantile(normal, q);
        return boost::math::cdf(normal, bias + z / (1.0 - acceleration * z));
    };
    const double tail = 0.5 * (1.0 - level);
    return BootstrapInterval{quantileOfSorted(sorted, moved(tail)),
                             quantileOfSorted(sorted, moved(1.0 - tail))};
}

std::vector<BootstrapMean> bootstrapMeans(std::span<const std::vector<double>> rows,
                                          const BootstrapOptions& options) {
    if (rows.empty()) return {};
    const Table table = flatten(rows);
    auto means = resample(table, options);
    std::vector<BootstrapMean> out(table.columns);
    for (std::size_t c = 0; c < table.columns; ++c) {
        std::vector<double> values;
        for (std::size_t i = 0; i < table.participants; ++i)
            if (table.counts[i * table.columns + c] > 0.0)
                values.push_back(table.values[i * table.columns + c]);
        out[c].n = static_cast<int>(values.size());
        std::vector<double>& sorted = means[c];
        const auto fits = [](double value) { return std::isfinite(value); };
        if (values.empty() || sorted.empty() || !std::all_of(sorted.begin(), sorted.end(), fits)) continue;
        std::sort(sorted.begin(), sorted.end());
        const double tail = 0.5 * (1.0 - options.level);
        out[c].estimate = mean(values);
        out[c].se = sampleSd(sorted);
        out[c].percentile =
            BootstrapInterval{quantileOfSorted(sorted, tail), quantileOfSorted(sorted, 1.0 - tail)};
        // Means that are equal on paper differ in their last bits.
        const double allowance = 1e-12 * std::max(std::abs(sorted.front()), std::abs(sorted.back()));
        const double accelerated = values.size() > 1 ? bootstrapAcceleration(influencesOnMean(values)) : 0.0;
        out[c].bca = correctedInterval(sorted, *out[c].estimate, accelerated, allowance, options.level);
    }
    return out;
}

}  // namespace deixis::results
