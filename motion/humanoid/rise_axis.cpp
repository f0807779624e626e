#include "motion/humanoid/rise_axis.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace deixis::motion {

std::optional<Vec3> riseAxis(const std::vector<Vec3>& rises) {
    constexpr double shortest_m = 1e-9, min_cosine = 0.707;  // 45 degrees
    Vec3 sum(0.0);
    for (const Vec3& rise : rises)
        if (const double length = glm::length(rise); length > shortest_m && std::isfinite(length))
            sum += rise / length;
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(sum[i]) > std::abs(sum[axis])) axis = i;
    const double length = glm::length(sum);
    if (length < shortest_m || std::abs(sum[axis]) < min_cosine * length) return std::nullopt;
    Vec3 out(0.0);
    out[axis] = sum[axis] < 0.0 ? -1.0 : 1.0;
    return out;
}

}  // namespace deixis::motion
