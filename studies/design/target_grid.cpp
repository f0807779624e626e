#include "studies/design/target_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace deixis::studies {

namespace {

double rounded(double metres) {
    return std::round(metres * 1e4) / 1e4 + 0.0;  // no negative zero
}

/// A place as azimuth and elevation (radians) and distance from a centre, and back.
Vec3 sphericalOf(const Vec3& centre, const Vec3& place) {
    const Vec3 there = place - centre;
    const double distance = glm::length(there);
    const double elevation = distance > 0.0 ? std::asin(std::clamp(there.y / distance, -1.0, 1.0)) : 0.0;
    return {std::atan2(there.x, there.z), elevation, distance};
}
Vec3 placeOf(const Vec3& centre, const Vec3& spherical) {
    const double level = spherical.z * std::cos(spherical.y);
    return centre + Vec3(level * std::sin(spherical.x), spherical.z * std::sin(spherical.y),
                         level * std::cos(spherical.x));
}

}  // namespace

Result<std::vector<TargetItem>> targetGrid(const std::vector<Vec3>& training, int count, GridShape shape) {
    if (training.empty()) return fail("", "a grid needs training targets for its limits; there are none");
    const int side = std::max(2, static_cast<int>(std::lround(std::cbrt(std::max(0, count)))));
    if (side * side * side != count) {
        const int below = side * side * side > count ? std::max(2, side - 1) : side;
        return fail("", fmt::format("a grid of {} points cannot have equally many along x, y and z", count),
                    fmt::format("Choose a cube number, such as {} or {}", below * below * below,
                                (below + 1) * (below + 1) * (below + 1)));
    }
    Vec3 centre(0.0);
    for (const Vec3& target : training) centre.y += target.y / static_cast<double>(training.size());
    const auto coordinatesOf = [&](const Vec3& target) {
        return shape == GridShape::box ? target : sphericalOf(centre, target);
    };
    Vec3 low = coordinatesOf(training.front());
    Vec3 high = low;
    for (const Vec3& target : training) {
        low = glm::min(low, coordinatesOf(target));
        high = glm::max(high, coordinatesOf(target));
    }
    const auto at = [&](int axis, int step) {
        return low[axis] + (high[axis] - low[axis]) * step / (side - 1);
    };
    const auto width = std::max<std::size_t>(4, std::to_string(count).size());
    std::vector<TargetItem> items;
    items.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < side; ++k)
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                TargetItem item;
                item.id = fmt::format("G{:0{}}", items.size() + 1, width);
                const Vec3 coordinates(at(0, i), at(1, j), at(2, k));
                const Vec3 place = shape == GridShape::box ? coordinates : placeOf(centre, coordinates);
                item.target = {rounded(place.x), rounded(place.y), rounded(place.z)};
                items.push_back(std::move(item));
            }
    return items;
}

}  // namespace deixis::studies
