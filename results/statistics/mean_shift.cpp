#include "results/statistics/mean_shift.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/order_statistics.hpp"

namespace deixis::results {

namespace {

using Point = std::vector<double>;

double distance(const Point& a, const Point& b) {
    double squares = 0.0;
    for (std::size_t j = 0; j < a.size(); ++j) squares += (a[j] - b[j]) * (a[j] - b[j]);
    return std::sqrt(squares);
}

struct Mode {
    Point centre;
    int points = 0;  ///< within the bandwidth of the place before the last step
};

Mode climb(const std::vector<Point>& points, Point from, double bandwidth) {
    constexpr int max_steps = 300;
    Mode mode{std::move(from), 0};
    for (int step = 0;; ++step) {
        Point sum(mode.centre.size(), 0.0);
        int within = 0;
        for (const Point& point : points) {
            if (distance(point, mode.centre) > bandwidth) continue;
            ++within;
            for (std::size_t j = 0; j < sum.size(); ++j) sum[j] += point[j];
        }
        if (within == 0) return mode;
        mode.points = within;
        for (double& value : sum) value /= within;
        const double moved = distance(sum, mode.centre);
        mode.centre = std::move(sum);
        if (moved < 1e-3 * bandwidth || step == max_steps) return mode;
    }
}

}  // namespace

Result<MeanShiftClusters> meanShift(const std::vector<Point>& points, double bandwidth) {
    if (points.empty()) return fail("", "clusters need points; there are none");
    if (!(bandwidth > 0.0) || !std::isfinite(bandwidth))
        return fail("", fmt::format("found bandwidth {}, expected a number above 0", bandwidth));
    for (const Point& point : points)
        if (point.size() != points.front().size())
            return fail("", fmt::format("found a point of {} numbers among points of {}", point.size(),
                                        points.front().size()));
    std::vector<Mode> modes;
    modes.reserve(points.size());
    for (const Point& point : points) modes.push_back(climb(points, point, bandwidth));
    std::sort(modes.begin(), modes.end(), [](const Mode& a, const Mode& b) {
        return a.points != b.points ? a.points > b.points : a.centre > b.centre;
    });
    MeanShiftClusters clusters;
    for (const Mode& mode : modes)
        if (std::none_of(clusters.centres.begin(), clusters.centres.end(),
                         [&](const Point& kept) { return distance(kept, mode.centre) <= bandwidth; }))
            clusters.centres.push_back(mode.centre);
    for (const Point& point : points) {
        const auto nearest = std::min_element(
            clusters.centres.begin(), clusters.centres.end(),
            [&](const Point& a, const Point& b) { return distance(a, point) < distance(b, point); });
        clusters.labels.push_back(static_cast<int>(nearest - clusters.centres.begin()));
    }
    return clusters;
}

double estimateBandwidth(const std::vector<Point>& points, double quantile) {
    if (points.empty()) return 0.0;
    const auto wanted = static_cast<std::size_t>(static_cast<double>(points.size()) * quantile);
    const std::size_t k = std::clamp<std::size_t>(wanted, 1, points.size());
    double sum = 0.0;
    std::vector<double> distances(points.size());
    for (const Point& point : points) {
        for (std::size_t i = 0; i < points.size(); ++i) distances[i] = distance(point, points[i]);
        sum += orderStatistic(distances, k - 1);
    }
    return sum / static_cast<double>(points.size());
}

}  // namespace deixis::results
