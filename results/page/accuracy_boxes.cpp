#include "results/page/accuracy_boxes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "results/page/number_text.hpp"

namespace deixis::results {

namespace {

constexpr std::size_t max_box_points = 100;
constexpr double highest_accuracy = 0.64;

/// Equation 2 of an angle.
double rewardOf(double degrees) {
    return (std::exp(1.0 - degrees / 180.0) - 1.0) / std::exp(1.0);
}

/// The angles that the accuracies beside a plot mean, as many as have room; 0 is the ceiling.
std::vector<BoxPlot::Level> anglesBeside(double low, double high) {
    const double min_gap = 0.05 * (high - low);
    std::vector<BoxPlot::Level> levels;
    for (const double degrees : {0.0, 5.0, 10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 90.0, 120.0, 180.0}) {
        const double at = rewardOf(degrees);
        if (at < low || (!levels.empty() && levels.back().value - at < min_gap)) continue;
        levels.push_back({at, fmt::format("{:g}\u00b0", degrees), degrees == 0.0});
    }
    return levels;
}

}  // namespace

std::string accuracyText(double value) {
    return fixedText(value, 3);
}

BoxPlot accuracyBoxPlot(std::vector<BoxPlot::Box> boxes) {
    double least = 0.55;
    for (const BoxPlot::Box& box : boxes)
        for (const double accuracy : box.values) least = std::min(least, accuracy);
    BoxPlot plot;
    plot.boxes = std::move(boxes);
    plot.low = std::max(0.0, std::floor(least / 0.05) * 0.05);
    plot.high = highest_accuracy;
    plot.axis = {{"title", "accuracy (Eq. 2)"}, {"format", ".2f"}, {"tickCount", 8}};
    plot.height_px = 340.0;
    plot.text = accuracyText;
    plot.nothing = "no accuracy";
    plot.levels = anglesBeside(plot.low, plot.high);
    plot.max_points = max_box_points;
    return plot;
}

}  // namespace deixis::results
