#include "arm_twist.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "motion/skeleton/clip_edit.hpp"

namespace deixis::motion {

namespace {

/// 0 up to `low`, 1 from `high` on, smooth between.
double rise(double value, double low, double high) {
    const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

Vec3 acrossOf(const Vec3& v, const Vec3& axis) {
    return v - glm::dot(v, axis) * axis;
}

// All below is of a left arm whose T pose lies along +x, in the chest's frame; a right arm is mirrored.
const Vec3 outward{1.0, 0.0, 0.0};
const Vec3 ahead{0.0, 0.0, 1.0};

/// Where the elbow bends the forearm when the arm is almost straight, across `upper_arm`. Turning there from
/// the T pose by the shortest way bends it ahead while the arm hangs or lies sideways; stretched ahead it
/// would bend inward, so it is rolled half-way up there.
Vec3 restingBend(const Vec3& upper_arm) {
    constexpr double roll_ahead_rad = 0.8;
    const Vec3 bend = rotationBetween(outward, upper_arm) * ahead;
    const double share = rise(upper_arm.z, 0.0, 0.8);
    return glm::angleAxis(-share * roll_ahead_rad, upper_arm) * bend;
}

/// Where the elbow bends: as the plane of both bones says. An arm that is nearly straight has none: the
/// resting bend takes over there by and by.
Vec3 bendOf(const Vec3& upper_arm, const Vec3& forearm) {
    constexpr double weight = 0.2;
    const Vec3 seen = acrossOf(forearm, upper_arm);
    const double sine = glm::length(seen);
    const bool folded = glm::dot(upper_arm, forearm) < 0.0;
    const double share = folded ? 0.0 : 1.0 - rise(sine, 0.1, 0.6);
    const Vec3 resting = restingBend(upper_arm);
    const Vec3 bend = seen + weight * share * resting;
    return glm::length(bend) > 1e-6 ? glm::normalize(bend) : resting;
}

/// How a forearm rolls from neutral (the thumb where the elbow bends to) by where it points, and its wrist
/// bends.
struct Wrist {
    double roll_rad = 0.0;       ///< about the forearm, above 0 brings the palm of a level one down
    double extension_rad = 0.0;  ///< of the hand, to its back
};

/// Palms look down and inward before the body, up where the forearm points out with the elbow low, and ahead
/// where it is raised, but for a hand at the face. The neutral palm has its weight, too, so that nothing
/// flips.
Wrist wristOf(const Vec3& upper_arm, const Vec3& forearm, const Vec3& neutral_palm) {
    const double high = rise(forearm.y, 0.25, 0.7);
    const double to_face = std::max(rise(-forearm.x, 0.25, 0.6), rise(-forearm.z, 0.05, 0.5));
    const double raised = high * (1.0 - to_face);
    const double open = rise(forearm.x, 0.15, 0.6) * rise(-upper_arm.y, 0.4, 0.85) * (1.0 - high) *
                        rise(forearm.y, -0.75, -0.3);
    const double before = rise(forearm.z, 0.1, 0.6) * (1.0 - high) * (1.0 - open);
    const Vec3 wanted =
        3.0 * open * Vec3(0.0, 1.0, 0.0) + 0.3 * before * Vec3(0.0, -1.0, 0.0) + 4.0 * raised * ahead;
    const Vec3 palm = neutral_palm + acrossOf(wanted, forearm);
    Wrist wrist;
    wrist.roll_rad =
        std::atan2(glm::dot(forearm, glm::cross(neutral_palm, palm)), glm::dot(neutral_palm, palm));
    // A palm that faces ahead needs the more bend the more the forearm points there.
    const double ahead_deg = 10.0 + 50.0 * std::max(forearm.z, 0.0);
    wrist.extension_rad = radiansFromDegrees(-4.0 + 14.0 * before + ahead_deg * raised + 14.0 * open);
    return wrist;
}

ArmTurns leftArm(const Vec3& upper_arm, const Vec3& forearm) {
    ArmTurns turns;
    // The T pose's axes: along the bone, the hinge (up), and where it bends to (ahead).
    const Vec3 bend = bendOf(upper_arm, forearm);
    turns.upper_arm =
        glm::normalize(glm::quat_cast(glm::dmat3(upper_arm, glm::cross(bend, upper_arm), bend)));
    // About the hinge first: the shortest way has none where the forearm is folded back.
    const Vec3 hinge = glm::cross(upper_arm, bend);
    const double flexion = std::atan2(glm::dot(forearm, bend), glm::dot(forearm, upper_arm));
    const Quat bent = glm::angleAxis(flexion, hinge) * turns.upper_arm;
    const Quat straightened = rotationBetween(bent * outward, forearm) * bent;
    const Wrist wrist = wristOf(upper_arm, forearm, straightened * Vec3(0.0, -1.0, 0.0));
    // Half of the roll in the forearm, half at the wrist: a single joint would wring the skin.
    turns.forearm = glm::normalize(glm::angleAxis(0.5 * wrist.roll_rad, forearm) * straightened);
    turns.hand_in_forearm = glm::angleAxis(0.5 * wrist.roll_rad, outward) *
                            glm::angleAxis(wrist.extension_rad, Vec3(0.0, 0.0, 1.0));
    return turns;
}

Quat mirroredArm(const Quat& q) {
    return {q.w, q.x, -q.y, -q.z};
}

}  // namespace

ArmTurns armTurns(Side side, const Quat& chest, const Vec3& upper_arm, const Vec3& forearm) {
    const Quat to_chest = glm::conjugate(chest);
    Vec3 upper = to_chest * upper_arm;
    Vec3 lower = to_chest * forearm;
    const bool left = side == Side::left;
    if (!left) {
        upper = mirrored(upper);
        lower = mirrored(lower);
    }
    ArmTurns turns = leftArm(upper, lower);
    if (!left)
        turns = {mirroredArm(turns.upper_arm), mirroredArm(turns.forearm),
                 mirroredArm(turns.hand_in_forearm)};
    turns.upper_arm = chest * turns.upper_arm;
    turns.forearm = chest * turns.forearm;
    return turns;
}

}  // namespace deixis::motion
