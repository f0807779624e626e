#include "svg_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report_text.hpp"

namespace deixis::results {

namespace {

double tickStep(double low, double high, int most) {
    const double range = high - low;
    if (!(range > 0.0)) return 1.0;
    double step = std::pow(10.0, std::floor(std::log10(range / most)));
    for (const double factor : {1.0, 2.0, 5.0, 10.0})
        if (range / (factor * step) <= most) return factor * step;
    return 10.0 * step;
}

}  // namespace

std::vector<double> roundTicks(double low, double high, int most) {
    const double step = tickStep(low, high, most);
    std::vector<double> ticks;
    const double slack = 1e-9 * step;
    for (double at = std::ceil((low - slack) / step); at * step <= high + slack; at += 1.0)
        ticks.push_back(at * step);
    return ticks;
}

std::string tickText(double value, double step) {
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
    if (std::abs(value) < 1e-9 * step) value = 0.0;
    return (value < 0.0 ? "\u2212" : "") + fmt::format("{:.{}f}", std::abs(value), decimals);
}

std::string pathPoint(double x, double y) {
    return fmt::format("{:.1f} {:.1f}", x, y);
}

std::string sharedColour(double share) {
    constexpr std::array<std::array<int, 3>, 9> stops{{{68, 1, 84},
                                                       {71, 44, 122},
                                                       {59, 81, 139},
                                                       {44, 113, 142},
                                                       {33, 144, 141},
                                                       {39, 173, 129},
                                                       {92, 200, 99},
                                                       {170, 220, 50},
                                                       {253, 231, 37}}};
    const double at = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    std::string colour = "#";
    for (std::size_t i = 0; i < 3; ++i)
        colour += fmt::format(
            "{:02x}",
            static_cast<int>(std::lround(stops[below][i] + (at - static_cast<double>(below)) *
                                                               (stops[below + 1][i] - stops[below][i]))));
    return colour;
}

SvgDrawing::SvgDrawing(double width, double height, const std::string& id, const std::string& title,
                       const std::string& description)
    : out_(fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {:.0f} {:.0f}" role="img" )"
                       R"(aria-labelledby="{}-t {}-d"><title id="{}-t">{}</title><desc id="{}-d">{}</desc>)",
                       width, height, id, id, id, escapeHtml(title), id, escapeHtml(description))) {}

void SvgDrawing::line(double x1, double y1, double x2, double y2, const char* style_class) {
    out_ += fmt::format(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" class="{}"/>)", x1, y1, x2,
                        y2, style_class);
}

void SvgDrawing::text(double x, double y, const char* anchor, const std::string& text,
                      const char* style_class) {
    out_ += fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}"{}>{}</text>)", x, y, anchor,
                        *style_class ? fmt::format(R"( class="{}")", style_class) : "", escapeHtml(text));
}

void SvgDrawing::textUpwards(double x, double y, const std::string& text) {
    out_ += fmt::format(
        R"svg(<text transform="translate({:.1f} {:.1f}) rotate(-90)" text-anchor="middle">{}</text>)svg", x,
        y, escapeHtml(text));
}

void SvgDrawing::circle(double x, double y, double radius, const std::string& attributes) {
    out_ += fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}"{}{}/>)", x, y, radius,
                        attributes.empty() ? "" : " ", attributes);
}

void SvgDrawing::rectangle(double x, double y, double width, double height, const std::string& attributes) {
    out_ += fmt::format(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" {}/>)", x, y, width,
                        height, attributes);
}

void SvgDrawing::path(const std::string& data, const std::string& attributes) {
    out_ += fmt::format(R"(<path d="{}" {}/>)", data, attributes);
}

void SvgDrawing::open(const char* style_class) {
    out_ += fmt::format(R"(<g class="{}">)", style_class);
}

void SvgDrawing::close() {
    out_ += "</g>";
}

void SvgDrawing::axisX(const Scale& scale, double y_top, double y_bottom, const std::string& name,
                       int most_ticks) {
    const double step = tickStep(scale.low, scale.high, most_ticks);
    for (const double tick : roundTicks(scale.low, scale.high, most_ticks)) {
        line(scale(tick), y_top, scale(tick), y_bottom, "grid");
        text(scale(tick), y_bottom + 16.0, "middle", tickText(tick, step));
    }
    line(scale.from, y_bottom, scale.to, y_bottom, "axis");
    text(0.5 * (scale.from + scale.to), y_bottom + 34.0, "middle", name);
}

void SvgDrawing::axisY(const Scale& scale, double x_left, double x_right, double name_x,
                       const std::string& name, int most_ticks) {
    const double step = tickStep(scale.low, scale.high, most_ticks);
    for (const double tick : roundTicks(scale.low, scale.high, most_ticks)) {
        line(x_left, scale(tick), x_right, scale(tick), "grid");
        text(x_left - 6.0, scale(tick) + 4.5, "end", tickText(tick, step));
    }
    textUpwards(name_x, 0.5 * (scale.from + scale.to), name);
}

std::string SvgDrawing::finish() {
    return out_ + "</svg>";
}

void colourBar(SvgDrawing& drawing, double x, double y, double height, double low, double high,
               const std::string& name) {
    constexpr int bands = 24;
    const double band = height / bands;
    for (int i = 0; i < bands; ++i)
        drawing.rectangle(x, y + height - (i + 1) * band, 12.0, band + 0.4,
                          fmt::format(R"(fill="{}")", sharedColour((i + 0.5) / bands)));
    const Scale scale{low, high, y + height, y};
    const double step = tickStep(low, high, 5);
    if (high > low)
        for (const double tick : roundTicks(low, high, 5))
            drawing.text(x + 17.0, scale(tick) + 4.5, "start", tickText(tick, step));
    else
        drawing.text(x + 17.0, y + height, "start", fmt::format("{:.3g}", low));
    drawing.text(x + 44.0, y - 10.0, "end", name);
}

}  // namespace deixis::results
