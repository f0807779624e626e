// Between the points of a picture and the world that it shows. Plain geometry, without a window.
#pragma once

#include <optional>

#include "core/pose.hpp"

namespace deixis::app {

/// Right and up from the middle of the picture; the picture's edges are at -1 and 1.
struct PicturePoint {
    double x = 0.0;
    double y = 0.0;
};

/// The ray from the eye through a point of the picture.
[[nodiscard]] Ray rayThrough(const Pose& stage_from_eye, double vertical_view_rad, double aspect,
                             const PicturePoint& at);

/// Where a point of the stage is in the picture; none: behind the eye.
[[nodiscard]] std::optional<PicturePoint> inPicture(const Pose& stage_from_eye, double vertical_view_rad,
                                                    double aspect, const Vec3& point);

}  // namespace deixis::app
