#include "assembly.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/order_statistics.hpp"
#include "motion/humanoid/hand_shapes.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/skeleton/bone_index.hpp"
#include "motion/skeleton/minimum_jerk.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

bool isFinger(std::size_t bone) {
    return bone >= indexOf(leftThumbMetacarpal);
}

Side sideOf(std::size_t finger_bone) {
    return finger_bone >= indexOf(rightThumbMetacarpal) ? Side::right : Side::left;
}

std::size_t firstFinger(Side side) {
    return indexOf(side == Side::left ? leftThumbMetacarpal : rightThumbMetacarpal);
}

Vec3 onFloor(const Vec3& point) {
    return {point.x, 0.0, point.z};
}

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
    AvatarRest out{skeleton, map, std::move(world), shape, axes, leg};
    std::vector<int> bone_of_joint(skeleton.joints.size(), -1);
    for (std::size_t b = 0; b < bone_count; ++b)
        if (map.joint[b] >= 0) bone_of_joint[static_cast<std::size_t>(map.joint[b])] = static_cast<int>(b);
    out.above.fill(-1);
    for (std::size_t b = 0; b < bone_count; ++b) {
        int joint = map.joint[b];
        if (joint < 0) continue;
        const Vec3 start = out.world[static_cast<std::size_t>(joint)].position;
        do joint = skeleton.joints[static_cast<std::size_t>(joint)].parent;
        while (joint >= 0 && bone_of_joint[static_cast<std::size_t>(joint)] < 0);
        if (joint < 0) continue;
        out.above[b] = bone_of_joint[static_cast<std::size_t>(joint)];
        out.offset[b] = start - out.world[static_cast<std::size_t>(joint)].position;
    }
    out.hip_centre_from_hips =
        0.5 * (*out.shape.at(leftUpperLeg) + *out.shape.at(rightUpperLeg)) - *out.shape.at(hips);
    return out;
}

double pointingShare(const PointingGesture& gesture, int frame) {
    if (frame <= gesture.onset_frame || frame >= gesture.end_frame) return 0.0;
    if (frame < gesture.peak_frame)
        return minimumJerk(static_cast<double>(frame - gesture.onset_frame) /
                           (gesture.peak_frame - gesture.onset_frame));
    if (frame <= gesture.hold_frame) return 1.0;
    return minimumJerk(static_cast<double>(gesture.end_frame - frame) /
                       (gesture.end_frame - gesture.hold_frame));
}

BodyPoser::BodyPoser(const AvatarRest& avatar, const BoneSet& driven, const PointingGesture* closing)
    : avatar_(avatar),
      driven_(driven),
      closing_(closing),
      relaxed_(relaxedPose(referenceHumanoid())),
      rest_(restPose(avatar.skeleton)) {
    for (const Joint& joint : avatar.skeleton.joints) joints_.push_back({joint.parent, bone_count});
    for (std::size_t b = 0; b < bone_count; ++b)
        if (avatar.map.joint[b] >= 0) joints_[static_cast<std::size_t>(avatar.map.joint[b])].bone = b;
    if (closing == nullptr) return;
    LocalPose hand = relaxed_;
    for (int f = closing->onset_frame; f <= closing->end_frame; ++f) {
        const double share = pointingShare(*closing, f);
        if (share > 0.0) applyPointingHand(hand, closing->hand, share);
        const std::size_t first = firstFinger(closing->hand);
        const LocalPose& from = share > 0.0 ? hand : relaxed_;
        for (std::size_t i = 0; auto& turn : closed_.emplace_back())
            turn = from.joints[first + i++].orientation;
    }
}

const Quat& BodyPoser::handShape(std::size_t finger_bone, int frame) const {
    if (closing_ == nullptr || sideOf(finger_bone) != closing_->hand || frame < closing_->onset_frame ||
        frame > closing_->end_frame)
        return relaxed_.joints[finger_bone].orientation;
    return closed_[static_cast<std::size_t>(frame - closing_->onset_frame)]
                  [finger_bone - firstFinger(closing_->hand)];
}

LocalPose BodyPoser::pose(const BodyFrame& body, int frame, Workspace& world) const {
    LocalPose out = rest_;
    world.resize(joints_.size());
    for (std::size_t j = 0; j < joints_.size(); ++j) {
        const auto [parent, bone] = joints_[j];
        const Quat& above = parent < 0 ? no_rotation : world[static_cast<std::size_t>(parent)];
        if (bone < bone_count && driven_[bone]) {
            world[j] = body.rotation[bone];
            out.joints[j].orientation = glm::conjugate(above) * world[j];
            continue;
        }
        if (bone < bone_count && isFinger(bone)) out.joints[j].orientation = handShape(bone, frame);
        world[j] = above * out.joints[j].orientation;
    }
    const auto hips_joint = static_cast<std::size_t>(avatar_.map[hips]);
    const int parent = avatar_.skeleton.joints[hips_joint].parent;
    out.joints[hips_joint].position = hipsPosition(avatar_, body);
    if (parent >= 0)  // joints above the hips rest
        out.joints[hips_joint].position -= avatar_.world[static_cast<std::size_t>(parent)].position;
    return out;
}

Quat BodyPoser::rotation(const BodyFrame& body, int frame, Bone bone) const {
    const std::size_t b = indexOf(bone);
    if (driven_[b]) return body.rotation[b];
    const int above = avatar_.above[b];
    const Quat up_there = above < 0 ? no_rotation : rotation(body, frame, static_cast<Bone>(above));
    return isFinger(b) ? up_there * handShape(b, frame) : up_there;
}

