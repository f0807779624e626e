#include "replay_scene.hpp"

#include <algorithm>
#include <utility>

#include "app/window/frame_scene.hpp"
#include "core/room.hpp"
#include "studies/study_file/standing.hpp"

namespace deixis::app {

namespace {

const glm::vec3 head_colour{0.20F, 0.55F, 0.95F};
const glm::vec3 hand_colour{0.95F, 0.45F, 0.20F};

// Nobody's head: a place where nothing was recorded of it.
Pose assumedHead(const studies::RecordedTrial& trial) {
    constexpr double lowest_eyes_m = 0.5;
    if (trial.stage_from_head.position.y > lowest_eyes_m) return trial.stage_from_head;
    constexpr double eye_height_m = 1.65;
    return studies::viewerPose(trial.layout) * Pose{{0.0, eye_height_m, 0.0}, no_rotation};
}

// How far a camera may go from a point within the room before it would stand in a wall or nearly so.
double wayToWall(const Vec3& from, const Vec3& direction) {
    constexpr double clearance_m = 0.15;
    const Vec3 low = room_low + clearance_m;
    const Vec3 high = room_high - clearance_m;
    double way_m = 100.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double to = direction[axis] < 0.0 ? low[axis] : high[axis];
        if (direction[axis] != 0.0) way_m = std::min(way_m, (to - from[axis]) / direction[axis]);
    }
    return std::max(0.0, way_m);
}

Pose orbit(const studies::RecordedTrial& trial, const OutsideView& view) {
    const Pose viewer = studies::viewerPose(trial.layout);
    constexpr double middle_height_m = 1.0;
    const Vec3 middle = 0.5 * viewer.position + Vec3(0.0, middle_height_m, 0.0);
    const Quat turn = viewer.orientation * yawRotation(view.azimuth_rad) *
                      glm::angleAxis(-view.elevation_rad, Vec3(1.0, 0.0, 0.0));
    const Vec3 back = turn * Vec3(0.0, 0.0, 1.0);
    return {middle + std::min(view.distance_m, wayToWall(middle, back)) * back, turn};
}

void addTrail(renderer::Scene& scene, std::vector<Vec3> points, const glm::vec3& colour) {
    if (points.size() < 2) return;
    scene.trails.push_back({std::move(points), colour});
}

}  // namespace

renderer::Scene sceneByTheirEyes(const studies::TrialReplay& replay, const studies::RecordedTrial& trial,
                                 double time_s) {
    return sceneFromFrame(replay.at(time_s), replay.head(time_s).value_or(assumedHead(trial)));
}

renderer::Scene sceneFromOutside(const studies::TrialReplay& replay, const studies::RecordedTrial& trial,
                                 double time_s, const OutsideView& view, double trail_s) {
    renderer::Scene scene = sceneFromFrame(replay.at(time_s), orbit(trial, view));
    if (const auto head = replay.head(time_s)) scene.heads.push_back({*head, head_colour});
    if (trail_s > 0.0) {
        addTrail(scene, replay.headTrail(time_s, trail_s), head_colour);
        addTrail(scene, replay.handTrail(time_s, trail_s), hand_colour);
    }
    return scene;
}

}  // namespace deixis::app
