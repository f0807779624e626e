// Paired differences, one row per pair, with the estimate of their shift that belongs to the test.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "results/page/figure.hpp"
#include "results/statistics/hodges_lehmann.hpp"

namespace deixis::results {

struct DifferencePlot {
    struct Row {
        std::string a, b;                 ///< the differences are a's less b's
        std::vector<double> differences;  ///< at least one
        HodgesLehmann shift;
        double p_holm = 1.0;
        bool significant = false;
    };
    std::vector<Row> rows;
    FigureJson axis;                          ///< of the differences: title, labels
    std::function<std::string(double)> text;  ///< a difference for people
    /// Points of each row; of more differences, points at as many of their quantiles.
    std::size_t max_points = std::numeric_limits<std::size_t>::max();
};

[[nodiscard]] FigureJson differencesSpec(const DifferencePlot& plot);
/// " a \u2212 b: 0.1 [0.0, 0.2], significant." for each row: for a figure's label.
[[nodiscard]] std::string shiftsText(const DifferencePlot& plot);

}  // namespace deixis::results
