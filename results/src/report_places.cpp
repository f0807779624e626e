// Right choices over the target space, from above and from behind the avatar.
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "report_figures.hpp"

namespace deixis::results {

namespace {

constexpr double panel_gap = 0.08;   // of a panel's width
constexpr double panel_half = 0.43;  // of a row's height

struct Extent {
    double low = 0.0;
    double high = 0.0;
    /// 0 at the low end, 1 at the high one.
    [[nodiscard]] double share(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

Extent extentOf(const std::vector<TargetPlace>& places, int axis) {
    Extent out{places.front().position_m[axis], places.front().position_m[axis]};
    for (const TargetPlace& place : places) {
        out.low = std::min(out.low, place.position_m[axis]);
        out.high = std::max(out.high, place.position_m[axis]);
    }
    return out;
}

/// Where a share of a panel lies: the middle nine tenths, so that no point stands on the frame.
double inside(double share) {
    return 0.05 + 0.9 * share;
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

}  // namespace

Figure placesFigure(const AnalysisResult& result, Numbering& figures) {
    const std::array<Extent, 3> extent{extentOf(result.target_space, 0), extentOf(result.target_space, 1),
                                       extentOf(result.target_space, 2)};
    const auto& systems = result.table.systems;
    std::vector<std::vector<std::string>> names;
    const bool two_lines = std::any_of(systems.begin(), systems.end(),
                                       [](const std::string& name) { return brokenName(name).size() > 1; });
    for (const std::string& system : systems) {
        names.push_back(brokenName(system));
        if (two_lines && names.back().size() == 1) names.back().emplace_back();
    }
    FigureJson points = FigureJson::array();
    for (const TargetPlace& place : result.target_space) {
        const auto found = std::find(systems.begin(), systems.end(), place.system);
        if (found == systems.end()) continue;  // all of them together
        const auto row = static_cast<double>(found - systems.begin());
        const Vec3& at = place.position_m;
        const double left = inside(1.0 - extent[0].share(at.x));
        const std::string tip =
            fmt::format("{}, {}: {:.0f} of {} at x {:.2f}, y {:.2f}, z {:.2f} m", place.system,
                        place.target_id, place.mean * place.n, place.n, at.x, at.y, at.z);
        for (const auto& [x, up] : {std::pair{left, inside(extent[2].share(at.z))},
                                    std::pair{left + 1.0 + panel_gap, inside(extent[1].share(at.y))}})
            points.push_back({{"x", x},
                              {"y", row + panel_half - 2.0 * panel_half * up},
                              {"mean", place.mean},
                              {"tip", tip}});
    }
    FigureJson x = quantity("x");
    x["scale"] = {{"domain", {0.0, 2.0 + panel_gap}}, {"nice", false}};
    x["axis"] = nullptr;
    FigureJson y = quantity("y");
    y["scale"] = {{"domain", {-0.75, static_cast<double>(systems.size()) - 0.5}},
                  {"reverse", true},
                  {"nice", false},
                  {"zero", false}};
    y["axis"] = rowAxis(names);
    const FigureJson legend{{"format", ".0%"}, {"gradientLength", 160}, {"tickCount", 3}};
    const FigureJson titles{{{"x", 0.5}, {"y", -0.6}, {"words", "from above"}},
                            {{"x", 1.5 + panel_gap}, {"y", -0.6}, {"words", "from behind"}}};
    FigureJson spec{
        {"height", 30 + 120 * systems.size()},
        {"encoding", {{"x", x}, {"y", y}}},
        {"layer",
         {{{"data", {{"values", framesOf(systems.size())}}},
           {"mark", {{"type", "rect"}, {"fill", nullptr}, {"stroke", "#e3e3e0"}, {"strokeWidth", 1}}},
           {"encoding", {{"x2", {{"field", "x2"}}}, {"y2", {{"field", "y2"}}}}}},
          {{"data", {{"values", titles}}},
           {"mark", {{"type", "text"}, {"baseline", "middle"}, {"color", soft_colour}}},
           {"encoding", {{"text", {{"field", "words"}}}}}},
          {{"data", {{"values", std::move(points)}}},
           {"mark",
            {{"type", "point"},
             {"shape", "circle"},
             {"size", 70},
             {"opacity", 1},
             {"stroke", even_colour},
             {"strokeWidth", 0.7}}},
           {"encoding",
            {{"fill",
              {{"field", "mean"},
               {"type", "quantitative"},
               {"scale", {{"scheme", "viridis"}, {"domain", {0, 1}}}},
               {"legend", legend}}},
             {"tooltip", {{"field", "tip"}}}}}}}}};
    const auto from_to = [](double first, double last) {
        return signedText(fmt::format("{:.1f}", first)) + " to " + signedText(fmt::format("{:.1f} m", last));
    };
    return {
        "places",
        fmt::format(
            "{} Right choices by the target's place, the avatar's left on the left: x from {}. From above, "
            "ahead is up: z from {}. From behind: y from {}.",
            figures.next(), from_to(extent[0].high, extent[0].low), from_to(extent[2].low, extent[2].high),
            from_to(extent[1].low, extent[1].high)),
        fmt::format(
            "Share of right choices at each target's place, from above and from behind the avatar, in a "
            "row for each of {} systems; the numbers stand in a table of this page.",
            systems.size()),
        std::move(spec), true};
}

}  // namespace deixis::results
