// Where a flat screen looks first in a trial of the game, so that nobody misses what is beside its view.
#pragma once

#include <vector>

#include "core/pose.hpp"
#include "motion/skeleton/skeleton.hpp"

namespace deixis::studies {

struct Panel;

/// Something round that is to be in view; metres, in the stage's frame.
struct Sphere {
    Vec3 centre{0.0};
    double radius_m = 0.0;
};

/// A direction, and what a view in it must hold.
struct FirstLook {
    double yaw_rad = 0.0;    ///< from straight ahead to the left
    double pitch_rad = 0.0;  ///< upwards
    /// Tangents of the angles to the farthest thing beside, above or below the middle of the view.
    double half_width = 0.0;
    double half_height = 0.0;
    friend bool operator==(const FirstLook&, const FirstLook&) = default;

    /// The vertical field of view in which all is seen with a twentieth of the picture free on every side,
    /// for a picture of this width by height: min_view_rad where that does, and never above
    /// max_view_rad.
    [[nodiscard]] double verticalView_rad(double aspect) const;
};
constexpr double min_view_rad = radiansFromDegrees(60.0);
constexpr double max_view_rad = radiansFromDegrees(84.0);

/// For eyes so high above the viewer's place (on the floor, -z is forward). The order of the spheres does not
/// matter; there must be one.
[[nodiscard]] FirstLook firstLook(const Pose& stage_from_viewer, double eye_height_m,
                                  const std::vector<Sphere>& seen);

/// A board's corners, for a view that is to hold it.
[[nodiscard]] std::vector<Sphere> panelCorners(const Panel& panel);

/// What a participant must see of a trial: its balls, and for each of them the arm that would point at it,
/// from the shoulder to the fingertip. All balls are alike here, so that a view of it never tells the target.
/// An avatar without arms is left out.
[[nodiscard]] std::vector<Sphere> pointingScene(const std::vector<Sphere>& balls,
                                                const motion::Skeleton& avatar,
                                                const motion::LocalPose& idle_pose);

}  // namespace deixis::studies
