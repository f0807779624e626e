#include "motion/upper_body/upper_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/skeleton/clip_edit.hpp"
#include "motion/upper_body/upper_body_clip.hpp"

namespace deixis::motion {

namespace {

constexpr double shortest_direction = 1e-6;

UpperBone mirroredBone(std::size_t bone) {
    switch (const auto b = static_cast<UpperBone>(bone)) {
        case UpperBone::left_shoulder:
            return UpperBone::right_shoulder;
        case UpperBone::left_upper_arm:
            return UpperBone::right_upper_arm;
        case UpperBone::left_forearm:
            return UpperBone::right_forearm;
        case UpperBone::right_shoulder:
            return UpperBone::left_shoulder;
        case UpperBone::right_upper_arm:
            return UpperBone::left_upper_arm;
        case UpperBone::right_forearm:
            return UpperBone::left_forearm;
        default:
            return b;
    }
}

Vec3 alongArc(const Vec3& a, const Vec3& b, double t) {
    const double angle = angleBetween(a, b);
    constexpr double no_arc = 1e-9;
    if (angle < no_arc || angle > pi - no_arc) return t < 0.5 ? a : b;
    return glm::normalize((std::sin((1.0 - t) * angle) * a + std::sin(t * angle) * b) / std::sin(angle));
}

UpperBodyPose makeRelaxed() {
    UpperBodyPose pose = upperBodyOf(relaxedPose(referenceHumanoid()));
    const UpperBodyPose other = mirrored(pose);  // it is its own mirror image, but for rounding
    for (std::size_t b = 0; b < upper_bone_count; ++b)
        pose.directions[b] = glm::normalize(pose.directions[b] + other.directions[b]);
    return pose;
}

}  // namespace

std::size_t frameCountOf(double duration_s) {
    constexpr double rounding = 1e-9;  // 4.2 s are 63 frames, although 15 times 4.2 is a little more
    const double frames = std::ceil(duration_s * upper_body_fps - rounding);
    return frames > 1.0 ? static_cast<std::size_t>(frames) : 1;
}

const UpperBodyPose& relaxedUpperBody() {
    static const UpperBodyPose pose = makeRelaxed();
    return pose;
}

UpperBodyJoints jointsOf(const UpperBodyPose& pose) {
    UpperBodyJoints joints{};
    for (std::size_t b = 0; b < upper_bone_count; ++b) {
        const auto& [from, to, length_m] = upper_bones[b];
        joints[static_cast<std::size_t>(to)] =
            joints[static_cast<std::size_t>(from)] + length_m * pose.directions[b];
    }
    return joints;
}

UpperBodyPose poseFromJoints(const UpperBodyJoints& joints) {
    UpperBodyPose pose;
    for (std::size_t b = 0; b < upper_bone_count; ++b) {
        const Vec3 along = joints[static_cast<std::size_t>(upper_bones[b].to)] -
                           joints[static_cast<std::size_t>(upper_bones[b].from)];
        pose.directions[b] = glm::length(along) > shortest_direction ? glm::normalize(along)
                                                                     : relaxedUpperBody().directions[b];
    }
    return pose;
}

std::array<double, upper_body_numbers> numbersOf(const UpperBodyPose& pose) {
    std::array<double, upper_body_numbers> numbers{};
    for (std::size_t i = 0; i < upper_body_numbers; ++i)
        numbers[i] = pose.directions[i / 3][static_cast<int>(i % 3)];
    return numbers;
}

Result<UpperBodyPose> poseFromNumbers(std::span<const double> numbers) {
    if (numbers.size() != upper_body_numbers)
        return fail("", fmt::format("found {} numbers, expected {} (x y z of {} directions)", numbers.size(),
                                    upper_body_numbers, upper_bone_count));
    UpperBodyPose pose;
    for (std::size_t b = 0; b < upper_bone_count; ++b) {
        const Vec3 along(numbers[3 * b], numbers[3 * b + 1], numbers[3 * b + 2]);
        const double length = glm::length(along);
        if (!(length > shortest_direction) || !std::isfinite(length))
            return fail("", fmt::format("found no direction for bone {}", b));
        pose.directions[b] = along / length;
    }
    return pose;
}

UpperBodyPose interpolate(const UpperBodyPose& a, const UpperBodyPose& b, double t) {
    UpperBodyPose pose;
    for (std::size_t i = 0; i < upper_bone_count; ++i)
        pose.directions[i] = alongArc(a.directions[i], b.directions[i], t);
    return pose;
}

UpperBodyPose sample(const UpperBodyMotion& motion, double time_s) {
    const double last = static_cast<double>(motion.frames.size()) - 1.0;
    const double place = std::clamp(time_s * upper_body_fps, 0.0, last);
    const auto before = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(before);
    if (share == 0.0) return motion.frames[before];
    return interpolate(motion.frames[before], motion.frames[before + 1], share);
}

UpperBodyMotion atSpeed(const UpperBodyMotion& motion, double speed) {
    const double steps = (static_cast<double>(motion.frames.size()) - 1.0) / speed;
    const auto whole_steps = static_cast<std::size_t>(std::lround(steps));
    UpperBodyMotion out;
    // The speed is rounded to whole frames, so that the last pose is met, too.
    for (std::size_t f = 0; f <= whole_steps; ++f) {
        const double share =
            whole_steps > 0 ? static_cast<double>(f) / static_cast<double>(whole_steps) : 0.0;
        const double time_s =
            share * (static_cast<double>(motion.frames.size()) - 1.0) * upper_body_frame_time_s;
        out.frames.push_back(f == whole_steps && f > 0 ? motion.frames.back() : sample(motion, time_s));
    }
    return out;
}

UpperBodyPose mirrored(const UpperBodyPose& pose) {
    UpperBodyPose out;
    for (std::size_t b = 0; b < upper_bone_count; ++b) out.directions[b] = mirrored(pose[mirroredBone(b)]);
    return out;
}

UpperBodyMotion mirrored(const UpperBodyMotion& motion) {
    UpperBodyMotion out;
    out.frames.reserve(motion.frames.size());
    for (const UpperBodyPose& pose : motion.frames) out.frames.push_back(mirrored(pose));
    return out;
}

}  // namespace deixis::motion
