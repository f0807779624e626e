#include "retarget_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "motion/reference_humanoid.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

constexpr Bone required[] = {hips,          head,          leftUpperLeg,  leftLowerLeg, leftFoot,
                             rightUpperLeg, rightLowerLeg, rightFoot,     leftUpperArm, leftLowerArm,
                             leftHand,      rightUpperArm, rightLowerArm, rightHand};

bool isFinger(std::size_t bone) {
    return bone >= static_cast<std::size_t>(leftThumbMetacarpal);
}

/// A point that moves with a joint.
struct Attached {
    std::size_t joint;
    Vec3 local;
};

/// Points of the soles: under ankle, ball and toe tip, on the floor in the T pose.
std::vector<Attached> solePoints(const AvatarRest& avatar) {
    std::vector<Attached> points;
    const auto drop = [&](int joint, Vec3 point) {
        const Vec3& origin = avatar.world[static_cast<std::size_t>(joint)].position;
        point.y = 0.0;
        points.push_back({static_cast<std::size_t>(joint), point - origin});
    };
    for (const Bone bone : {leftFoot, rightFoot, leftToes, rightToes}) {
        if (!avatar.map.has(bone)) continue;
        const int joint = avatar.map[bone];
        drop(joint, avatar.world[static_cast<std::size_t>(joint)].position);
        drop(joint, tipPosition(avatar.skeleton, avatar.world, joint));
    }
    return points;
}

/// Of each frame the height of the soles' lowest point.
std::vector<double> soleHeights(const AvatarRest& avatar, const Clip& clip) {
    const auto points = solePoints(avatar);
    std::vector<double> heights;
    heights.reserve(clip.frames.size());
    std::vector<Pose> world;
    for (const LocalPose& pose : clip.frames) {
        worldPose(clip.skeleton, pose, world);
        double lowest = transformPoint(world[points.front().joint], points.front().local).y;
        for (const Attached& p : points) lowest = std::min(lowest, transformPoint(world[p.joint], p.local).y);
        heights.push_back(lowest);
    }
    return heights;
}

/// The height that a tenth of the frames lie below: a single foot driven into the floor does not lift the
/// whole clip.
double standingHeight(std::vector<double> heights) {
    const auto at = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 10);
    std::nth_element(heights.begin(), at, heights.end());
    return *at;
}

class Assembler {
  public:
    Assembler(const AvatarRest& avatar, const BoneSet& driven) : avatar_(avatar), driven_(driven) {
        bone_of_joint_.assign(avatar.skeleton.joints.size(), bone_count);
        for (std::size_t b = 0; b < bone_count; ++b)
            if (avatar.map.joint[b] >= 0) bone_of_joint_[static_cast<std::size_t>(avatar.map.joint[b])] = b;
        hip_centre_from_hips_ =
            0.5 * (*avatar.shape.at(leftUpperLeg) + *avatar.shape.at(rightUpperLeg)) - *avatar.shape.at(hips);
    }

    LocalPose pose(const BodyFrame& frame) const {
        LocalPose out = restPose(avatar_.skeleton);
        std::vector<Quat> world(out.joints.size());
        for (std::size_t j = 0; j < out.joints.size(); ++j) {
            const int parent = avatar_.skeleton.joints[j].parent;
            const Quat above = parent < 0 ? no_rotation : world[static_cast<std::size_t>(parent)];
            const std::size_t bone = bone_of_joint_[j];
            if (bone < bone_count && driven_[bone])
                out.joints[j].orientation = glm::normalize(glm::conjugate(above) * frame.rotation[bone]);
            else if (bone < bone_count && isFinger(bone))
                out.joints[j].orientation = relaxed_.joints[bone].orientation;
            world[j] = above * out.joints[j].orientation;
        }
        const auto hips_joint = static_cast<std::size_t>(avatar_.map[hips]);
        out.joints[hips_joint].position =
            frame.hip_centre - frame.rotation[static_cast<std::size_t>(hips)] * hip_centre_from_hips_;
        return out;
    }

  private:
    const AvatarRest& avatar_;
    const BoneSet& driven_;
    std::vector<std::size_t> bone_of_joint_;
    Vec3 hip_centre_from_hips_{0.0};
    LocalPose relaxed_ = relaxedPose(referenceHumanoid());
};

}  // namespace

double legLength(const BodyShape& shape) {
    double length = 0.0;
    for (const Hinge& hinge : hinges())
        if (hinge.end == leftFoot || hinge.end == rightFoot)
            length += 0.5 * (glm::length(*shape.at(hinge.lower) - *shape.at(hinge.upper)) +
                             glm::length(*shape.at(hinge.end) - *shape.at(hinge.lower)));
    return length;
}

AvatarRest avatarRest(const Skeleton& skeleton, const HumanoidMap& map) {
    auto world = worldPose(skeleton, restPose(skeleton));
    auto shape = shapeOf(skeleton, map, world);
    const auto axes = standingAxes(shape);
    const double leg = legLength(shape);
    return {skeleton, map, std::move(world), shape, axes, leg};
}

Clip assemble(const AvatarRest& avatar, std::vector<BodyFrame> frames, const BoneSet& driven, Ground ground,
              double frame_time_s) {
    const Vec3 forward = frames.front().rotation[static_cast<std::size_t>(hips)] * Vec3(0, 0, 1);
    const Quat turn = yawRotation(-std::atan2(forward.x, forward.z));
    for (BodyFrame& frame : frames) {
        for (Quat& rotation : frame.rotation) rotation = turn * rotation;
        frame.hip_centre = turn * frame.hip_centre;
    }
    const Assembler assembler(avatar, driven);
    Clip clip;
    clip.skeleton = avatar.skeleton;
    clip.frame_time_s = frame_time_s;
    for (const BodyFrame& frame : frames) clip.frames.push_back(assembler.pose(frame));

    const auto hips_joint = static_cast<std::size_t>(avatar.map[hips]);
    const Vec3 begin = clip.frames.front().joints[hips_joint].position;
    const auto heights = soleHeights(avatar, clip);
    const double floor = standingHeight(heights);
    for (std::size_t f = 0; f < clip.frames.size(); ++f)
        clip.frames[f].joints[hips_joint].position -=
            Vec3(begin.x, ground == Ground::clip ? floor : heights[f], begin.z);
    return clip;
}

std::string missingBones(const BoneSet& has) {
    std::string names;
    for (const Bone bone : required)
        if (!has[static_cast<std::size_t>(bone)])
            names += (names.empty() ? "" : ", ") + std::string(boneName(bone));
    return names;
}

}  // namespace deixis::motion
