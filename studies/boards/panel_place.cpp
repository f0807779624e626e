#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>

#include "studies/boards/panel_layout.hpp"

namespace deixis::studies {

namespace {

constexpr double message_distance_m = 1.3;
constexpr double message_below_eyes_m = 0.12;
constexpr double lectern_distance_m = 1.3;
constexpr double lectern_below_eyes_m = 0.47;
constexpr double lectern_top_below_eyes_m = 0.25;  // of a board that is too high for that
constexpr double lectern_tilt_rad = radiansFromDegrees(18.0);
constexpr double bench_top_below_eyes = 0.30;  // of its distance: 15 degrees, the hips of an avatar 3 m away
constexpr double bench_foot_rad =
    radiansFromDegrees(-46.5);  // no lower: what a flat screen shows, with a sign
constexpr double bench_farthest_m = 2.05;
constexpr double bench_step_m = 0.1;
constexpr double desk_distance_m = 1.1;
constexpr double desk_below_eyes_m = 0.72;
constexpr double desk_tilt_rad = radiansFromDegrees(32.0);
constexpr double desk_step_rad = radiansFromDegrees(5.0);  // to one side or the other of balls
constexpr int desk_steps = 12;                             // 60 degrees
constexpr double clear_of_ball = 1.3;                      // radii of a ball around its centre
constexpr double above_floor_m = 0.15;                     // a board's foot, before a seated person
constexpr double avatar_reach_m = 0.38;    // half its width with the arms hanging, and a little air
constexpr double sign_above_head_m = 0.3;  // from the head joint: hair and some air

/// How far to the left (radians) a panel must stand, at least at `bearing`, so that an avatar nearer than it
/// does not cover it: where the viewer stands at the avatar's shoulder. `bearing` itself where the avatar is
/// farther away than the panel.
double bearingBesideAvatar(const Panel& panel, const Pose& stage_from_viewer, double distance_m,
                           double bearing) {
    const Vec3 avatar = transformPoint(inverse(stage_from_viewer), Vec3(0.0));
    const double away_m = std::hypot(avatar.x, avatar.z);
    if (away_m > distance_m + avatar_reach_m) return bearing;
    const double avatar_bearing = std::atan2(-avatar.x, -avatar.z);
    const double apart =
        std::asin(std::min(1.0, avatar_reach_m / away_m)) + std::atan(panel.width_m / 2.0 / distance_m);
    if (std::abs(avatar_bearing - bearing) >= apart) return bearing;
    return avatar_bearing > bearing ? avatar_bearing - apart : avatar_bearing + apart;
}

/// The panel's centre at `distance_m` before the viewer (or as far to the left as told) and `height_m` above
/// the floor, or as much higher as its foot needs, its top leaning away.
Pose stand(const Panel& panel, const Pose& stage_from_viewer, double distance_m, double height_m,
           double tilt_rad, double bearing = 0.0) {
    const double min_height_m = above_floor_m + panel.height_m / 2.0 * std::cos(tilt_rad);
    const Quat tilt(std::cos(tilt_rad / 2.0), -std::sin(tilt_rad / 2.0), 0.0, 0.0);
    const double clear = bearingBesideAvatar(panel, stage_from_viewer, distance_m, bearing);
    const Pose turned{Vec3(0.0), yawRotation(clear)};
    const Pose turned_from_centre{{0.0, std::max(height_m, min_height_m), -distance_m}, tilt};
    const Pose centre_from_corner{{-panel.width_m / 2.0, -panel.height_m / 2.0, 0.0}, no_rotation};
    return stage_from_viewer * turned * turned_from_centre * centre_from_corner;
}

/// A lectern, or lower and lying flatter where its top would reach higher than told.
Pose lectern(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m, double top_below_eyes_m,
             double distance_m = lectern_distance_m, double bearing = 0.0) {
    const double half_m = panel.height_m / 2.0 * std::cos(lectern_tilt_rad);
    const double below_eyes_m = std::max(lectern_below_eyes_m, top_below_eyes_m + half_m);
    // Square to the line of sight, as far as the usual one is.
    const double tilt_rad = lectern_tilt_rad + std::atan2(below_eyes_m, distance_m) -
                            std::atan2(lectern_below_eyes_m, lectern_distance_m);
    return stand(panel, stage_from_viewer, distance_m, eye_height_m - below_eyes_m, tilt_rad, bearing);
}

Pose desk(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m, double bearing) {
    return stand(panel, stage_from_viewer, desk_distance_m, eye_height_m - desk_below_eyes_m, desk_tilt_rad,
                 bearing);
}

using Stand = Pose (*)(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m,
                       double bearing);

Pose lecternAt(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m, double bearing) {
    return lectern(panel, stage_from_viewer, eye_height_m, lectern_top_below_eyes_m, lectern_distance_m,
                   bearing);
}

/// The first of these places, turned aside step by step to either side, at which no ball is overlapped.
std::optional<Pose> freePose(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m,
                             const std::vector<BallView>& balls, std::initializer_list<Stand> places) {
    const Vec3 eyes = stage_from_viewer.position + Vec3(0.0, eye_height_m, 0.0);
    Panel placed = panel;
    for (int step = 0; step <= desk_steps; ++step)
        for (const Stand place : places)
            for (const double bearing : {step * desk_step_rad, -step * desk_step_rad}) {
                placed.stage_from_panel = place(panel, stage_from_viewer, eye_height_m, bearing);
                const bool free = std::none_of(balls.begin(), balls.end(), [&](const BallView& ball) {
                    return overlapsBall(placed, eyes, ball);
                });
                if (free) return placed.stage_from_panel;
            }
    return std::nullopt;
}

}  // namespace

bool overlapsBall(const Panel& panel, const Vec3& eyes, const BallView& ball) {
    const Vec3 sight = ball.centre - eyes;
    const Vec3 aside = glm::normalize(glm::cross(sight, up));
    const Vec3 above = glm::normalize(glm::cross(aside, sight));
    constexpr int around = 12;
    for (int i = 0; i < around; ++i) {
        const double angle = 2.0 * pi * i / around;
        const Vec3 edge = clear_of_ball * ball.radius_m * (std::cos(angle) * aside + std::sin(angle) * above);
        if (meetPanel(panel, {eyes, glm::normalize(sight + edge)})) return true;
    }
    return false;
}

Pose messagePose(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m) {
    return stand(panel, stage_from_viewer, message_distance_m, eye_height_m - message_below_eyes_m, 0.0);
}

Pose lecternPose(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m) {
    return lecternAt(panel, stage_from_viewer, eye_height_m, 0.0);
}

Pose benchPose(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m) {
    const Vec3 foot(panel.width_m / 2.0, 0.0, 0.0);
    for (double distance_m = lectern_distance_m;; distance_m += bench_step_m) {
        const Pose pose =
            lectern(panel, stage_from_viewer, eye_height_m, bench_top_below_eyes * distance_m, distance_m);
        const Vec3 seen = transformPoint(inverse(stage_from_viewer) * pose, foot);
        const double foot_rad = std::atan2(seen.y - eye_height_m, std::hypot(seen.x, seen.z));
        if (foot_rad >= bench_foot_rad || distance_m + bench_step_m > bench_farthest_m) return pose;
    }
}

Pose deskPose(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m) {
    return desk(panel, stage_from_viewer, eye_height_m, 0.0);
}

Pose deskPoseBesideBalls(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m,
                         const std::vector<BallView>& balls) {
    return freePose(panel, stage_from_viewer, eye_height_m, balls, {desk})
        .value_or(desk(panel, stage_from_viewer, eye_height_m, 0.0));
}

std::optional<Pose> poseBesideBalls(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m,
                                    const std::vector<BallView>& balls) {
    return freePose(panel, stage_from_viewer, eye_height_m, balls, {lecternAt, desk});
}

Pose signPose(const Panel& sign, const Vec3& avatar_head, const Vec3& eyes) {
    const Vec3 centre = avatar_head + Vec3(0.0, sign_above_head_m + sign.height_m / 2.0, 0.0);
    const Vec3 towards = eyes - centre;
    const double along_floor_m = std::hypot(towards.x, towards.z);
    const double yaw_rad = along_floor_m > 1e-6 ? std::atan2(towards.x, towards.z) : 0.0;
    const double down_rad = std::atan2(-towards.y, std::max(along_floor_m, 1e-6));
    const Quat pitch(std::cos(down_rad / 2.0), std::sin(down_rad / 2.0), 0.0, 0.0);
    const Pose centre_from_corner{{-sign.width_m / 2.0, -sign.height_m / 2.0, 0.0}, no_rotation};
    return Pose{centre, yawRotation(yaw_rad) * pitch} * centre_from_corner;
}

}  // namespace deixis::studies
