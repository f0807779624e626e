#include <algorithm>
#include <cmath>

#include "studies/boards/panel_layout.hpp"

namespace deixis::studies {

namespace {

constexpr double track_inset_m = 0.04;
constexpr double track_height_m = 0.016;
constexpr double track_below_top_m = 0.055;  // its middle

bool inside(const PanelRect& box, double x, double y) {
    return x >= box.x && x <= box.x + box.width && y >= box.y && y <= box.y + box.height;
}

struct PlaneHit {
    double distance_m = 0.0;
    Vec3 point{0.0};  ///< in the panel's frame
};

std::optional<PlaneHit> meetPlane(const Panel& panel, const Ray& ray) {
    const Pose panel_from_stage = inverse(panel.stage_from_panel);
    const Vec3 origin = transformPoint(panel_from_stage, ray.origin);
    const Vec3 direction = panel_from_stage.orientation * ray.direction;
    if (std::abs(direction.z) < 1e-9) return std::nullopt;
    const double distance_m = -origin.z / direction.z;
    if (distance_m < 0.0) return std::nullopt;
    return PlaneHit{distance_m, origin + distance_m * direction};
}

/// Index of the enabled one that is met, or -1.
template <typename Part>
int met(const std::vector<Part>& parts, const Vec3& point) {
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i].enabled && inside(parts[i].box, point.x, point.y)) return static_cast<int>(i);
    return -1;
}

}  // namespace

PanelRect PanelSlider::track() const {
    const double inset = std::min(track_inset_m, 0.25 * box.width);
    const double below_top = std::min(track_below_top_m, 0.5 * box.height);
    return {box.x + inset, box.y + box.height - below_top - track_height_m / 2.0, box.width - 2.0 * inset,
            track_height_m};
}

int PanelSlider::valueAt(double x_m) const {
    const PanelRect line = track();
    const double share = std::clamp((x_m - line.x) / line.width, 0.0, 1.0);
    return low + static_cast<int>(std::floor(share * (high - low) + 0.5));
}

std::optional<PanelHit> meetPanel(const Panel& panel, const Ray& ray) {
    const auto plane = meetPlane(panel, ray);
    if (!plane || !inside({0.0, 0.0, panel.width_m, panel.height_m}, plane->point.x, plane->point.y))
        return std::nullopt;
    PanelHit hit;
    hit.distance_m = plane->distance_m;
    hit.x_m = plane->point.x;
    hit.button = met(panel.buttons, plane->point);
    hit.slider = met(panel.sliders, plane->point);
    hit.field = met(panel.fields, plane->point);
    return hit;
}

std::optional<double> alongPanel(const Panel& panel, const Ray& ray) {
    const auto plane = meetPlane(panel, ray);
    if (!plane) return std::nullopt;
    return plane->point.x;
}

}  // namespace deixis::studies
