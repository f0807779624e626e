// Correct choices over the target space.
#include <fmt/core.h>

#include <algorithm>

#include "figures.hpp"
#include "results/page/figure_places.hpp"

namespace deixis::results {

Figure placesFigure(const AnalysisResult& result, Numbering& figures) {
    constexpr double max_row_px = 120.0;
    const auto& systems = result.table.systems;
    std::vector<Vec3> places;
    for (const TargetPlace& place : result.target_space) places.push_back(place.position_m);
    const SpaceBox space = SpaceBox::around(places);
    SpacePlot plot(systems, space.widened(1.0 / 18.0));  // no point stands on a panel's frame
    for (const TargetPlace& place : result.target_space) {
        const auto found = std::find(systems.begin(), systems.end(), place.system);
        if (found == systems.end()) continue;  // all of them together
        const Vec3& at = place.position_m;
        plot.point(static_cast<std::size_t>(found - systems.begin()), at, place.mean,
                   fmt::format("{}, {}: {:.0f} of {} at x {:.2f}, y {:.2f}, z {:.2f} m", place.system,
                               place.target_id, place.mean * place.n, place.n, at.x, at.y, at.z));
    }
    return {"places",
            fmt::format("{} Correct choices by the target's place, the avatar's left on the left: {}",
                        figures.next(), spaceText(space)),
            fmt::format("Share of correct choices at each target's place, from above and from behind the "
                        "avatar, in a row for each of {} systems; a table of this page has the numbers.",
                        systems.size()),
            plot.spec(0.0, 1.0, ".0%", max_row_px), true};
}

}  // namespace deixis::results
