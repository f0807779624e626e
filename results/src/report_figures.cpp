// Box plots like the paper's Figure 7, with every participant's mean as a point.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report_text.hpp"

namespace deixis::results {

namespace {

// All lengths in the drawing's own units; the page scales the drawing.
constexpr double left = 58.0;
constexpr double top = 14.0;
constexpr double plot_height = 270.0;
constexpr double column = 92.0;
constexpr double bottom = 52.0;
constexpr double margin_right = 58.0;  // for the word "chance"

/// Told apart by people of all colour vision (Okabe & Ito 2008).
constexpr std::array colours{"#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00"};

struct Axis {
    double low = 0.0;
    double high = 1.0;
    [[nodiscard]] double y(double value) const {
        return top + plot_height * (1.0 - (value - low) / (high - low));
    }
};

std::string line(double x1, double y1, double x2, double y2, const char* style) {
    return fmt::format(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" {}/>)", x1, y1, x2, y2,
                       style);
}

std::string label(double x, double y, const char* anchor, const std::string& text) {
    return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x, y, anchor,
                       escapeHtml(text));
}

std::string gridLine(const Axis& axis, double right, double value, const std::string& text) {
    return line(left, axis.y(value), right, axis.y(value), R"(stroke="#e3e3e0")") +
           label(left - 8.0, axis.y(value) + 4.5, "end", text);
}

/// A long name breaks at the hyphen or space nearest to its middle.
std::string columnLabel(double centre, const std::string& name) {
    constexpr std::size_t fits = 12;
    const double y = top + plot_height + 20.0;
    const auto distance = [&](std::size_t at) {
        return std::abs(static_cast<double>(at) - static_cast<double>(name.size()) / 2.0);
    };
    std::size_t best = std::string::npos;
    for (std::size_t at = name.find_first_of("- "); at != std::string::npos;
         at = name.find_first_of("- ", at + 1))
        if (best == std::string::npos || distance(at) < distance(best)) best = at;
    if (name.size() <= fits || best == std::string::npos) return label(centre, y, "middle", name);
    return label(centre, y, "middle", name.substr(0, best + 1)) +
           label(centre, y + 16.0, "middle", name.substr(best + 1));
}

std::string box(const Axis& axis, double centre, const std::vector<double>& values, const char* colour) {
    const double q1 = quantile(values, 0.25);
    const double q3 = quantile(values, 0.75);
    const double reach = 1.5 * (q3 - q1);
    double low = q1;
    double high = q3;
    for (const double value : values) {
        if (value >= q1 - reach) low = std::min(low, value);
        if (value <= q3 + reach) high = std::max(high, value);
    }
    constexpr double half = 26.0;
    const std::string whisker = fmt::format(R"(stroke="{}" stroke-width="1.5")", colour);
    std::string out;
    for (const double end : {low, high})
        out += line(centre - 10.0, axis.y(end), centre + 10.0, axis.y(end), whisker.c_str());
    out += line(centre, axis.y(low), centre, axis.y(q1), whisker.c_str());
    out += line(centre, axis.y(q3), centre, axis.y(high), whisker.c_str());
    out += fmt::format(
        R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="{}" fill-opacity="0.16" stroke="{}" stroke-width="1.5"/>)",
        centre - half, axis.y(q3), 2.0 * half, axis.y(q1) - axis.y(q3), colour, colour);
    // Side by side in an order that fills the width evenly (multiples of the golden ratio).
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double place = std::fmod(0.618034 * static_cast<double>(i + 1), 1.0) - 0.5;
        out += fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="2.2" fill="{}" fill-opacity="0.45"/>)",
                           centre + place * 1.7 * half, axis.y(values[i]), colour);
    }
    const double median = axis.y(quantile(values, 0.5));
    out += line(centre - half, median, centre + half, median, R"(stroke="#1c1c1a" stroke-width="2.5")");
    const double middle = axis.y(mean(values));
    out += fmt::format(
        R"(<path d="M{0:.1f} {1:.1f}l6 6l-6 6l-6 -6z" fill="#ffffff" stroke="#1c1c1a" stroke-width="1.5"/>)",
        centre, middle - 6.0);
    return out;
}

}  // namespace

std::string boxPlotSvg(const AnalysisResult& result, const std::string& measure) {
    const bool accuracy = measure == "accuracy";
    // Room above and below, so that points at the ends of the scale are whole.
    const double steps = std::max(2, result.table.rating_steps);
    const Axis axis =
        accuracy ? Axis{-0.03, 1.03} : Axis{1.0 - 0.03 * (steps - 1.0), steps + 0.03 * (steps - 1.0)};
    const double right = left + column * static_cast<double>(std::max<std::size_t>(1, result.systems.size()));
    const double width = right + margin_right;
    const double height = top + plot_height + bottom;
    std::string out = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {:.0f} {:.0f}" role="img" aria-label="Box plot of {} by system">)",
        width, height, measure);
    if (accuracy) {
        for (int percent = 0; percent <= 100; percent += 20)
            out += gridLine(axis, right, percent / 100.0, fmt::format("{} %", percent));
        if (result.table.balls > 1) {
            const double chance = 1.0 / result.table.balls;
            out += line(left, axis.y(chance), right, axis.y(chance),
                        R"(stroke="#8a8a85" stroke-dasharray="5 4")");
            out += label(right + 5.0, axis.y(chance) + 4.5, "start", "chance");
        }
    } else {
        const int every = static_cast<int>(std::ceil((steps - 1.0) / 10.0));
        for (int step = 1; step <= static_cast<int>(steps); step += every)
            out += gridLine(axis, right, step, fmt::format("{}", step));
    }
    for (std::size_t i = 0; i < result.systems.size(); ++i) {
        const SystemResult& system = result.systems[i];
        const double centre = left + column * (static_cast<double>(i) + 0.5);
        const auto& values = accuracy ? system.accuracy_by_participant : system.naturalness_by_participant;
        if (values.empty())
            out += label(centre, top + plot_height / 2.0, "middle", "no answers");
        else
            out += box(axis, centre, values, colours[i % colours.size()]);
        out += columnLabel(centre, system.system);
    }
    return out + "</svg>";
}

}  // namespace deixis::results
