#include "motion_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace deixis::server {

namespace {

using nlohmann::json;

constexpr double millionths = 1e6;

bool turns(const motion::Clip& clip, std::size_t joint) {
    return std::any_of(clip.frames.begin(), clip.frames.end(), [&](const motion::LocalPose& frame) {
        const Quat& q = frame.joints[joint].orientation;
        return std::max({std::abs(q.x), std::abs(q.y), std::abs(q.z)}) > 0.5 / millionths;
    });
}

}  // namespace

double rounded(double value, double steps) {
    const double out = std::round(value * steps) / steps;
    return out == 0.0 ? 0.0 : out;  // not -0
}

Shape framesShape() {
    return listShape(
        "Frames at 15 a second; frame i is at i / 15 s",
        listShape("x y z of nine directions of unit length: neck, nose, head top, left shoulder, upper "
                  "arm, forearm, right shoulder, upper arm, forearm. Metres, y up, facing +z, its left +x",
                  numberShape("", -1.01, 1.01), motion::upper_body_numbers, motion::upper_body_numbers),
        1, max_motion_frames);
}

json framesJson(const motion::UpperBodyMotion& motion) {
    json out = json::array();
    for (const motion::UpperBodyPose& pose : motion.frames) {
        json frame = json::array();
        for (const double number : motion::numbersOf(pose)) frame.push_back(rounded(number, millionths));
        out.push_back(std::move(frame));
    }
    return out;
}

Result<motion::UpperBodyMotion> motionFromJson(const json& frames, const std::string& field) {
    motion::UpperBodyMotion motion;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const auto numbers = frames[i].get<std::array<double, motion::upper_body_numbers>>();
        const auto pose = motion::poseFromNumbers(numbers);
        if (!pose) return fail(fmt::format("{}[{}]", field, i), pose.error().message, pose.error().hint);
        motion.frames.push_back(*pose);
    }
    return motion;
}

Shape tracksShape() {
    return objectShape(
        "How bones of the avatar turn, from its T pose",
        {mustField("fps", integerShape("Frames a second", 15, 15)),
         mustField("bones",
                   listShape("Names of VRM; bones that are not named stay at rest", textShape("", 1))),
         mustField("rotations",
                   listShape("For each frame the quaternions x y z w of all these bones, in their parents",
                             listShape("", numberShape("", -1.01, 1.01))))});
}

json tracksJson(const motion::Clip& clip) {
    std::vector<std::size_t> turned;
    json bones = json::array();
    for (std::size_t joint = 0; joint < clip.skeleton.joints.size(); ++joint)
        if (turns(clip, joint)) {
            turned.push_back(joint);
            bones.push_back(clip.skeleton.joints[joint].name);
        }
    json rotations = json::array();
    for (const motion::LocalPose& frame : clip.frames) {
        json row = json::array();
        for (const std::size_t joint : turned) {
            const Quat& q = frame.joints[joint].orientation;
            for (const double part : {q.x, q.y, q.z, q.w}) row.push_back(rounded(part, millionths));
        }
        rotations.push_back(std::move(row));
    }
    return {{"fps", static_cast<int>(motion::upper_body_fps)},
            {"bones", std::move(bones)},
            {"rotations", std::move(rotations)}};
}

}  // namespace deixis::server
