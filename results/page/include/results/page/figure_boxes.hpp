// Box plots side by side: notched, with points, means, and brackets between those that differ.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "results/page/figure.hpp"

namespace deixis::results {

struct BoxPlot {
    struct Box {
        std::string name;
        std::vector<double> values;
    };
    struct Pair {
        std::size_t a = 0, b = 0;  ///< of `boxes`
        double p = 1.0;            ///< after correction
    };
    struct Level {
        double value = 0.0;
        std::string words;   ///< right of the plot
        bool across = true;  ///< a dashed line through the plot
    };
    /// Boxes that stand together under one name, in the order of `boxes`: the same ones in each group.
    struct Group {
        std::string name;
        std::size_t boxes = 0;
    };
    std::vector<Box> boxes;
    double low = 0.0, high = 1.0;             ///< of the scale
    FigureJson axis;                          ///< of the values: title, ticks, their labels
    double height_px = 280.0;                 ///< of the scale; brackets stand above
    std::function<std::string(double)> text;  ///< a value for people
    std::string nothing;                      ///< stands in the place of a box without values
    std::vector<Level> levels{};
    std::vector<Pair> brackets{};
    /// Where there are any the axis names them, and a legend the boxes; brackets join boxes of one group.
    std::vector<Group> groups{};
    /// Points of each box; of more values, points at as many of their quantiles.
    std::size_t max_points = std::numeric_limits<std::size_t>::max();
};

/// The notches of BoxSummary where they lie within their box; a participant's or clip's value a point, spread
/// sideways where points would cover each other.
[[nodiscard]] FigureJson boxPlotSpec(const BoxPlot& plot);
/// "direct 0.62, stiff 0.61": for a figure's label.
[[nodiscard]] std::string mediansText(const BoxPlot& plot);

}  // namespace deixis::results
