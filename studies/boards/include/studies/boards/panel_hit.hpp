// What a ray hits on a board, and what a board hides.
#pragma once

#include <optional>

#include "core/pose.hpp"
#include "studies/station/station.hpp"

namespace deixis::studies {

struct PanelHit {
    double distance_m = 0.0;
    int button = -1;   ///< index of the enabled button that is met; -1: none
    int slider = -1;   ///< index of the enabled slider,
    double x_m = 0.0;  ///< and where along the panel, for PanelSlider::valueAt()
    int field = -1;    ///< index of the enabled field
};

/// Where the ray meets the board from either side; none if it passes it by.
[[nodiscard]] std::optional<PanelHit> meetPanel(const Panel& panel, const Ray& ray);

/// Whether a ball lies before or behind the panel for these eyes, or nearly.
[[nodiscard]] bool overlapsBall(const Panel& panel, const Vec3& eyes, const BallView& ball);

}  // namespace deixis::studies
