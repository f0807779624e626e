#include "results/page/figure_places.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "results/page/number_text.hpp"

namespace deixis::results {

namespace {

constexpr double panel_gap = 0.08;   // of a panel's width
constexpr double panel_half = 0.43;  // of a row's height
constexpr auto both_views = {SpaceView::above, SpaceView::behind};

int upAxis(SpaceView view) {
    return view == SpaceView::above ? 2 : 1;
}

/// As many lines for each name, so that all stand at the same height.
std::vector<std::vector<std::string>> namesInLines(const std::vector<std::string>& rows) {
    std::vector<std::vector<std::string>> names;
    std::size_t max = 1;
    for (const std::string& row : rows) max = std::max(max, names.emplace_back(brokenName(row)).size());
    for (auto& name : names) name.resize(max);
    return names;
}

FigureJson framesOf(std::size_t rows) {
    FigureJson frames = FigureJson::array();
    for (std::size_t row = 0; row < rows; ++row)
        for (const double left : {0.0, 1.0 + panel_gap})
            frames.push_back({{"x", left},
                              {"x2", left + 1.0},
                              {"y", static_cast<double>(row) - panel_half},
                              {"y2", static_cast<double>(row) + panel_half}});
    return frames;
}

FigureJson rectangle() {
    return {{"x2", {{"field", "x2"}}}, {"y2", {{"field", "y2"}}}};
}

}  // namespace

SpaceBox SpaceBox::around(const std::vector<Vec3>& places) {
    SpaceBox out{places.front(), places.front()};
    for (const Vec3& place : places)
        for (int axis = 0; axis < 3; ++axis) {
            out.low[axis] = std::min(out.low[axis], place[axis]);
            out.high[axis] = std::max(out.high[axis], place[axis]);
        }
    return out;
}

SpaceBox SpaceBox::widened(double share) const {
    Vec3 more = share * (high - low);
    for (int axis = 0; axis < 3; ++axis)
        if (high[axis] - low[axis] < 0.1) more[axis] += 0.05;
    return {low - more, high + more};
}

SpacePlot::SpacePlot(std::vector<std::string> rows, const SpaceBox& space)
    : rows_(std::move(rows)), space_(space) {}

SpacePlot::Place SpacePlot::placeOf(std::size_t row, SpaceView view, const Vec3& at) const {
    const auto share = [&](int axis) {
        return (at[axis] - space_.low[axis]) / (space_.high[axis] - space_.low[axis]);
    };
    const double left = view == SpaceView::above ? 0.0 : 1.0 + panel_gap;
    return {left + 1.0 - share(0),
            static_cast<double>(row) + panel_half - 2.0 * panel_half * share(upAxis(view))};
}

void SpacePlot::point(std::size_t row, const Vec3& at, double value, const std::string& tip) {
    for (const SpaceView view : both_views) {
        const Place place = placeOf(row, view, at);
        points_.push_back({{"x", place.x}, {"y", place.y}, {"mean", value}, {"tip", tip}});
    }
}

void SpacePlot::dot(std::size_t row, const Vec3& at) {
    for (const SpaceView view : both_views) {
        const int up = upAxis(view);
        if (at.x < space_.low.x || at.x > space_.high.x || at[up] < space_.low[up] ||
            at[up] > space_.high[up])
            continue;
        const Place place = placeOf(row, view, at);
        dots_.push_back({{"x", rounded(place.x)}, {"y", rounded(place.y)}});
    }
}

void SpacePlot::cell(std::size_t row, SpaceView view, const Vec3& low, const Vec3& high, double value,
                     const std::string& tip) {
    const Place from = placeOf(row, view, low);
    const Place to = placeOf(row, view, high);
    cells_.push_back({{"x", rounded(to.x)},
                      {"x2", rounded(from.x)},
                      {"y", rounded(to.y)},
                      {"y2", rounded(from.y)},
                      {"mean", rounded(value)},
                      {"tip", tip}});
}

FigureJson SpacePlot::spec(double low, double high, const char* format, double max_row_px) const {
    constexpr double min_row_px = 50.0;
    const double end = 2.0 + panel_gap;
    FigureJson x = quantity("x");
    x["scale"] = {{"domain", {0.0, end}}, {"nice", false}};
    x["axis"] = nullptr;
    FigureJson y = quantity("y");
    y["scale"] = {{"domain", {-0.5, static_cast<double>(rows_.size()) - 0.5}},
                  {"reverse", true},
                  {"nice", false},
                  {"zero", false}};
    y["axis"] = rowAxis(namesInLines(rows_));
    const FigureJson colours{{"field", "mean"},
                             {"type", "quantitative"},
                             {"scale", {{"scheme", "viridis"}, {"domain", {low, high}}}},
                             {"legend", {{"format", format}, {"gradientLength", 160}, {"tickCount", 3}}}};
    FigureJson titles{{{"x", 0.5}, {"y", -panel_half}, {"words", "from above"}},
                      {{"x", 1.5 + panel_gap}, {"y", -panel_half}, {"words", "from behind"}}};
    FigureJson layers = FigureJson::array();
    if (!cells_.empty()) {
        FigureJson encoding = rectangle();
        encoding["fill"] = colours;
        encoding["tooltip"] = {{"field", "tip"}};
        // Without a stroke the paper would show between the cells.
        layers.push_back(layerOf(
            cells_,
            {{"type", "rect"}, {"strokeWidth", 1}, {"stroke", {{"expr", "scale('fill', datum.mean)"}}}},
            std::move(encoding)));
    }
    layers.push_back(layerOf(framesOf(rows_.size()),
                             {{"type", "rect"}, {"fill", nullptr}, {"stroke", "#e3e3e0"}, {"strokeWidth", 1}},
                             rectangle()));
    layers.push_back(layerOf(std::move(titles),
                             {{"type", "text"}, {"baseline", "bottom"}, {"dy", -6}, {"color", soft_colour}},
                             {{"text", {{"field", "words"}}}}));
    if (!points_.empty())
        layers.push_back(layerOf(points_,
                                 {{"type", "point"},
                                  {"shape", "circle"},
                                  {"size", {{"expr", "clamp(width / 8, 20, 70)"}}},
                                  {"opacity", 1},
                                  {"stroke", even_colour},
                                  {"strokeWidth", 0.7}},
                                 {{"fill", colours}, {"tooltip", {{"field", "tip"}}}}));
    if (!dots_.empty())
        layers.push_back(layerOf(dots_,
                                 {{"type", "point"},
                                  {"shape", "circle"},
                                  {"size", 22},
                                  {"opacity", 1},
                                  {"fill", paper_colour},
                                  {"stroke", ink_colour},
                                  {"strokeWidth", 0.8}},
                                 FigureJson::object()));
    const Vec3 length = space_.high - space_.low;
    const double row_of_width = std::max(length.y, length.z) / length.x / end / (2.0 * panel_half);
    return {{"height", max_row_px * static_cast<double>(rows_.size())},
            {"usermeta", heightByWidth(fmt::format("{} * clamp({:.4f} * width, {}, {})", rows_.size(),
                                                   row_of_width, min_row_px, max_row_px))},
            {"encoding", {{"x", x}, {"y", y}}},
            {"layer", std::move(layers)}};
}

std::string spaceText(const SpaceBox& space) {
    const auto from_to = [](double first, double last) {
        return fixedText(first, 1) + " to " + fixedText(last, 1) + " m";
    };
    return fmt::format("x from {}. From above, ahead is up: z from {}. From behind: y from {}.",
                       from_to(space.high.x, space.low.x), from_to(space.low.z, space.high.z),
                       from_to(space.low.y, space.high.y));
}

}  // namespace deixis::results
