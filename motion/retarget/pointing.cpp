#include "pointing.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/order_statistics.hpp"
#include "motion/pointing/rays.hpp"
#include "motion/pointing/two_bone_ik.hpp"
#include "motion/skeleton/bone_index.hpp"

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

/// What is to be kept of the source's sight line at the target: a triangle of eye, fingertip and target.
class SourceSight {
  public:
    SourceSight(const SightLine& source, const std::optional<Vec3>& target, const Vec3& eye)
        : target_(target), eye_(eye), turned_(glm::normalize(source.fingertip - source.eye)) {
        if (!target) return;
        const Vec3 to_target = *target - source.eye;
        error_ = angularError({source.fingertip, turned_}, *target);
        share_of_way_ = glm::length(source.fingertip - source.eye) / glm::length(to_target);
        distance_m_ = glm::length(*target - eye);
        turned_ = rotationBetween(to_target, *target - eye) * turned_;
    }

    /// How far from the eye the fingertip may be: short of the target with room for the error, unless the
    /// source's comes nearer to it.
    [[nodiscard]] double farthest_m() const {
        constexpr double enough_of_way = 0.8;
        return target_ ? distance_m_ * std::max(enough_of_way, share_of_way_) : 1e9;
    }
    /// Where the source's fingertip passes the target the avatar's is to pass by as much, which is a triangle
    /// of the same shape. It is led there from 0.9 of the way on.
    [[nodiscard]] double nearest_m() const {
        constexpr double led_from = 0.9;
        const double led = std::clamp((share_of_way_ - led_from) / (1.0 - led_from), 0.0, 1.0);
        return led * share_of_way_ * distance_m_;
    }

    /// The direction from the avatar's eye in which a fingertip so far away makes the source's error.
    [[nodiscard]] Vec3 direction(double fingertip_m) const {
        if (!target_ || share_of_way_ >= 1.0) return turned_;
        // The error is an angle at the fingertip, with the eye and the target as the triangle's other
        // corners.
        const double sine = fingertip_m * std::sin(error_) / distance_m_;
        const Vec3 aim = glm::normalize(*target_ - eye_);
        const Vec3 axis = glm::cross(aim, turned_);
        if (sine >= 1.0 || glm::length(axis) < 1e-9) return turned_;
        return glm::angleAxis(error_ - std::asin(sine), glm::normalize(axis)) * aim;
    }

  private:
    std::optional<Vec3> target_;
    Vec3 eye_;
    Vec3 turned_;  // the source's direction, turned as the target lies from the avatar's eye
    double error_ = 0.0;
    double share_of_way_ = 0.0;
    double distance_m_ = 0.0;  // from the avatar's eye to the target
};

/// How far along a ray from the eye a fingertip may be.
struct ArmRange {
    double reach_m;     ///< from the shoulder as the elbow is bent now
    double straight_m;  ///< from the shoulder, with a straight elbow
    double nearest_m;   ///< from the eye, but for a target that is near
    double farthest_m;  ///< from the eye
};

/// Where the fingertip lies on the ray, metres from the eye: where the elbow stays as it is; where the ray is
/// farther from the shoulder, at its point nearest to the shoulder; and where that is out of range, as near
/// to it as can be.
double placeOnRay(const Vec3& eye, const Vec3& direction, const Vec3& shoulder, const ArmRange& range) {
    const double along = glm::dot(shoulder - eye, direction);
    const double across = glm::length(eye + along * direction - shoulder);
    const auto half = [&](double reach_m) { return std::sqrt(reach_m * reach_m - across * across); };
    double place = along + (across < range.reach_m ? half(range.reach_m) : 0.0);
    place = std::max(place, range.nearest_m);
    if (across < range.straight_m) place = std::min(place, along + half(range.straight_m));
    return std::min(place, range.farthest_m);
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
        const Vec3 shoulder = poser_.position(body, frame, arm_.upper_arm);
        const Vec3 elbow = poser_.position(body, frame, arm_.lower_arm);
        const Vec3 tip = poser_.fingertip(body, frame, side_);
        const double now_m = glm::length(tip - eye);
        const Vec3 now = (tip - eye) / now_m;
        const SourceSight sight(source, target, eye);
        // From where the fingertip is it comes within range as the gesture goes on.
        const double min_m = 0.5 * now_m;
        const ArmRange range{glm::length(tip - shoulder),
                             glm::length(elbow - shoulder) + glm::length(tip - elbow),
                             std::max(min_m, std::lerp(min_m, sight.nearest_m(), share)),
                             std::max(sight.farthest_m(), (1.0 - share) * now_m)};
        // How far the fingertip is decides on the direction, and the other way round. Half steps settle where
        // whole ones swing.
        constexpr int max_rounds = 60;
        constexpr double close_enough_m = 1e-7;
        double place = now_m;
        Vec3 direction = now;
        for (int round = 0; round < max_rounds; ++round) {
            direction = glm::slerp(no_rotation, rotationBetween(now, sight.direction(place)), share) * now;
            const double next = placeOnRay(eye, direction, shoulder, range);
            const bool settled = std::abs(next - place) < close_enough_m;
            place = settled ? next : 0.5 * (place + next);
            if (settled) break;
        }
        bring(body, eye + place * direction - shoulder, elbow, tip);
    }

  private:
    /// Brings the fingertip to a point, given from the shoulder.
    void bring(BodyFrame& body, const Vec3& goal, const Vec3& elbow, const Vec3& tip) const {
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
    return {median(errors), *std::max_element(errors.begin(), errors.end())};
}

}  // namespace deixis::motion
