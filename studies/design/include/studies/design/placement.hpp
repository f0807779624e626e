// Where the stage is in the room in which a headset is tracked: pure geometry, no device.
//
// The participant keeps one physical place, the anchor, for the whole session; for each layout the stage
// is turned and shifted under it, about the vertical only. Pitch, roll and, unless the study asks for it,
// height are never changed: the tracked floor stays the floor.
#pragma once

#include "core/pose.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::studies {

/// The physical place: on the tracked floor, facing a heading.
struct Anchor {
    Pose tracking_from_anchor{};  ///< y = 0; rotated about +y only; -z is the person's forward
    double eye_height_m = 0.0;    ///< of the head above the tracked floor when the anchor was set
};

/// From a head pose. Its heading is that of the looking direction laid on the floor; looking within 10
/// degrees of straight down, that of the top of the head, and of straight up, the opposite one.
[[nodiscard]] Anchor anchorFromHead(const Pose& tracking_from_head);

/// A turn about +y, a shift, and a uniform scale: stage point = scale * (turn * tracking point) + shift.
/// Orientations are turned alone.
struct Placement {
    double scale = 1.0;  ///< metres of the stage per metre of the room
    Pose turn_and_shift{};

    [[nodiscard]] Pose toStage(const Pose& tracking_from_x) const;
    [[nodiscard]] Ray toStage(const Ray& in_tracking) const;
    [[nodiscard]] Pose toTracking(const Pose& stage_from_x) const;
};

/// The placement that puts the anchor at `stage_from_viewer` (on the floor, -z forward). With
/// EyeLevel::measured, floor meets floor at true scale. With EyeLevel::raise the whole stage is lifted or
/// lowered so that the avatar's eyes are level with the person's; with EyeLevel::scale the whole stage is
/// scaled for that, the avatar's floor staying the floor. The balls go with the avatar in both: it must go on
/// pointing at them. The scale is kept within 0.5..2.
[[nodiscard]] Placement placementFor(const Anchor& anchor, const Pose& stage_from_viewer, EyeLevel eye_level,
                                     double avatar_eye_height_m);

/// How far the head stands from the anchor, along the room's floor, in metres of the room.
[[nodiscard]] double distanceFromPlace(const Anchor& anchor, const Pose& tracking_from_head);

}  // namespace deixis::studies
