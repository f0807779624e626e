// What was measured in a unit, such as how far from its target a ball was put, over the targets' places.
#include <fmt/format.h>

#include <algorithm>

#include "results/analysis/measured_space.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/page/figure_places.hpp"
#include "results/page/html_table.hpp"
#include "sections.hpp"

namespace deixis::results {

namespace {

using Places = std::vector<MeasuredPlace>;

Figure spaceFigure(const AnalysisResult& result, const Measure& measure, const Places& places, int number,
                   Numbering& figures) {
    constexpr double max_row_px = 120.0;
    const auto& systems = result.table.systems;
    std::vector<Vec3> positions;
    double max = 0.0;
    for (const MeasuredPlace& place : places) {
        if (place.measure != measure.name) continue;
        positions.push_back(place.position_m);
        if (place.system != "all") max = std::max(max, place.mean);
    }
    const SpaceBox space = SpaceBox::around(positions);
    SpacePlot plot(systems, space.widened(1.0 / 18.0));  // no point stands on a panel's frame
    for (const MeasuredPlace& place : places) {
        const auto found = std::find(systems.begin(), systems.end(), place.system);
        if (place.measure != measure.name || found == systems.end()) continue;
        const Vec3& at = place.position_m;
        plot.point(static_cast<std::size_t>(found - systems.begin()), at, place.mean,
                   fmt::format("{}, {}: mean {:.1f} {} of {} at x {:.2f}, y {:.2f}, z {:.2f} m", place.system,
                               place.target_id, place.mean, place.unit, place.n, at.x, at.y, at.z));
    }
    return {fmt::format("measured-{}", number),
            fmt::format("{} Mean {} ({}) by the target's place, the avatar's left on the left: {}",
                        figures.next(), escapeHtml(measure.name), escapeHtml(measure.unit), spaceText(space)),
            fmt::format("Mean {} in {} at each target's place, from above and from behind the avatar, in a "
                        "row for each of {} systems; a table of this page has the numbers.",
                        measure.name, measure.unit, systems.size()),
            plot.spec(0.0, max, "~r", max_row_px), true};
}

std::string spaceTable(const AnalysisResult& result, const Measure& measure, Numbering& numbering) {
    std::vector<std::string> systems{"all"};
    systems.insert(systems.end(), result.table.systems.begin(), result.table.systems.end());
    Table all = tables::measuredSpace(result);
    all.column("item").label = "Target";
    const std::size_t named = all.at("measure");
    std::erase_if(all.rows,
                  [&](const Table::Row& row) { return *row.cells[named].as<std::string>() != measure.name; });
    const auto mean = [value = all.at("mean"), n = all.at("n")](const Table::Row& row) -> Cell {
        return fmt::format("{:.1f} (of {})", *row.cells[value].as<double>(), *row.cells[n].as<long long>());
    };
    const auto name = [](const std::string& system) { return system; };
    return folded(
        fmt::format("{} by the target's place", measure.name),
        tableHtml(wide(all, {"item", "x_m", "y_m", "z_m"}, "system", systems, {{name, mean}}),
                  fmt::format("Mean {} in {} for each target, and the number of answers; centres in metres "
                              "in the avatar's frame, x to its left, y up, z ahead. Nothing is tested "
                              "here.",
                              measure.name, measure.unit),
                  numbering));
}

}  // namespace

Section measuredSection(const AnalysisResult& result, Numbering& figures, Numbering& numbering) {
    const Places places = measuredSpace(result.table);
    std::string out, folded_tables;
    int number = 0;
    for (const Measure& measure : result.table.measures) {
        if (measure.unit.empty() || std::none_of(places.begin(), places.end(), [&](const MeasuredPlace& one) {
                return one.measure == measure.name;
            }))
            continue;
        out += figuresPlaced(figureHtml(spaceFigure(result, measure, places, ++number, figures)));
        folded_tables += spaceTable(result, measure, numbering);
    }
    return {"Errors over the target space", out + folded_tables};
}

}  // namespace deixis::results
