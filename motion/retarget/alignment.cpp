#include "alignment.hpp"
#include "motion/skeleton/bone_index.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>

namespace deixis::motion {

namespace {

using enum Bone;

constexpr double shortest_bone_m = 1e-4;

/// The bones at which a bone may point, best first.
std::initializer_list<Bone> aims(Bone bone) {
#define DEIXIS_AIMS(from, ...)                                        \
    case from: {                                                      \
        static constexpr std::initializer_list<Bone> to{__VA_ARGS__}; \
        return to;                                                    \
    }
    switch (bone) {
        DEIXIS_AIMS(leftUpperArm, leftLowerArm)
        DEIXIS_AIMS(leftLowerArm, leftHand)
        DEIXIS_AIMS(leftHand, leftMiddleProximal, leftIndexProximal)
        DEIXIS_AIMS(leftUpperLeg, leftLowerLeg)
        DEIXIS_AIMS(leftLowerLeg, leftFoot)
        DEIXIS_AIMS(leftFoot, leftToes)
        DEIXIS_AIMS(leftThumbMetacarpal, leftThumbProximal)
        DEIXIS_AIMS(leftThumbProximal, leftThumbDistal)
        DEIXIS_AIMS(leftIndexProximal, leftIndexIntermediate)
        DEIXIS_AIMS(leftIndexIntermediate, leftIndexDistal)
        DEIXIS_AIMS(leftMiddleProximal, leftMiddleIntermediate)
        DEIXIS_AIMS(leftMiddleIntermediate, leftMiddleDistal)
        DEIXIS_AIMS(leftRingProximal, leftRingIntermediate)
        DEIXIS_AIMS(leftRingIntermediate, leftRingDistal)
        DEIXIS_AIMS(leftLittleProximal, leftLittleIntermediate)
        DEIXIS_AIMS(leftLittleIntermediate, leftLittleDistal)
        default:
            return {};
    }
#undef DEIXIS_AIMS
}

bool isLeft(Bone bone) {
    return boneName(bone).starts_with("left");
}

Vec3 across(const Vec3& v, const Vec3& axis) {
    return v - glm::dot(v, axis) * axis;
}

/// Angle from `from` to `to` about `axis` (unit), both taken across it.
double angleAbout(const Vec3& axis, const Vec3& from, const Vec3& to) {
    const Vec3 a = across(from, axis);
    const Vec3 b = across(to, axis);
    return std::atan2(glm::dot(axis, glm::cross(a, b)), glm::dot(a, b));
}

/// Rotation whose x axis is `x` and whose y axis lies with `y` in a plane.
Quat frame(const Vec3& x_axis, const Vec3& y_axis) {
    const Vec3 x = glm::normalize(x_axis);
    const Vec3 y = glm::normalize(across(y_axis, x));
    return glm::normalize(glm::quat_cast(glm::dmat3(x, y, glm::cross(x, y))));
}

class Aligner {
  public:
    Aligner(const BodyShape& avatar, const BodyShape& shape, const BoneTwists& twist)
        : avatar_(avatar), shape_(shape), twist_(twist) {}

    BoneTurns align(const TrunkAxes& avatar_axes, const TrunkAxes& axes) {
        out_.fill(no_rotation);
        at(hips) = frame(axes.hip_line, axes.hips_up) *
                   glm::conjugate(frame(avatar_axes.hip_line, avatar_axes.hips_up));
        at(upperChest) = frame(axes.shoulder_line, axes.chest_up) *
                         glm::conjugate(frame(avatar_axes.shoulder_line, avatar_axes.chest_up));
        at(spine) = glm::slerp(at(hips), at(upperChest), 1.0 / 3.0);
        at(chest) = glm::slerp(at(hips), at(upperChest), 2.0 / 3.0);
        for (const Bone bone : {neck, head, jaw, leftEye, rightEye}) at(bone) = at(upperChest);
        for (const bool left : {true, false}) {
            alignArm(left);
            alignLeg(left);
        }
        return out_;
    }

  private:
    Quat& at(Bone bone) { return out_[indexOf(bone)]; }

