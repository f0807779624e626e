#include "studies/standing.hpp"

namespace deixis::studies {

Pose viewerPose(const Layout& layout) {
    // The viewer looks along -z, a heading is where +z would turn to: half a turn apart.
    return {{layout.viewer_x_m, 0.0, layout.viewer_z_m},
            yawRotation(radiansFromDegrees(layout.heading_deg) + pi)};
}

std::array<Vec3, 2> pairPlaces(const Pose& stage_from_viewer) {
    constexpr double aside_m = 0.6;
    const Vec3 right = aside_m * (stage_from_viewer.orientation * Vec3(1.0, 0.0, 0.0));
    return {-right, right};
}

}  // namespace deixis::studies
