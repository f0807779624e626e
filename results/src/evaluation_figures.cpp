// Box plots, profiles and scatter plots of the evaluation.
#include "evaluation_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "results/descriptive.hpp"
#include "svg_drawing.hpp"

namespace deixis::results {

namespace {

/// Equation 2 of an angle.
double rewardOf(double degrees) {
    return (std::exp(1.0 - degrees / 180.0) - 1.0) / std::exp(1.0);
}

/// The least accuracy of any clip, to the 0.05 below: where the accuracies' scales begin.
double leastAccuracy(const Evaluation& evaluation) {
    double least = 0.55;
    for (const auto& system : evaluation.systems)
        for (const double reward : system.rewards) least = std::min(least, reward);
    return std::max(0.0, std::floor(least / 0.05) * 0.05);
}

/// Degrees above the plot, as many as have room.
void degreesAbove(SvgDrawing& drawing, const Scale& x, double y_top, double y_bottom) {
    double last = x(reward_ceiling) + 60.0;
    for (const double degrees : {0.0, 5.0, 10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 90.0, 120.0, 180.0}) {
        const double at = x(rewardOf(degrees));
        if (rewardOf(degrees) < x.low || last - at < 32.0 || at - x.from < 8.0) continue;
        last = at;
        drawing.line(at, y_top - 4.0, at, y_top, "axis");
        drawing.text(at, y_top - 8.0, "middle", fmt::format("{:g}\u00b0", degrees));
    }
    drawing.line(x.from, y_top, x.to, y_top, "axis");
    drawing.line(x(reward_ceiling), y_top, x(reward_ceiling), y_bottom, "limit");
}

void boxAlong(SvgDrawing& drawing, const Scale& x, double y, const std::vector<double>& values) {
    const BoxSummary box = *boxSummary(values);
    constexpr double half = 11.0;
    for (const double end : {box.q05, box.q95}) drawing.line(x(end), y - 5.0, x(end), y + 5.0, "box");
    drawing.line(x(box.q05), y, x(box.q25), y, "box");
    drawing.line(x(box.q75), y, x(box.q95), y, "box");
    drawing.rectangle(x(box.q25), y - half, std::max(0.5, x(box.q75) - x(box.q25)), 2.0 * half,
                      R"(class="box area")");
    for (const double value : values)
        if (value < box.q05 || value > box.q95) drawing.circle(x(value), y, 1.9, R"(class="dot")");
    const double median = x(box.median);
    drawing.line(median, y - half, median, y + half, "median");
    drawing.path(fmt::format("M{:.1f} {:.1f}l5 5l-5 5l-5 -5z", x(box.mean), y - 5.0), R"(class="diamond")");
}

}  // namespace

std::string accuracyBoxesSvg(const Evaluation& evaluation) {
    constexpr double width = 420.0;
    constexpr double top = 46.0;
    constexpr double row = 50.0;
    const double bottom = top + row * static_cast<double>(evaluation.systems.size()) + 4.0;
    SvgDrawing drawing(
        width, bottom + 42.0, "boxes", "Accuracy by system",
        "Box plots of the accuracy of all clips of each system. The numbers stand in Table 1.");
    const Scale x{leastAccuracy(evaluation), 0.65, 12.0, width - 14.0};
    drawing.axisX(x, top, bottom, "accuracy (Eq. 2)", 7);
    degreesAbove(drawing, x, top, bottom);
    drawing.text(x.from, 14.0, "start", "the same as angle between forearm and target");
    double y = top;
    for (const SystemEvaluation& system : evaluation.systems) {
        drawing.text(x.from + 4.0, y + 16.0, "start", system.system, "strong halo");
        if (system.rewards.empty()) {
            drawing.text(x.from + 4.0, y + 38.0, "start", "no clip has an accuracy");
        } else {
            drawing.open("c0");
            boxAlong(drawing, x, y + 34.0, system.rewards);
            drawing.close();
        }
        y += row;
    }
    return drawing.finish();
}

namespace {

struct Course {
    double low, mean, high;
};
Course courseAt(const ProfilePoint& point, ProfileKind kind) {
    const bool accuracy = kind == ProfileKind::accuracy;
    const double centre = accuracy ? point.reward_mean : point.speed_mean;
    const double sd = accuracy ? point.reward_sd : point.speed_sd;
    return {std::max(0.0, centre - sd), centre, centre + sd};
}

void drawCourse(SvgDrawing& drawing, const HandProfile& profile, ProfileKind kind, const Scale& x,
                const Scale& y, const char* colour, const char* line_class) {
    if (profile.points.empty()) return;
    std::string centre;
    std::string above;
    std::string below;
    for (const ProfilePoint& point : profile.points) {
        const Course course = courseAt(point, kind);
        centre += (centre.empty() ? "M" : "L") + pathPoint(x(point.time_s), y(course.mean));
        above += (above.empty() ? "M" : "L") + pathPoint(x(point.time_s), y(std::min(course.high, y.high)));
        below.insert(0, "L" + pathPoint(x(point.time_s), y(std::max(course.low, y.low))));
    }
    drawing.open(colour);
    drawing.path(above + below + "Z", R"(class="band")");
    drawing.path(centre, fmt::format(R"(class="{}")", line_class));
    drawing.close();
}

/// One scale for all systems: by the widest of their bands.
double highestOf(const Evaluation& evaluation, ProfileKind kind) {
    if (kind == ProfileKind::accuracy) return 0.65;
    double highest = 1.0;
    for (const auto& system : evaluation.systems)
        for (const HandProfile* profile : {&system.left, &system.right})
            for (const ProfilePoint& point : profile->points)
                highest = std::max(highest, courseAt(point, kind).high);
    return std::ceil(highest / 0.5) * 0.5;
}

std::pair<double, double> timeRange(const Evaluation& evaluation) {
    double first = -0.5;
    double last = 0.5;
    for (const auto& system : evaluation.systems)
        for (const HandProfile* profile : {&system.left, &system.right})
            for (const ProfilePoint& point : profile->points) {
                first = std::min(first, point.time_s);
                last = std::max(last, point.time_s);
            }
    return {first, last};
}

/// Names of the curves, above the plot.
void handKey(SvgDrawing& drawing, const SystemEvaluation& system, double x, double y) {
    for (const auto& [name, profile, colour, line_class] :
         {std::tuple{"right hand", &system.right, "c0", "curve"},
          std::tuple{"left hand", &system.left, "c1", "curve dashed"}}) {
        if (profile->clips == 0) continue;
        drawing.open(colour);
        drawing.line(x, y - 4.5, x + 22.0, y - 4.5, line_class);
        drawing.close();
        drawing.text(x + 27.0, y, "start", fmt::format("{} ({})", name, profile->clips));
        x += 150.0;
    }
}

}  // namespace

std::string profileSvg(const Evaluation& evaluation, std::size_t index, ProfileKind kind) {
    const SystemEvaluation& system = evaluation.systems[index];
    const bool accuracy = kind == ProfileKind::accuracy;
    SvgDrawing drawing(
        340.0, 236.0, fmt::format("{}-{}", accuracy ? "course" : "speed", index),
        fmt::format("{} by hand: {}", accuracy ? "Accuracy" : "Hand speed", system.system),
        fmt::format("Mean and one standard deviation over the clips against the time from pointing, {} "
                    "right-handed and {} left-handed clips. The numbers stand in profiles.csv.",
                    system.right.clips, system.left.clips));
    const auto [first, last] = timeRange(evaluation);
    const Scale x{first, last, 52.0, 330.0};
    const Scale y{0.0, highestOf(evaluation, kind), 190.0, 26.0};
    drawing.axisX(x, y.to, y.from, "time from pointing (s)", 6);
    drawing.axisY(y, x.from, x.to, 14.0, accuracy ? "reward (Eq. 2)" : "hand speed (m/s)", 6);
    drawing.line(x(0.0), y.from, x(0.0), y.to, "axis");
    if (!accuracy && evaluation.input.rule.slower_than_m_s < y.high)
        drawing.line(x.from, y(evaluation.input.rule.slower_than_m_s), x.to,
                     y(evaluation.input.rule.slower_than_m_s), "limit");
    if (accuracy) drawing.line(x.from, y(reward_ceiling), x.to, y(reward_ceiling), "limit");
    drawCourse(drawing, system.left, kind, x, y, "c1", "curve dashed");
    drawCourse(drawing, system.right, kind, x, y, "c0", "curve");
    handKey(drawing, system, x.from, 14.0);
    return drawing.finish();
}

std::string densityScatterSvg(const Evaluation& evaluation, std::size_t index) {
    const SystemEvaluation& system = evaluation.systems[index];
    double highest = 0.0;
    for (const TestPoint& point : evaluation.points) highest = std::max(highest, point.density);
    SvgDrawing drawing(340.0, 240.0, fmt::format("scatter-{}", index),
                       fmt::format("Accuracy against density: {}", system.system),
                       fmt::format("A point for each of {} clips. The correlation stands in Table 2.",
                                   system.rewards.size()));
    const Scale x{0.0, highest > 0.0 ? 1.04 * highest : 1.0, 52.0, 330.0};
    const Scale y{leastAccuracy(evaluation), 0.65, 194.0, 10.0};
    drawing.axisX(x, y.to, y.from, "density of training targets (1/m\u00b3)", 6);
    drawing.axisY(y, x.from, x.to, 14.0, "accuracy (Eq. 2)", 7);
    drawing.line(x.from, y(reward_ceiling), x.to, y(reward_ceiling), "limit");
    drawing.open("c0 dots");
    for (std::size_t i = 0; i < system.rewards.size(); ++i)
        drawing.circle(x(system.densities[i]), y(system.rewards[i]), 2.0, "");
    drawing.close();
    return drawing.finish();
}

}  // namespace deixis::results
