#include "retarget_pointing.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "bone_index.hpp"
#include "motion/pointing.hpp"
#include "two_bones.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

constexpr double hand_of_stature = 0.108;
constexpr double leg_of_stature = 0.491;  // thigh and shin
constexpr double shortest_hand_m = 0.02;

/// The tip of a joint in its frame: its end site, or the farthest joint or end below it at rest.
Vec3 tipAtRest(const Skeleton& skeleton, int joint) {
    const auto at = static_cast<std::size_t>(joint);
    if (skeleton.joints[at].end_site) return *skeleton.joints[at].end_site;
    std::vector<std::optional<Pose>> joint_from(skeleton.joints.size());
    joint_from[at] = Pose{};
    Vec3 farthest(0.0);
    const auto see = [&](const Vec3& point) {
        if (glm::length(point) > glm::length(farthest)) farthest = point;
    };
    for (std::size_t j = at + 1; j < skeleton.joints.size(); ++j) {
        const int parent = skeleton.joints[j].parent;
        if (parent < 0 || !joint_from[static_cast<std::size_t>(parent)]) continue;
        joint_from[j] = *joint_from[static_cast<std::size_t>(parent)] * skeleton.joints[j].rest;
        see(joint_from[j]->position);
        if (skeleton.joints[j].end_site) see(transformPoint(*joint_from[j], *skeleton.joints[j].end_site));
    }
    return farthest;
}

/// The direction, seen from the avatar's eye, in which its ray makes the source's error at the target.
Vec3 wantedDirection(const SightLine& source, const Vec3& eye, double reach_m,
                     const std::optional<Vec3>& target) {
    const Vec3 ray = glm::normalize(source.fingertip - source.eye);
    if (!target) return ray;
    const Vec3 to_target = *target - source.eye;
    const Vec3 turned = rotationBetween(to_target, *target - eye) * ray;
    // The error is an angle at the fingertip, with the eye and the target as the triangle's other corners.
    const double error = angularError({source.fingertip, ray}, *target);
    const double distance = glm::length(*target - eye);
    const double at_target = reach_m * std::sin(error) / distance;
    const Vec3 aim = glm::normalize(*target - eye);
    const Vec3 axis = glm::cross(aim, turned);
    if (at_target >= 1.0 || glm::length(axis) < 1e-9) return turned;
    return glm::angleAxis(error - std::asin(at_target), glm::normalize(axis)) * aim;
}

/// Where a fingertip that stays `reach_m` from the shoulder lies on the ray; where the ray is farther away,
/// the ray's point nearest to the shoulder.
Vec3 pointOnRay(const Vec3& eye, const Vec3& direction, const Vec3& shoulder, double reach_m) {
    const double along = glm::dot(shoulder - eye, direction);
    const Vec3 nearest = eye + along * direction;
    const double across = glm::length(nearest - shoulder);
    if (across >= reach_m) return eye + std::max(along, 0.05) * direction;
    return nearest + std::sqrt(reach_m * reach_m - across * across) * direction;
}

class ArmTurner {
  public:
    ArmTurner(const AvatarRest& avatar, const BodyPoser& poser, const BoneSet& driven, Side side)
        : poser_(poser), side_(side), arm_(armBones(side)) {
        for (std::size_t b = 0; b < bone_count; ++b) {
            int above = static_cast<int>(b);
            while (above >= 0 && above != static_cast<int>(indexOf(arm_.lower_arm)))
                above = avatar.above[static_cast<std::size_t>(above)];
            if (above >= 0 && driven[b]) forearm_and_on_.push_back(b);
        }
        bones_.upper = avatar.offset[indexOf(arm_.lower_arm)];
        bones_.hinge = Vec3(0.0, side == Side::left ? -1.0 : 1.0, 0.0);
    }

    void turn(BodyFrame& body, int frame, const SightLine& source, const std::optional<Vec3>& target,
              double share) const {
        const Vec3 eye = poser_.eye(body, frame);
        const Vec3 now = glm::normalize(poser_.fingertip(body, frame, side_) - eye);
        const Vec3 shoulder = poser_.position(body, frame, arm_.upper_arm);
        // How far the fingertip is decides on the direction a little, and the other way round.
        for (int round = 0; round < 4; ++round) {
            const Vec3 tip = poser_.fingertip(body, frame, side_);
            const Vec3 wanted = wantedDirection(source, eye, glm::length(tip - eye), target);
            const Vec3 direction = glm::slerp(no_rotation, rotationBetween(now, wanted), share) * now;
            bring(body, frame, pointOnRay(eye, direction, shoulder, glm::length(tip - shoulder)) - shoulder);
        }
    }

