#include "motion/pointing/body_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "motion/pointing/phases.hpp"
#include "motion/pointing/rays.hpp"
#include "motion/skeleton/kinematics.hpp"

namespace deixis::motion {

namespace {

struct LimitRow {
    JointLimit limit;
    std::string_view name;
    double degrees;
};
constexpr std::array<LimitRow, joint_limit_count> limits{
    {{JointLimit::elbow_flexion, "elbow flexion", 150.0},
     {JointLimit::wrist_bend, "wrist bend", 80.0},
     {JointLimit::shoulder_extension, "shoulder extension", 60.0},
     {JointLimit::knee_flexion, "knee flexion", 135.0},
     {JointLimit::hip_flexion, "hip flexion", 120.0},
     {JointLimit::trunk_rotation, "trunk rotation", 45.0},
     {JointLimit::head_rotation, "head rotation", 60.0},
     {JointLimit::head_tilt, "head tilt", 45.0}}};

using World = std::vector<Pose>;

Vec3 at(const World& world, const HumanoidMap& map, Bone bone) {
    return world[static_cast<std::size_t>(map[bone])].position;
}

bool hasAll(const HumanoidMap& map, std::initializer_list<Bone> bones) {
    return std::all_of(bones.begin(), bones.end(), [&](Bone b) { return map.has(b); });
}

struct LegBones {
    Bone upper, lower, foot, toes;
};
LegBones legBones(Side side) {
    if (side == Side::left) return {Bone::leftUpperLeg, Bone::leftLowerLeg, Bone::leftFoot, Bone::leftToes};
    return {Bone::rightUpperLeg, Bone::rightLowerLeg, Bone::rightFoot, Bone::rightToes};
}

/// Knuckle of the middle finger, or of the index finger, or no bone.
std::optional<Bone> knuckle(const HumanoidMap& map, Side side) {
    const Bone middle = side == Side::left ? Bone::leftMiddleProximal : Bone::rightMiddleProximal;
    const Bone index = armBones(side).index_proximal;
    if (map.has(middle)) return middle;
    if (map.has(index)) return index;
    return std::nullopt;
}

/// Axes of the trunk by the line of the shoulders and the line from hips to neck.
struct TrunkAxes {
    Vec3 left, upward, ahead;
};
TrunkAxes trunkAxes(const World& world, const HumanoidMap& map) {
    const Bone top = map.has(Bone::neck) ? Bone::neck : Bone::head;
    const Vec3 upward = glm::normalize(at(world, map, top) - at(world, map, Bone::hips));
    const Vec3 across = at(world, map, Bone::leftUpperArm) - at(world, map, Bone::rightUpperArm);
    const Vec3 left = glm::normalize(across - glm::dot(across, upward) * upward);
    return {left, upward, glm::cross(left, upward)};
}

double angleDeg(const Vec3& a, const Vec3& b) {
    return degreesFromRadians(angleBetween(a, b));
}

/// The angle that a limit is for, in one frame; none where the bones are not there.
std::optional<double> jointAngle(JointLimit limit, Side side, const Skeleton& skeleton,
                                 const HumanoidMap& map, const World& world) {
    const ArmBones arm = armBones(side);
    const LegBones leg = legBones(side);
    const auto bend = [&](Bone a, Bone b, Bone c) -> std::optional<double> {
        if (!hasAll(map, {a, b, c})) return std::nullopt;
        return angleDeg(at(world, map, b) - at(world, map, a), at(world, map, c) - at(world, map, b));
    };
    if (limit == JointLimit::elbow_flexion) return bend(arm.upper_arm, arm.lower_arm, arm.hand);
    if (limit == JointLimit::knee_flexion) return bend(leg.upper, leg.lower, leg.foot);
    if (limit == JointLimit::wrist_bend) {
        const auto fingers = knuckle(map, side);
        return fingers ? bend(arm.lower_arm, arm.hand, *fingers) : std::nullopt;
    }
    if (!hasAll(map, {Bone::hips, Bone::head, Bone::leftUpperArm, Bone::rightUpperArm})) return std::nullopt;
    const TrunkAxes trunk = trunkAxes(world, map);
    if (limit == JointLimit::shoulder_extension) {
        if (!hasAll(map, {arm.upper_arm, arm.lower_arm})) return std::nullopt;
        const Vec3 upper = at(world, map, arm.lower_arm) - at(world, map, arm.upper_arm);
        return angleDeg(upper, trunk.ahead) - 90.0;
    }
    if (limit == JointLimit::hip_flexion) {
        if (!hasAll(map, {leg.upper, leg.lower})) return std::nullopt;
        const Vec3 thigh = at(world, map, leg.lower) - at(world, map, leg.upper);
        return glm::dot(thigh, trunk.ahead) > 0.0 ? angleDeg(thigh, -trunk.upward) : 0.0;
    }
    if (limit == JointLimit::trunk_rotation) {
        if (!hasAll(map, {Bone::leftUpperLeg, Bone::rightUpperLeg})) return std::nullopt;
        const Vec3 hips = at(world, map, Bone::leftUpperLeg) - at(world, map, Bone::rightUpperLeg);
        return angleDeg(hips - glm::dot(hips, trunk.upward) * trunk.upward, trunk.left);
    }
    const Vec3 face = headDirection(skeleton, map, world);
    const double upward = glm::dot(face, trunk.upward);
    if (limit == JointLimit::head_tilt)
        return degreesFromRadians(std::abs(std::asin(std::clamp(upward, -1.0, 1.0))));
    return angleDeg(face - upward * trunk.upward, trunk.ahead);
}

bool isMedian(JointLimit limit) {
    return limit == JointLimit::trunk_rotation || limit == JointLimit::head_rotation ||
           limit == JointLimit::head_tilt;
}

std::optional<LimitViolation> violation(JointLimit limit, Side side, const Skeleton& skeleton,
                                        const HumanoidMap& map, const std::vector<World>& world) {
    LimitViolation out;
    out.limit = limit;
    if (!isMedian(limit)) out.side = side;
    int beyond = 0;
    for (std::size_t f = 0; f < world.size(); ++f) {
        const auto angle = jointAngle(limit, side, skeleton, map, world[f]);
        if (!angle) return std::nullopt;
        const double excess = *angle - jointLimitDegrees(limit);
        if (!(excess > 0.0)) continue;
        ++beyond;
        if (excess > out.max_deg) {
            out.max_deg = excess;
            out.frame = static_cast<int>(f);
        }
    }
    if (beyond == 0) return std::nullopt;
    out.share = beyond / static_cast<double>(world.size());
    return out;
}

/// Closest points' distance of two segments (the quadratic form's minimum, clamped to both).
double segmentDistance(const Vec3& p, const Vec3& p_end, const Vec3& q, const Vec3& q_end) {
    const Vec3 u = p_end - p;
    const Vec3 v = q_end - q;
    const Vec3 w = p - q;
    const double a = glm::dot(u, u), b = glm::dot(u, v), c = glm::dot(v, v);
    const double d = glm::dot(u, w), e = glm::dot(v, w);
    constexpr double nothing = 1e-18;
    double s = 0.0;
    double t = 0.0;
    if (a > nothing && c > nothing) {
        const double across = a * c - b * b;
        s = across > nothing ? std::clamp((b * e - c * d) / across, 0.0, 1.0) : 0.0;
        t = (b * s + e) / c;
        if (t < 0.0 || t > 1.0) {
            t = std::clamp(t, 0.0, 1.0);
            s = std::clamp((b * t - d) / a, 0.0, 1.0);
        }
    } else if (a > nothing) {
        s = std::clamp(-d / a, 0.0, 1.0);
    } else if (c > nothing) {
        t = std::clamp(e / c, 0.0, 1.0);
    }
    return glm::length((p + s * u) - (q + t * v));
}

struct Body {
    std::array<Capsule, 2> trunk;
    Capsule head;
};

/// Distance from hips to head of the 1.75 m person for whom the radii are (referenceHumanoid()).
constexpr double reference_trunk_m = 0.60;

double bodyScale(const World& world, const HumanoidMap& map) {
    return glm::length(at(world, map, Bone::head) - at(world, map, Bone::hips)) / reference_trunk_m;
}

Body bodyCapsules(const World& world, const HumanoidMap& map, double scale) {
    Body body;
    const Vec3 neck = at(world, map, Bone::neck);
    const auto trunk = [&](Bone leg, Bone arm) {
        return Capsule{at(world, map, leg), 0.5 * (neck + at(world, map, arm)), 0.10 * scale};
    };
    body.trunk = {trunk(Bone::leftUpperLeg, Bone::leftUpperArm),
                  trunk(Bone::rightUpperLeg, Bone::rightUpperArm)};
    const Vec3 head = at(world, map, Bone::head);
    const Vec3 upward = glm::normalize(head - neck);
    body.head = {head + 0.03 * scale * upward, head + 0.12 * scale * upward, 0.09 * scale};
    return body;
}

}  // namespace

std::optional<FootSkate> footSkate(const std::vector<World>& world, const HumanoidMap& map,
                                   double frame_time_s) {
    constexpr double contact_m = 0.025;
    if (world.size() < 2) return std::nullopt;
    FootSkate out;
    for (const Side side : {Side::left, Side::right}) {
        const LegBones leg = legBones(side);
        const Bone bone = map.has(leg.toes) ? leg.toes : leg.foot;
        if (!map.has(bone)) return std::nullopt;
        const auto trajectory = jointTrajectory(world, map[bone]);
        const auto velocity = velocities(trajectory, frame_time_s);
        double floor = trajectory.front().y;
        for (const Vec3& p : trajectory) floor = std::min(floor, p.y);
        const double share = 0.5 / static_cast<double>(trajectory.size());
        for (std::size_t f = 0; f < trajectory.size(); ++f) {
            const double height = trajectory[f].y - floor;
            if (height >= contact_m) continue;
            out.contact_share += share;
            out.speed_m_s +=
                share * std::hypot(velocity[f].x, velocity[f].z) * (2.0 - std::exp2(height / contact_m));
        }
    }
    return out;
}

std::string_view jointLimitName(JointLimit limit) {
    return limits[static_cast<std::size_t>(limit)].name;
}

double jointLimitDegrees(JointLimit limit) {
    return limits[static_cast<std::size_t>(limit)].degrees;
}

std::vector<LimitViolation> jointLimitViolations(const Skeleton& skeleton, const HumanoidMap& map,
                                                 const std::vector<World>& world) {
    std::vector<LimitViolation> out;
    for (const LimitRow& row : limits)
        for (const Side side : {Side::left, Side::right}) {
            if (isMedian(row.limit) && side == Side::right) continue;
            if (auto found = violation(row.limit, side, skeleton, map, world)) out.push_back(*found);
        }
    return out;
}

double capsuleDistance(const Capsule& a, const Capsule& b) {
    return segmentDistance(a.from, a.to, b.from, b.to) - a.radius_m - b.radius_m;
}

std::vector<Intersection> selfIntersections(const Skeleton& skeleton, const HumanoidMap& map,
                                            const std::vector<World>& world) {
    if (!hasAll(map, {Bone::hips, Bone::neck, Bone::head, Bone::leftUpperLeg, Bone::rightUpperLeg,
                      Bone::leftUpperArm, Bone::rightUpperArm}))
        return {};
    const double scale = bodyScale(worldPose(skeleton, restPose(skeleton)), map);
    std::vector<Intersection> out;
    for (const Side side : {Side::left, Side::right}) {
        const ArmBones arm = armBones(side);
        if (!hasAll(map, {arm.lower_arm, arm.hand})) continue;
        const auto fingers = knuckle(map, side);
        for (const bool with_head : {false, true}) {
            Intersection found{side, with_head, 0.0, 0.0, 0};
            int overlapping = 0;
            for (std::size_t f = 0; f < world.size(); ++f) {
                const Body body = bodyCapsules(world[f], map, scale);
                const Vec3 hand = at(world[f], map, arm.hand);
                const Capsule forearm{at(world[f], map, arm.lower_arm), hand, 0.04 * scale};
                const Capsule palm{hand, fingers ? at(world[f], map, *fingers) : hand, 0.03 * scale};
                double nearest = 1.0;
                for (const Capsule& limb : {forearm, palm}) {
                    if (with_head) {
                        nearest = std::min(nearest, capsuleDistance(limb, body.head));
                        continue;
                    }
                    for (const Capsule& trunk : body.trunk)
                        nearest = std::min(nearest, capsuleDistance(limb, trunk));
                }
                if (nearest >= 0.0) continue;
                ++overlapping;
                if (-nearest > found.depth_m) {
                    found.depth_m = -nearest;
                    found.frame = static_cast<int>(f);
                }
            }
            if (overlapping == 0) continue;
            found.share = overlapping / static_cast<double>(world.size());
            out.push_back(found);
        }
    }
    return out;
}

}  // namespace deixis::motion
