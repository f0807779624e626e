#include "pointing_posture.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "motion/pointing/two_bone_ik.hpp"
#include "motion/skeleton/axes.hpp"

namespace deixis::motion {

namespace {

double signOf(Side side) {
    return side == Side::left ? 1.0 : -1.0;
}

/// The share `t` of a rotation.
Quat partOf(const Quat& rotation, double t) {
    return glm::slerp(no_rotation, rotation, t);
}

void turnTrunk(const PointingBody& body, LocalPose& pose, const Quat& turn) {
    struct Share {
        Bone bone;
        double part;
    };
    double left = 1.0;
    // The lumbar spine turns least; what missing joints would take falls to the next below.
    for (const Share share : {Share{Bone::upperChest, 0.40}, Share{Bone::chest, 0.35}})
        if (Quat* joint = body.find(pose, share.bone)) {
            *joint = partOf(turn, share.part) * *joint;
            left -= share.part;
        }
    Quat* spine = body.find(pose, Bone::spine);
    *spine = partOf(turn, left) * *spine;
}

/// The shoulder girdle goes along: up with the arm's elevation, forward for a forward arm.
void turnShoulderGirdle(const PointingBody& body, LocalPose& pose, const PostureRequest& request) {
    const ArmBones bones = armBones(request.hand);
    Quat* girdle = body.find(pose, bones.shoulder);
    if (girdle == nullptr) return;
    const Pose shoulder = body.world(pose, body.joint(bones.upper_arm));
    const Quat trunk =
        body.world(pose, static_cast<std::size_t>(body.skeleton.joints[body.joint(bones.shoulder)].parent))
            .orientation;
    const Vec3 direction = glm::conjugate(trunk) * glm::normalize(request.aim - shoulder.position);
    const double from_hanging = pi / 2.0 + elevationOf(direction);
    const double forward = request.shoulder_forward_rad * std::max(0.0, direction.z);
    const double sign = signOf(request.hand);
    *girdle = glm::angleAxis(-sign * forward, y_axis) *
              glm::angleAxis(sign * request.shoulder_raise_share * from_hanging, z_axis) * *girdle;
}

/// Direction from the shoulder in which the elbow stands out, for a fingertip at `tip`; all in the trunk's
/// frame, relative to the shoulder.
Vec3 elbowDirection(const Vec3& tip, Side side, const ArmPostureParameters& arm, double upper_arm_m,
                    double forearm_m) {
    const double sign = signOf(side);
    const double reach_cm = 100.0 * glm::length(tip);
    const double psi = degreesFromRadians(elevationOf(tip));
    const double chi = sign * degreesFromRadians(azimuthOf(tip));
    const auto angle = [](const std::array<double, 3>& c, double a, double b) {
        return radiansFromDegrees(c[0] + c[1] * a + c[2] * b);
    };
    const double upper_elevation = angle(arm.upper_arm_elevation, reach_cm, psi);
    const double fore_elevation = angle(arm.forearm_elevation, reach_cm, psi);
    const double upper_yaw = angle(arm.upper_arm_yaw, chi, psi);
    const double fore_yaw = angle(arm.forearm_yaw, chi, psi);
    const Vec3 upper{sign * std::sin(upper_elevation) * std::sin(upper_yaw), -std::cos(upper_elevation),
                     std::sin(upper_elevation) * std::cos(upper_yaw)};
    const Vec3 fore{sign * std::sin(fore_elevation) * std::sin(fore_yaw), std::cos(fore_elevation),
                    std::sin(fore_elevation) * std::cos(fore_yaw)};
    const Vec3 along = glm::normalize(upper_arm_m * upper + forearm_m * fore);
    const Vec3 out = upper - glm::dot(upper, along) * along;
    const Vec3 tip_direction = glm::normalize(tip);
    // Outside the fitted range the two segments may nearly fall together: lean on down, out and back there.
    const Vec3 usual = glm::normalize(Vec3(sign * 0.6, -1.0, -0.3));
    const Vec3 elbow = out + 0.10 * (usual - glm::dot(usual, tip_direction) * tip_direction);
    return glm::normalize(elbow - glm::dot(elbow, tip_direction) * tip_direction);
}

/// Where the line from its origin to the aim leaves the sphere about the shoulder.
Vec3 fingertipOnLine(const Vec3& origin, const Vec3& aim, const Vec3& shoulder, double radius_m) {
    const Vec3 direction = glm::normalize(aim - origin);
    const Vec3 from_shoulder = origin - shoulder;
    const double along = glm::dot(from_shoulder, direction);
    const double inside = radius_m * radius_m - glm::dot(from_shoulder, from_shoulder) + along * along;
    return origin + (std::sqrt(std::max(0.0, inside)) - along) * direction;
}

/// Turn of the forearm about its own axis that brings the palm (its -y) to face down and a little inward;
/// within what a forearm can do from the T pose.
double palmDownTwist(const Quat& forearm, const PostureRequest& request) {
    const Vec3 axis = forearm * x_axis;
    const Vec3 back_of_hand = forearm * y_axis;
    Vec3 wanted = up - glm::dot(up, axis) * axis;
    if (glm::length(wanted) < 1e-3) return 0.0;
    wanted = glm::angleAxis(-request.palm_inward_rad, axis) * glm::normalize(wanted);
    const double twist =
        std::atan2(glm::dot(glm::cross(back_of_hand, wanted), axis), glm::dot(back_of_hand, wanted));
    return std::clamp(twist, radiansFromDegrees(-90.0), radiansFromDegrees(65.0));
}

}  // namespace

Quat turnedAtMost(const Quat& rotation, double limit_rad) {
    const double angle = 2.0 * std::acos(std::clamp(rotation.w, 0.0, 1.0));
    return angle > limit_rad ? partOf(rotation, limit_rad / angle) : rotation;
}

double azimuthOf(const Vec3& direction) {
    return std::atan2(direction.x, direction.z);
}

double elevationOf(const Vec3& direction) {
    return std::atan2(direction.y, std::sqrt(direction.x * direction.x + direction.z * direction.z));
}

void turnHead(const PointingBody& body, LocalPose& pose, const Quat& torso_from_head) {
    Quat* head = body.find(pose, Bone::head);
    Quat rest = torso_from_head;
    if (Quat* neck = body.find(pose, Bone::neck)) {
        const Quat part = partOf(torso_from_head, 0.4);
        *neck = part * *neck;
        rest = glm::conjugate(part) * torso_from_head;
    }
    *head = rest * *head;
}

LocalPose solvePosture(const PointingBody& body, const PostureRequest& request,
                       const ArmPostureParameters& arm) {
    LocalPose pose = body.relaxed;
    turnTrunk(body, pose,
              glm::angleAxis(request.torso_yaw_rad, y_axis) *
                  glm::angleAxis(request.torso_pitch_rad, x_axis) *
                  glm::angleAxis(request.torso_roll_rad, z_axis));
    turnHead(body, pose,
             glm::angleAxis(request.head_yaw_rad, y_axis) * glm::angleAxis(request.head_pitch_rad, x_axis));
    turnShoulderGirdle(body, pose, request);
    for (const std::size_t finger : body.fingers[static_cast<std::size_t>(request.hand)])
        pose.joints[finger] = body.pointing_hands.joints[finger];

    const ArmBones bones = armBones(request.hand);
    const auto upper_joint = body.joint(bones.upper_arm);
    const Pose girdle = body.world(pose, static_cast<std::size_t>(body.skeleton.joints[upper_joint].parent));
    const Vec3 shoulder = transformPoint(girdle, body.offset(bones.upper_arm));
    const Quat trunk =
        body.world(pose, body.joint(body.map.has(Bone::upperChest) ? Bone::upperChest : Bone::spine))
            .orientation;
    const Vec3 eye = body.eye(pose);
    const Vec3 origin = (1.0 - request.origin_k) * eye + request.origin_k * shoulder;
    const Vec3 tip_in_hand = body.fingertip_in_hand[static_cast<std::size_t>(request.hand)];
    const Vec3 knuckle_in_hand = body.knuckle_in_hand[static_cast<std::size_t>(request.hand)];
    const Vec3 index_in_hand = tip_in_hand - knuckle_in_hand;
    const double upper_m = glm::length(body.offset(bones.lower_arm));
    const double fore_m = glm::length(body.offset(bones.hand) + tip_in_hand);

    // Palm and wrist move the fingertip by little: a few rounds settle them.
    constexpr int rounds = 8;
    double twist = 0.0;
    Quat wrist = no_rotation;
    Quat knuckle = no_rotation;
    Quat upper = no_rotation;
    Quat elbow = no_rotation;
    for (int round = 0; round < rounds; ++round) {
        const Quat turned = glm::angleAxis(twist, x_axis);
        TwoLinkArm links{
            request.hand, body.offset(bones.lower_arm),
            turned * (body.offset(bones.hand) + wrist * (knuckle_in_hand + knuckle * index_in_hand))};
        const double longest = glm::length(tipInUpperArm(links, min_flexion_rad));
        const double radius = std::min(request.extension * (upper_m + fore_m), longest);
        const Vec3 tip = fingertipOnLine(origin, request.aim, shoulder, radius);
        const Vec3 from_shoulder = tip - shoulder;
        const Vec3 out =
            trunk * elbowDirection(glm::conjugate(trunk) * from_shoulder, request.hand, arm, upper_m, fore_m);
        const Vec3 swivelled = glm::angleAxis(request.swivel_offset_rad, glm::normalize(from_shoulder)) * out;
        const ArmSolution solution = solveArm(links, from_shoulder, swivelled);
        upper = solution.upper_arm;
        elbow = elbowRotation(request.hand, solution.flexion_rad);
        twist = palmDownTwist(upper * elbow, request);
        if (round + 1 == rounds) break;

        const Quat forearm = upper * elbow * glm::angleAxis(twist, x_axis);
        const Quat straight = rotationBetween(index_in_hand, glm::conjugate(forearm) * (request.aim - tip));
        const double bend = 2.0 * std::acos(std::clamp(std::abs(straight.w), 0.0, 1.0));
        if (bend < 1e-6) continue;
        const double mended = request.index_alignment * bend;
        const double at_wrist = std::min(0.6 * mended, request.wrist_limit_rad);
        const double at_knuckle = std::min(mended - at_wrist, request.knuckle_limit_rad);
        wrist = partOf(straight, at_wrist / bend);
        knuckle = partOf(straight, at_knuckle / bend);
    }
    // Pronation is spread over the forearm's length: half at the elbow, half at the wrist.
    const Quat half_twist = glm::angleAxis(0.5 * twist, x_axis);
    pose.joints[upper_joint].orientation = glm::normalize(glm::conjugate(girdle.orientation) * upper);
    pose.joints[body.joint(bones.lower_arm)].orientation = glm::normalize(elbow * half_twist);
    pose.joints[body.joint(bones.hand)].orientation = glm::normalize(half_twist * wrist);
    if (Quat* index = body.find(pose, bones.index_proximal)) *index = glm::normalize(knuckle * *index);
    return pose;
}

}  // namespace deixis::motion
