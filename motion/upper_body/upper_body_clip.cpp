#include "motion/upper_body/upper_body_clip.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "motion/retarget/retarget.hpp"
#include "reference_points.hpp"

namespace deixis::motion {

namespace {

UpperBodyPose measured(const std::vector<Pose>& world) {
    using enum UpperJoint;
    const auto at = [&](Bone bone) { return world[indexOf(bone)].position; };
    UpperBodyJoints joints{};
    const auto put = [&](UpperJoint joint, const Vec3& position) {
        joints[static_cast<std::size_t>(joint)] = position;
    };
    put(spine, at(Bone::spine));
    put(neck, at(Bone::neck));
    put(nose, transformPoint(world[indexOf(Bone::head)], nose_in_head));
    put(head_top, transformPoint(world[indexOf(Bone::head)], top_in_head));
    put(left_shoulder, at(Bone::leftUpperArm));
    put(left_elbow, at(Bone::leftLowerArm));
    put(left_wrist, at(Bone::leftHand));
    put(right_shoulder, at(Bone::rightUpperArm));
    put(right_elbow, at(Bone::rightLowerArm));
    put(right_wrist, at(Bone::rightHand));
    const Vec3 ahead = world[indexOf(Bone::hips)].orientation * Vec3(0, 0, 1);
    const Quat to_front = yawRotation(-std::atan2(ahead.x, ahead.z));
    for (Vec3& joint : joints) joint = to_front * joint;
    return poseFromJoints(joints);
}

/// All bones behind the hands, as the reference humanoid stands in its rest pose.
void stretchFingers(LocalPose& pose) {
    for (auto bone = indexOf(Bone::leftThumbMetacarpal); bone < bone_count; ++bone)
        pose.joints[bone].orientation = no_rotation;
}

}  // namespace

UpperBodyPose upperBodyOf(const LocalPose& pose) {
    return measured(worldPose(referenceHumanoid(), pose));
}

Result<UpperBodyMotion> upperBodyOf(const Clip& clip, const HumanoidMap& map) {
    RetargetOptions options;
    options.plant_feet = false;
    auto on_reference = retarget(clip, map, referenceHumanoid(), mapByVrmNames(referenceHumanoid()), options);
    if (!on_reference) return tl::unexpected(on_reference.error());
    const auto resampled = resample(*on_reference, upper_body_frame_time_s);
    if (!resampled) return tl::unexpected(resampled.error());
    UpperBodyMotion motion;
    motion.frames.reserve(resampled->frames.size());
    for (const LocalPose& pose : resampled->frames) motion.frames.push_back(upperBodyOf(pose));
    return motion;
}

Clip avatarClip(const UpperBodyMotion& motion, bool relaxed_fingers) {
    Clip clip;
    clip.skeleton = referenceHumanoid();
    clip.frame_time_s = upper_body_frame_time_s;
    clip.frames.reserve(motion.frames.size());
    for (const UpperBodyPose& pose : motion.frames) {
        clip.frames.push_back(avatarPose(pose));
        if (!relaxed_fingers) stretchFingers(clip.frames.back());
    }
    return clip;
}

Clip heldFor(const Clip& clip, double duration_s) {
    constexpr double tiny_s = 1e-9;
    Clip out = clip;
    while (out.duration_s() < duration_s - tiny_s) out.frames.push_back(out.frames.back());
    while (out.frameCount() > 1 && out.duration_s() - out.frame_time_s >= duration_s - tiny_s)
        out.frames.pop_back();
    return out;
}

}  // namespace deixis::motion
