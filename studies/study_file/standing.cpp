#include "studies/study_file/standing.hpp"

namespace deixis::studies {

std::string_view standingName(Standing standing) {
    return standing == Standing::headset ? "headset" : "desktop";
}

ViewerPlace viewerPlace(const Layout& layout, Standing standing) {
    if (standing == Standing::desktop && layout.desktop) return *layout.desktop;
    return {layout.viewer_x_m, layout.viewer_z_m, layout.heading_deg};
}

Pose viewerPose(const ViewerPlace& place) {
    // The viewer looks along -z, a heading is where +z would turn to: half a turn apart.
    return {{place.x_m, 0.0, place.z_m}, yawRotation(radiansFromDegrees(place.heading_deg) + pi)};
}

Pose viewerPose(const Layout& layout) {
    return viewerPose(viewerPlace(layout, Standing::headset));
}

Study standingAs(Study study, Standing standing) {
    for (Layout& layout : study.layouts) {
        const ViewerPlace place = viewerPlace(layout, standing);
        layout = {layout.name, place.x_m, place.z_m, place.heading_deg};
    }
    return study;
}

std::array<Vec3, 2> pairPlaces(const Pose& stage_from_viewer) {
    constexpr double aside_m = 0.6;
    const Vec3 right = aside_m * (stage_from_viewer.orientation * Vec3(1.0, 0.0, 0.0));
    return {-right, right};
}

}  // namespace deixis::studies