    /// As little turned from `base` as makes the bone point as in the shape.
    void pointFrom(const Quat& base, Bone bone) {
        const auto rest = avatar_.direction(bone);
        const auto wanted = shape_.direction(bone);
        at(bone) = base;
        if (!rest || !wanted) return;
        at(bone) =
            rotationBetween(base * *rest, *wanted) * base * glm::angleAxis(twist_[indexOf(bone)], *rest);
    }

    void alignArm(bool left) {
        const auto bone = [&](Bone b) { return left ? b : mirroredBone(b); };
        at(bone(leftShoulder)) = at(upperChest);
        pointFrom(at(upperChest), bone(leftUpperArm));
        pointFrom(at(bone(leftUpperArm)), bone(leftLowerArm));
        alignHand(bone);
        for (const Bone first : {leftThumbMetacarpal, leftIndexProximal, leftMiddleProximal, leftRingProximal,
                                 leftLittleProximal}) {
            Quat above = at(bone(leftHand));
            for (int i = 0; i < 3; ++i) {  // a finger's bones stand in a row
                const Bone b = bone(static_cast<Bone>(static_cast<int>(first) + i));
                pointFrom(above, b);
                above = at(b);
            }
        }
    }

    template <typename BoneOfSide>
    void alignHand(const BoneOfSide& bone) {
        const Bone hand = bone(leftHand);
        const auto palm = [&](const BodyShape& s) -> std::optional<Quat> {
            const auto along = s.direction(hand);
            const auto& first = s.at(bone(leftIndexProximal));
            const auto& last = s.at(bone(leftLittleProximal));
            if (!along || !first || !last || glm::length(across(*first - *last, *along)) < shortest_bone_m)
                return std::nullopt;
            return frame(*along, *first - *last);
        };
        const auto rest = palm(avatar_);
        const auto wanted = palm(shape_);
        if (rest && wanted)
            at(hand) = *wanted * glm::conjugate(*rest);
        else
            pointFrom(at(bone(leftLowerArm)), hand);
    }

    /// Where a foot points: at its toes or, where a rig has them rather below the ankle than ahead of it, at
    /// their tip. None where all lie straight below, which says nothing.
    [[nodiscard]] std::optional<Vec3> ahead(Bone foot, Bone toes, const Vec3& down) const {
        constexpr double straight_rad = 0.35, steep_rad = 0.7;
        auto best = shape_.direction(foot);
        double from_down = best ? angleBetween(*best, down) : 0.0;
        if (from_down > steep_rad) return best;
        const auto& ankle = shape_.at(foot);
        const auto& tip = shape_.tip[indexOf(toes)];
        if (ankle && tip && glm::length(*tip - *ankle) > shortest_bone_m) {
            const Vec3 at_tip = glm::normalize(*tip - *ankle);
            if (const double angle = angleBetween(at_tip, down); angle > from_down) {
                best = at_tip;
                from_down = angle;
            }
        }
        return from_down > straight_rad ? best : std::nullopt;
    }

    void alignLeg(bool left) {
        const auto bone = [&](Bone b) { return left ? b : mirroredBone(b); };
        const Bone shin = bone(leftLowerLeg);
        const Bone foot = bone(leftFoot);
        pointFrom(at(hips), bone(leftUpperLeg));
        pointFrom(at(bone(leftUpperLeg)), shin);
        at(foot) = at(shin);
        const auto rest = avatar_.direction(foot);
        const auto down = shape_.direction(shin);
        const auto wanted = down ? ahead(foot, bone(leftToes), *down) : std::nullopt;
        if (rest && wanted) {
            // The foot turns about the shin until it points the same way. Its slope stays the avatar's: how
            // high a rig's ankle lies over its toes says nothing about the sole; unless they differ wildly.
            constexpr double wild_rad = 0.6;
            const double turn = angleAbout(*down, at(shin) * *rest, *wanted);
            at(foot) = glm::angleAxis(turn, *down) * at(shin);
            if (angleBetween(at(foot) * *rest, *wanted) > wild_rad)
                at(foot) = rotationBetween(at(foot) * *rest, *wanted) * at(foot);
        }
        at(bone(leftToes)) = at(foot);
    }

