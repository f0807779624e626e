#include "hand_track.hpp"

#include <algorithm>
#include <cmath>
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
        const auto& hand = hands[side];
        const std::size_t step = static_cast<std::size_t>(
            std::max(1L, std::lround(difference_half_span_s / recording.frame_time_s)));
        for (std::size_t f = 0; f < hand.size(); ++f) {
            const std::size_t before = f - std::min(f, step);
            const double time_s = static_cast<double>(f - before) * recording.frame_time_s;
            track.step_speed_m_s.push_back(f > 0 ? glm::length(hand[f] - hand[before]) / time_s : 0.0);
        }
        for (Vec3& reach : track.reach) reach /= track.arm_length_m;
    }
    return tracks;
}

}  // namespace deixis::motion
