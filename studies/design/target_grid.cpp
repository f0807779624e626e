#include "studies/design/target_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace deixis::studies {

namespace {

double rounded(double metres) {
    return std::round(metres * 1e4) / 1e4 + 0.0;  // no negative zero
}

}  // namespace

Result<std::vector<TargetItem>> targetGrid(const std::vector<Vec3>& training, int count) {
    if (training.empty()) return fail("", "a grid needs training targets for its limits; there are none");
    const int side = std::max(2, static_cast<int>(std::lround(std::cbrt(std::max(0, count)))));
    if (side * side * side != count) {
        const int below = side * side * side > count ? std::max(2, side - 1) : side;
        return fail("", fmt::format("a grid of {} points cannot have equally many along x, y and z", count),
                    fmt::format("Choose a cube number, such as {} or {}", below * below * below,
                                (below + 1) * (below + 1) * (below + 1)));
    }
    Vec3 low = training.front();
    Vec3 high = training.front();
    for (const Vec3& target : training)
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], target[axis]);
            high[axis] = std::max(high[axis], target[axis]);
        }
    const auto at = [&](int axis, int step) {
        return rounded(low[axis] + (high[axis] - low[axis]) * step / (side - 1));
    };
    const auto width = std::max<std::size_t>(4, std::to_string(count).size());
    std::vector<TargetItem> items;
    items.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < side; ++k)
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                TargetItem item;
                item.id = fmt::format("G{:0{}}", items.size() + 1, width);
                item.target = {at(0, i), at(1, j), at(2, k)};
                items.push_back(std::move(item));
            }
    return items;
}

}  // namespace deixis::studies