    const BodyShape& avatar_;
    const BodyShape& shape_;
    const BoneTwists& twist_;
    BoneTurns out_{};
};

}  // namespace

std::optional<Vec3> BodyShape::direction(Bone bone) const {
    const auto& from = at(bone);
    if (!from) return std::nullopt;
    const bool left = isLeft(bone);
    for (const Bone aim : aims(left ? bone : mirroredBone(bone)))
        if (const auto& to = at(left ? aim : mirroredBone(aim));
            to && glm::length(*to - *from) > shortest_bone_m)
            return glm::normalize(*to - *from);
    if (const auto& to = tip[indexOf(bone)]; to && glm::length(*to - *from) > shortest_bone_m)
        return glm::normalize(*to - *from);
    return std::nullopt;
}

BodyShape shapeOf(const Skeleton& skeleton, const HumanoidMap& map, const std::vector<Pose>& world) {
    BodyShape shape;
    for (std::size_t b = 0; b < bone_count; ++b) {
        const int joint = map.joint[b];
        if (joint < 0) continue;
        shape.start[b] = world[static_cast<std::size_t>(joint)].position;
        if (skeleton.joints[static_cast<std::size_t>(joint)].end_site)
            shape.tip[b] = tipPosition(skeleton, world, joint);
        for (int child = joint + 1; child < skeleton.size() && !shape.tip[b]; ++child) {
            const Vec3& at = world[static_cast<std::size_t>(child)].position;
            if (skeleton.joints[static_cast<std::size_t>(child)].parent == joint &&
                glm::length(at - *shape.start[b]) > shortest_bone_m)
                shape.tip[b] = at;
        }
    }
    return shape;
}

TrunkAxes standingAxes(const BodyShape& shape) {
    const Vec3 rise = *shape.at(head) - 0.5 * (*shape.at(leftFoot) + *shape.at(rightFoot));
    return {*shape.at(leftUpperLeg) - *shape.at(rightUpperLeg), rise,
            *shape.at(leftUpperArm) - *shape.at(rightUpperArm), rise};
}

BoneTurns alignBody(const BodyShape& avatar, const TrunkAxes& avatar_axes, const BodyShape& shape,
                    const TrunkAxes& axes, const BoneTwists& twist) {
    return Aligner(avatar, shape, twist).align(avatar_axes, axes);
}

const std::array<Hinge, 4>& hinges() {
    static const Vec3 forward(0, 0, 1);
    static const std::array<Hinge, 4> all{{{leftUpperArm, leftLowerArm, leftHand, forward},
                                           {rightUpperArm, rightLowerArm, rightHand, forward},
                                           {leftUpperLeg, leftLowerLeg, leftFoot, -forward},
                                           {rightUpperLeg, rightLowerLeg, rightFoot, -forward}}};
    return all;
}

void HingeFit::add(const BoneTurns& rotation, const BodyShape& shape) {
    constexpr double smallest_bend = 0.17;  // sine; below 10 degrees the plane is mostly noise
    for (const Hinge& hinge : hinges()) {
        const auto upper = shape.direction(hinge.upper);
        const auto lower = shape.direction(hinge.lower);
        if (!upper || !lower) continue;
        const double bend = glm::length(glm::cross(*upper, *lower));
        const double weight = bend - smallest_bend;
        if (weight <= 0.0) continue;
        const auto look = [&](Bone bone, const Vec3& towards) {
            const auto rest = avatar_.direction(bone);
            if (!rest) return;
            const Vec3 local = glm::conjugate(rotation[indexOf(bone)]) * towards;
            const double angle = angleAbout(*rest, hinge.bend, local);
            cosine_[indexOf(bone)] += weight * std::cos(angle);
            sine_[indexOf(bone)] += weight * std::sin(angle);
        };
        look(hinge.upper, *lower);
        look(hinge.lower, -*upper);
    }
}

double HingeFit::twist(Bone bone) const {
    return std::atan2(sine_[indexOf(bone)], cosine_[indexOf(bone)] + prior_);
}

}  // namespace deixis::motion
