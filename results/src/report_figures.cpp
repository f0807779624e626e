// Box plots like the paper's Figure 7, with every participant's mean as a point.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "report_text.hpp"
#include "results/descriptive.hpp"

namespace deixis::results {

namespace {

// All lengths in the drawing's own units; the page scales the drawing.
constexpr double left = 58.0;
constexpr double top = 14.0;
constexpr double plot_height = 270.0;
constexpr double column_width = 92.0;
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

namespace {

/// Grid lines at whole steps of a scale, at most some ten.
std::string ratingGrid(const Axis& axis, double right, const Measure& measure) {
    const double range = measure.high - measure.low;
    const int every = range <= 10.0    ? 1
                      : range <= 50.0  ? 5
                      : range <= 100.0 ? 20
                                       : static_cast<int>(range / 5.0);
    std::string out;
    for (int step = static_cast<int>(measure.low); step <= static_cast<int>(measure.high); step += every)
        out += gridLine(axis, right, step, fmt::format("{}", step));
    return out;
}

}  // namespace

std::string boxPlotSvg(const AnalysisResult& result, std::size_t index) {
    const Measure& measure = result.measures[index];
    const bool accuracy = measure.kind == MeasureKind::accuracy;
    // Room above and below, so that points at the ends of the scale are whole.
    const double room = 0.03 * std::max(1e-9, measure.high - measure.low);
    const Axis axis{measure.low - room, measure.high + room};
    const double right =
        left + column_width * static_cast<double>(std::max<std::size_t>(1, result.systems.size()));
    const double width = right + margin_right;
    const double height = top + plot_height + bottom;
    std::string out = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {:.0f} {:.0f}" role="img" aria-label="Box plot of {} by system">)",
        width, height, escapeHtml(measure.name));
    if (accuracy) {
        for (int percent = 0; percent <= 100; percent += 20)
            out += gridLine(axis, right, percent / 100.0, fmt::format("{} %", percent));
        if (measure.balls > 1) {
            const double chance = 1.0 / measure.balls;
            out += line(left, axis.y(chance), right, axis.y(chance),
                        R"(stroke="#8a8a85" stroke-dasharray="5 4")");
            out += label(right + 5.0, axis.y(chance) + 4.5, "start", "chance");
        }
    } else {
        out += ratingGrid(axis, right, measure);
    }
    for (std::size_t i = 0; i < result.systems.size(); ++i) {
        const SystemResult& system = result.systems[i];
        const double centre = left + column_width * (static_cast<double>(i) + 0.5);
        const auto& values = system.measures[index].by_participant;
        if (values.empty())
            out += label(centre, top + plot_height / 2.0, "middle", "no answers");
        else
            out += box(axis, centre, values, colours[i % colours.size()]);
        out += columnLabel(centre, system.system);
    }
    return out + "</svg>";
}

std::string preferencesSvg(const AnalysisResult& result) {
    constexpr double row_height = 46.0;
    constexpr double bar_height = 22.0;
    constexpr double bar_left = 150.0;
    constexpr double bar_width = 320.0;
    const double height = 8.0 + row_height * static_cast<double>(result.preferences.size());
    std::string out = fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 620 {:.0f}" role="img" aria-label="Preferences of each pair of systems">)",
        height);
    double y = 8.0;
    for (const auto& pair : result.preferences) {
        const double all = std::max(1, pair.prefers_a + pair.ties + pair.prefers_b);
        double x = bar_left;
        for (const auto& [count, colour] :
             {std::pair{pair.prefers_a, colours[0]}, std::pair{pair.ties, "#d6d6d1"},
              std::pair{pair.prefers_b, colours[1]}}) {
            const double part = bar_width * count / all;
            out += fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="{}"/>)", x,
                               y, part, bar_height, colour);
            if (part > 26.0)
                out += fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="middle" fill="{}">{}</text>)",
                                   x + part / 2.0, y + 16.0,
                                   std::string_view(colour) == colours[0] ? "#ffffff" : "#1c1c1a", count);
            x += part;
        }
        out += label(bar_left - 8.0, y + 16.0, "end", pair.a);
        out += label(bar_left + bar_width + 8.0, y + 16.0, "start", pair.b);
        y += row_height;
    }
    return out + "</svg>";
}

}  // namespace deixis::results