  private:
    /// Brings the fingertip to a point, given from the shoulder.
    void bring(BodyFrame& body, int frame, const Vec3& goal) const {
        const Vec3 elbow = poser_.position(body, frame, arm_.lower_arm);
        const Vec3 tip = poser_.fingertip(body, frame, side_);
        Quat& upper = body.rotation[indexOf(arm_.upper_arm)];
        const Quat lower = body.rotation[indexOf(arm_.lower_arm)];
        TwoBones bones = bones_;
        bones.lower = glm::conjugate(lower) * (tip - elbow);
        Quat turned = lower;
        reach(bones, goal, upper, turned);
        const Quat change = turned * glm::conjugate(lower);
        for (const std::size_t bone : forearm_and_on_)
            body.rotation[bone] = glm::normalize(change * body.rotation[bone]);
    }

    const BodyPoser& poser_;
    Side side_;
    ArmBones arm_;
    TwoBones bones_;
    std::vector<std::size_t> forearm_and_on_;
};

}  // namespace

SightLineFinder::SightLineFinder(const Skeleton& source, const HumanoidMap& map, Side side,
                                 const AvatarRest& avatar, double scale)
    : map_(map), arm_(armBones(side)) {
    if (avatar.map.has(leftEye) && avatar.map.has(rightEye))
        eye_from_head_ =
            (0.5 * (*avatar.shape.at(leftEye) + *avatar.shape.at(rightEye)) - *avatar.shape.at(head)) / scale;
    hand_m_ = avatar.leg_length_m / leg_of_stature * hand_of_stature / scale;
    for (const Bone bone : {arm_.index_distal, arm_.index_intermediate, arm_.index_proximal, arm_.hand}) {
        if (!map.has(bone)) continue;
        tip_joint_ = map[bone];
        tip_ = tipAtRest(source, tip_joint_);
        if (bone == arm_.hand && glm::length(tip_) * scale < shortest_hand_m) tip_joint_ = -1;
        return;
    }
}

SightLine SightLineFinder::find(const std::vector<Pose>& world, const Quat& head_turn) const {
    const auto pose = [&](Bone bone) -> const Pose& { return world[static_cast<std::size_t>(map_[bone])]; };
    SightLine line;
    line.eye = map_.has(leftEye) && map_.has(rightEye)
                   ? 0.5 * (pose(leftEye).position + pose(rightEye).position)
                   : pose(head).position + head_turn * eye_from_head_;
    const Vec3 wrist = pose(arm_.hand).position;
    line.fingertip = tip_joint_ >= 0
                         ? transformPoint(world[static_cast<std::size_t>(tip_joint_)], tip_)
                         : wrist + hand_m_ * glm::normalize(wrist - pose(arm_.lower_arm).position);
    return line;
}

void keepPointingRay(const AvatarRest& avatar, const BodyPoser& poser, const BoneSet& driven,
                     const PointingGesture& gesture, const std::vector<SightLine>& lines,
                     std::vector<BodyFrame>& frames) {
    const ArmTurner arm(avatar, poser, driven, gesture.hand);
    for (int f = gesture.onset_frame; f <= gesture.end_frame; ++f)
        if (const double share = pointingShare(gesture, f); share > 0.0)
            arm.turn(frames[static_cast<std::size_t>(f)], f,
                     lines[static_cast<std::size_t>(f - gesture.onset_frame)], gesture.target, share);
}

PointingError pointingError(const std::vector<SightLine>& peak_to_hold, const Vec3& target) {
    std::vector<double> errors;
    errors.reserve(peak_to_hold.size());
    for (const SightLine& line : peak_to_hold)
        errors.push_back(degreesFromRadians(
            angularError({line.fingertip, glm::normalize(line.fingertip - line.eye)}, target)));
    std::sort(errors.begin(), errors.end());
    const std::size_t middle = errors.size() / 2;
    const double median =
        errors.size() % 2 == 1 ? errors[middle] : 0.5 * (errors[middle - 1] + errors[middle]);
    return {median, errors.back()};
}

}  // namespace deixis::motion
