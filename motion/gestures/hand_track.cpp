#include "hand_track.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace deixis::motion {

namespace {

/// Frames in a time, at least one.
int framesIn(double time_s, double frame_time_s) {
    return std::max(1, static_cast<int>(std::lround(time_s / frame_time_s)));
}

/// Least-squares slope over `half` frames to each side, fewer at the ends; units a second.
std::vector<double> slopeLengths(const std::vector<Vec3>& values, int half, double frame_time_s) {
    const int count = static_cast<int>(values.size());
    std::vector<double> out;
    out.reserve(values.size());
    for (int f = 0; f < count; ++f) {
        const int w = std::min({half, f, count - 1 - f});
        // At an end itself, from its one neighbour.
        const int low = w > 0 ? f - w : std::max(0, f - 1);
        const int high = w > 0 ? f + w : std::min(count - 1, f + 1);
        const double middle = 0.5 * (low + high);
        Vec3 sum(0.0);
        double weights = 0.0;
        for (int i = low; i <= high; ++i) {
            sum += (i - middle) * values[static_cast<std::size_t>(i)];
            weights += (i - middle) * (i - middle);
        }
        out.push_back(weights > 0.0 ? glm::length(sum) / (weights * frame_time_s) : 0.0);
    }
    return out;
}

}  // namespace

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
    const double dt = recording.frame_time_s;
    for (std::size_t side = 0; side < 2; ++side) {
        HandTrack& track = tracks[side];
        track.arm_length_m /= static_cast<double>(recording.frames.size());
        constexpr double half_window_s = 1.0 / 15.0;
        track.speed_m_s = slopeLengths(track.reach, framesIn(half_window_s, dt), dt);
        for (Vec3& reach : track.reach) reach /= track.arm_length_m;
        const int step = framesIn(1.0 / 30.0, dt);
        for (int f = 0; f < recording.frameCount(); ++f) {
            const int before = std::max(0, f - step);
            const Vec3 way =
                hands[side][static_cast<std::size_t>(f)] - hands[side][static_cast<std::size_t>(before)];
            track.step_speed_m_s.push_back(f > before ? glm::length(way) / ((f - before) * dt) : 0.0);
        }
    }
    return tracks;
}

}  // namespace deixis::motion