Vec3 BodyPoser::position(const BodyFrame& body, int frame, Bone bone) const {
    const int above = avatar_.above[indexOf(bone)];
    if (bone == hips || above < 0) return hipsPosition(avatar_, body);
    const auto from = static_cast<Bone>(above);
    return position(body, frame, from) + rotation(body, frame, from) * avatar_.offset[indexOf(bone)];
}

Vec3 BodyPoser::eye(const BodyFrame& body, int frame) const {
    if (avatar_.map.has(leftEye) && avatar_.map.has(rightEye))
        return 0.5 * (position(body, frame, leftEye) + position(body, frame, rightEye));
    return position(body, frame, head);
}

Vec3 BodyPoser::fingertip(const BodyFrame& body, int frame, Side side) const {
    const ArmBones arm = armBones(side);
    for (const Bone bone : {arm.index_distal, arm.index_intermediate, arm.index_proximal})
        if (avatar_.map.has(bone)) {
            const auto& tip = avatar_.skeleton.joints[static_cast<std::size_t>(avatar_.map[bone])].end_site;
            const Vec3 start = position(body, frame, bone);
            return tip ? start + rotation(body, frame, bone) * *tip : start;
        }
    return position(body, frame, arm.hand);
}

Sole soleOf(const AvatarRest& avatar, Side side) {
    const bool left = side == Side::left;
    Sole sole{left ? leftFoot : rightFoot, left ? leftToes : rightToes};
    const auto tip = [&](Bone bone) { return tipPosition(avatar.skeleton, avatar.world, avatar.map[bone]); };
    const Vec3 ankle = *avatar.shape.at(sole.foot);
    sole.heel = onFloor(ankle) - ankle;
    if (!avatar.map.has(sole.toes)) {
        sole.ball = onFloor(tip(sole.foot)) - ankle;
        return sole;
    }
    const Vec3 toes = *avatar.shape.at(sole.toes);
    sole.ball = onFloor(toes) - ankle;
    if (const Vec3 reach = tip(sole.toes) - toes; glm::length(onFloor(reach)) > 0.01)
        sole.tip = onFloor(tip(sole.toes)) - toes;
    return sole;
}

double soleHeight(const AvatarRest& avatar, const std::array<Sole, 2>& soles, const BodyFrame& frame) {
    const Vec3 from = hipsPosition(avatar, frame);
    double lowest = 1e9;
    const auto below = [&](Bone bone, const Vec3& start) {
        const auto above = static_cast<std::size_t>(avatar.above[indexOf(bone)]);
        return start + frame.rotation[above] * avatar.offset[indexOf(bone)];
    };
    for (const Sole& sole : soles) {
        const bool left = sole.foot == leftFoot;
        const Vec3 ankle = below(sole.foot, below(left ? leftLowerLeg : rightLowerLeg,
                                                  below(left ? leftUpperLeg : rightUpperLeg, from)));
        const Quat& foot = frame.rotation[indexOf(sole.foot)];
        lowest = std::min({lowest, (ankle + foot * sole.heel).y, (ankle + foot * sole.ball).y});
        if (sole.tip)
            lowest = std::min(lowest,
                              (below(sole.toes, ankle) + frame.rotation[indexOf(sole.toes)] * *sole.tip).y);
    }
    return lowest;
}

FloorHeight floorHeight(const AvatarRest& avatar, const std::vector<BodyFrame>& frames) {
    const std::array<Sole, 2> soles{soleOf(avatar, Side::left), soleOf(avatar, Side::right)};
    std::vector<double> heights;
    heights.reserve(frames.size());
    for (const BodyFrame& frame : frames) heights.push_back(soleHeight(avatar, soles, frame));
    return {orderStatistic(heights, heights.size() / 10), *std::min_element(heights.begin(), heights.end())};
}

Vec3 hipsPosition(const AvatarRest& avatar, const BodyFrame& frame) {
    return frame.hip_centre - frame.rotation[indexOf(hips)] * avatar.hip_centre_from_hips;
}

Quat turnToFront(const BodyFrame& frame) {
    const Vec3 forward = frame.rotation[indexOf(hips)] * Vec3(0, 0, 1);
    return yawRotation(-std::atan2(forward.x, forward.z));
}

Clip assemble(const AvatarRest& avatar, std::vector<BodyFrame> frames, const BoneSet& driven, Ground ground,
              double frame_time_s) {
    const Quat turn = turnToFront(frames.front());
    for (BodyFrame& frame : frames) {
        for (Quat& rotation : frame.rotation) rotation = turn * rotation;
        frame.hip_centre = turn * frame.hip_centre;
    }
    const Vec3 begin = hipsPosition(avatar, frames.front());
    const double floor = floorHeight(avatar, frames).floor;
    const std::array<Sole, 2> soles{soleOf(avatar, Side::left), soleOf(avatar, Side::right)};
    const BodyPoser poser(avatar, driven, nullptr);
    BodyPoser::Workspace workspace;
    Clip clip;
    clip.skeleton = avatar.skeleton;
    clip.frame_time_s = frame_time_s;
    clip.frames.reserve(frames.size());
    for (BodyFrame& frame : frames) {
        const double height = ground == Ground::clip ? floor : soleHeight(avatar, soles, frame);
        frame.hip_centre -= Vec3(begin.x, height, begin.z);
        clip.frames.push_back(poser.pose(frame, clip.frameCount(), workspace));
    }
    return clip;
}

}  // namespace deixis::motion
