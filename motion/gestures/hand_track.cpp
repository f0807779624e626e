#include "hand_track.hpp"

#include <glm/geometric.hpp>

#include "motion/skeleton/kinematics.hpp"

namespace deixis::motion {

std::vector<HandTrack> trackHands(const Clip& recording, const HumanoidMap& map) {
    std::vector<HandTrack> tracks(2);
    std::vector<std::vector<Vec3>> hands(2);
    std::vector<Pose> world;
    Vec3 left(1.0, 0.0, 0.0);
    for (const LocalPose& frame : recording.frames) {
        worldPose(recording.skeleton, frame, world);
        const auto at = [&](Bone bone) { return world[static_cast<std::size_t>(map[bone])].position; };
        Vec3 across = at(Bone::leftUpperArm) - at(Bone::rightUpperArm);
        across.y = 0.0;
        if (glm::length(across) > 1e-6) left = glm::normalize(across);
        const Vec3 ahead = glm::cross(left, up);
        for (const Side side : {Side::left, Side::right}) {
            const ArmBones arm = armBones(side);
            HandTrack& track = tracks[static_cast<std::size_t>(side)];
            const Vec3 hand = at(arm.hand);
            const Vec3 from_shoulder = hand - at(arm.upper_arm);
            track.arm_length_m +=
                glm::length(at(arm.lower_arm) - at(arm.upper_arm)) + glm::length(hand - at(arm.lower_arm));
            track.reach.emplace_back(glm::dot(from_shoulder, left), from_shoulder.y,
                                     glm::dot(from_shoulder, ahead));
            hands[static_cast<std::size_t>(side)].push_back(hand);
        }
    }
    for (std::size_t side = 0; side < 2; ++side) {
        HandTrack& track = tracks[side];
        track.arm_length_m /= static_cast<double>(recording.frames.size());
        track.trajectory.speed_m_s = speeds(track.reach, recording.frame_time_s);
        track.step_speed_m_s = speeds(hands[side], recording.frame_time_s, {.before_s = 1.0 / 30.0});
        for (Vec3& reach : track.reach) reach /= track.arm_length_m;
    }
    return tracks;
}

}  // namespace deixis::motion
