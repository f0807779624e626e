#include "studies/design/placement.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace deixis::studies {

namespace {

const Vec3 forward{0.0, 0.0, -1.0};
constexpr double min_scale = 0.5;
constexpr double max_scale = 2.0;

/// The direction in which the person faces, laid on the floor; not of unit length.
Vec3 facing(const Quat& orientation) {
    constexpr double steep = 0.985;  // the sine of 80 degrees: beyond, a looking direction has no heading
    const Vec3 looking = orientation * forward;
    Vec3 along = looking;
    if (std::abs(looking.y) > steep) {
        // The top of the head points ahead where the face looks at the floor, and behind where it looks up.
        along = orientation * up;
        if (looking.y > 0.0) along = -along;
    }
    return {along.x, 0.0, along.z};
}

}  // namespace

Anchor anchorFromHead(const Pose& tracking_from_head) {
    const Vec3 ahead = facing(tracking_from_head.orientation);
    const Vec3& head = tracking_from_head.position;
    return {{{head.x, 0.0, head.z}, yawRotation(std::atan2(-ahead.x, -ahead.z))}, head.y};
}

Pose Placement::toStage(const Pose& tracking_from_x) const {
    return {scale * (turn_and_shift.orientation * tracking_from_x.position) + turn_and_shift.position,
            turn_and_shift.orientation * tracking_from_x.orientation};
}

Ray Placement::toStage(const Ray& in_tracking) const {
    return {toStage(Pose{in_tracking.origin, no_rotation}).position,
            turn_and_shift.orientation * in_tracking.direction};
}

Pose Placement::toTracking(const Pose& stage_from_x) const {
    const Quat back = glm::conjugate(turn_and_shift.orientation);
    return {back * (stage_from_x.position - turn_and_shift.position) / scale,
            back * stage_from_x.orientation};
}

Placement placementFor(const Anchor& anchor, const Pose& stage_from_viewer, EyeLevel eye_level,
                       double avatar_eye_height_m) {
    Placement placement;
    if (eye_level == EyeLevel::scale) {
        constexpr double lowest_eyes_m = 0.1;  // a head on the floor is no height to measure by
        placement.scale = std::clamp(avatar_eye_height_m / std::max(anchor.eye_height_m, lowest_eyes_m),
                                     min_scale, max_scale);
    }
    const Quat turn = stage_from_viewer.orientation * glm::conjugate(anchor.tracking_from_anchor.orientation);
    placement.turn_and_shift = {
        stage_from_viewer.position - placement.scale * (turn * anchor.tracking_from_anchor.position), turn};
    if (eye_level == EyeLevel::raise)
        placement.turn_and_shift.position.y += avatar_eye_height_m - anchor.eye_height_m;
    return placement;
}

double distanceFromPlace(const Anchor& anchor, const Pose& tracking_from_head) {
    const Vec3 away = tracking_from_head.position - anchor.tracking_from_anchor.position;
    return std::hypot(away.x, away.z);
}

}  // namespace deixis::studies
