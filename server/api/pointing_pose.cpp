#include "pointing_pose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/pointing/rays.hpp"
#include "motion/pointing/two_bone_ik.hpp"
#include "motion/skeleton/skeleton.hpp"
#include "motion/upper_body/upper_body_clip.hpp"

namespace deixis::server {

namespace {

using motion::Side;
using motion::UpperBone;

constexpr double degrees = 180.0 / 3.14159265358979323846;
constexpr double across_deg = 50.0, behind_deg = 120.0;  ///< from straight ahead
constexpr double straight_share = 0.985;                 ///< of the locked arm, which nobody points with
constexpr double before_target_m = 0.03;                 ///< stands the fingertip at least
constexpr double shortest_wrist_m = 0.1;
constexpr int corrections = 12;

const motion::Skeleton& figure() {
    return motion::referenceHumanoid();
}

const motion::HumanoidMap& figureMap() {
    static const motion::HumanoidMap map = motion::mapByVrmNames(figure());
    return map;
}

std::vector<Pose> figureIn(const motion::UpperBodyPose& pose) {
    return motion::worldPose(figure(), motion::avatarPose(pose));
}

double outward(Side side) {
    return side == Side::left ? 1.0 : -1.0;
}

/// The direction turned about the vertical until a shoulder can take an arm there.
Vec3 withinReach(const Vec3& direction, Side side) {
    const double flat = std::hypot(direction.x, direction.z);
    const double azimuth = std::atan2(outward(side) * direction.x, direction.z) * degrees;
    // From behind the shortest way leads outward or across.
    const double middle = 0.5 * (behind_deg - across_deg) - 180.0;
    const double from_middle = azimuth < middle ? azimuth + 360.0 : azimuth;
    const double allowed = std::clamp(from_middle, -across_deg, behind_deg) / degrees;
    return {outward(side) * flat * std::sin(allowed), direction.y, flat * std::cos(allowed)};
}

/// From the shoulder to the farther point of the line from the eyes to the target that is so far from it, as
/// motion::stretchedArm() has it; straight to the target where the line does not come so near.
Vec3 onSight(const Vec3& shoulder, const Vec3& eye, const Vec3& target, double reach_m) {
    const Vec3 sight = glm::normalize(target - eye);
    const Vec3 from_shoulder = eye - shoulder;
    const double middle = -glm::dot(from_shoulder, sight);
    const double under_root = middle * middle - glm::dot(from_shoulder, from_shoulder) + reach_m * reach_m;
    if (under_root < 0.0) return target - shoulder;
    const double way_m = middle + std::sqrt(under_root);
    return way_m > 0.0 ? from_shoulder + way_m * sight : target - shoulder;
}

struct Arm {
    Side side = Side::right;
    Vec3 shoulder{0.0};
    double upper_m = 0.0, fore_m = 0.0;
};

Arm armOf(const std::vector<Pose>& world, Side side) {
    const motion::ArmBones bones = motion::armBones(side);
    const auto at = [&](motion::Bone bone) {
        return world[static_cast<std::size_t>(figureMap()[bone])].position;
    };
    return {side, at(bones.upper_arm), glm::length(at(bones.lower_arm) - at(bones.upper_arm)),
            glm::length(at(bones.hand) - at(bones.lower_arm))};
}

/// Lays the wrist at a place, from the shoulder.
void layWrist(const Arm& arm, const Vec3& wrist, motion::UpperBodyPose& pose) {
    const Vec3 along(outward(arm.side), 0.0, 0.0);
    const motion::TwoLinkArm links{arm.side, arm.upper_m * along, arm.fore_m * along};
    const Vec3 down_and_out(0.4 * outward(arm.side), -1.0, -0.2);
    const Vec3 back(0.3 * outward(arm.side), 0.0, -1.0);
    constexpr double almost_along = 0.95;
    const double same = std::abs(glm::dot(glm::normalize(wrist), glm::normalize(down_and_out)));
    const auto laid = motion::solveArm(links, wrist, same > almost_along ? back : down_and_out);
    const bool left = arm.side == Side::left;
    pose[left ? UpperBone::left_upper_arm : UpperBone::right_upper_arm] = laid.upper_arm * along;
    pose[left ? UpperBone::left_forearm : UpperBone::right_forearm] =
        laid.upper_arm * motion::elbowRotation(arm.side, laid.flexion_rad) * along;
}

}  // namespace

Result<PointingPose> pointingPose(const motion::UpperBodyPose& body, Side side, const Vec3& target_m) {
    const std::vector<Pose> before = figureIn(body);
    const Arm arm = armOf(before, side);
    const double distance_m = glm::length(target_m - arm.shoulder);
    if (distance_m < nearest_target_m)
        return fail("target_m",
                    fmt::format("found a target {:.2f} m from the {} shoulder, expected at least {} m",
                                distance_m, side == Side::left ? "left" : "right", nearest_target_m));
    const Vec3 eye = motion::eyePosition(figureMap(), before);
    const double longest_m = straight_share * (arm.upper_m + arm.fore_m);
    const double to_target_m = distance_m - before_target_m;

    PointingPose out;
    out.pose = body;
    const auto fingertip = [&](const std::vector<Pose>& world) {
        return motion::fingertipPosition(figure(), figureMap(), world, side);
    };
    // The hand goes on from the wrist in a way of its own: the arm is turned until the fingertip comes right.
    Vec3 wrist = longest_m * glm::normalize(withinReach(target_m - arm.shoulder, side));
    for (int i = 0; i < corrections; ++i) {
        layWrist(arm, wrist, out.pose);
        const Vec3 tip = fingertip(figureIn(out.pose)) - arm.shoulder;
        const double tip_m = glm::length(tip);
        const Vec3 wanted =
            withinReach(onSight(arm.shoulder, eye, target_m, std::min(tip_m, to_target_m)), side);
        const double wrist_m = std::clamp(glm::length(wrist) + std::min(to_target_m - tip_m, longest_m),
                                          shortest_wrist_m, longest_m);
        wrist = wrist_m * glm::normalize(rotationBetween(tip, wanted) * wrist);
    }
    const std::vector<Pose> after = figureIn(out.pose);
    const Ray seen{eye, fingertip(after) - eye};
    out.off_deg = motion::angularError(seen, target_m) * degrees;
    return out;
}

}  // namespace deixis::server
