#include "motion/pointing/body_shape.hpp"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/pointing/rays.hpp"
#include "motion/pointing/stretched_arm.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

struct Limb {
    Bone from, to;
    double radius_m;  // of a body of reference_height_m
};
constexpr Limb legs[] = {{leftUpperLeg, leftLowerLeg, 0.085}, {leftLowerLeg, leftFoot, 0.060},
                         {leftFoot, leftToes, 0.050},         {rightUpperLeg, rightLowerLeg, 0.085},
                         {rightLowerLeg, rightFoot, 0.060},   {rightFoot, rightToes, 0.050}};
constexpr double neck_m = 0.06, head_m = 0.105, girdle_m = 0.075, chest_m = 0.105, waist_m = 0.10;
constexpr double upper_arm_m = 0.055, forearm_m = 0.045, hand_m = 0.045;

class Shape {
  public:
    Shape(const HumanoidMap& map, const std::vector<Pose>& world) : map_(map), world_(world) {
        const double head_height_m = has({head}) ? at(head).y : 0.0;
        const Skeleton& reference = referenceHumanoid();
        const double reference_m =
            worldPose(reference, restPose(reference))[static_cast<std::size_t>(head)].position.y;
        scale_ = head_height_m > 0.0 ? head_height_m / reference_m : 1.0;
    }

    [[nodiscard]] bool has(std::initializer_list<Bone> bones) const {
        for (const Bone bone : bones)
            if (!map_.has(bone)) return false;
        return true;
    }
    [[nodiscard]] const Vec3& at(Bone bone) const {
        return world_[static_cast<std::size_t>(map_[bone])].position;
    }
    void add(const Vec3& a, const Vec3& b, double radius_m) {
        const auto rounded = [](const Vec3& v) { return glm::round(v * 1e4) / 1e4; };
        capsules.push_back({rounded(a), rounded(b), std::round(scale_ * radius_m * 1e4) / 1e4});
    }
    [[nodiscard]] double scaled(double metres) const { return scale_ * metres; }

    std::vector<Capsule> capsules;

  private:
    const HumanoidMap& map_;
    const std::vector<Pose>& world_;
    double scale_ = 1.0;
};

void addTrunk(Shape& shape) {
    if (shape.has({head})) {
        const Vec3& base = shape.at(head);
        shape.add(base + Vec3(0.0, shape.scaled(0.07), shape.scaled(0.01)),
                  base + Vec3(0.0, shape.scaled(0.12), shape.scaled(0.01)), head_m);
        if (shape.has({neck})) shape.add(shape.at(neck), base, neck_m);
    }
    if (shape.has({leftUpperArm, rightUpperArm}))
        shape.add(shape.at(leftUpperArm), shape.at(rightUpperArm), girdle_m);
    if (!shape.has({leftUpperArm, rightUpperArm, hips})) return;
    // Chest and waist are broader than deep: a pair of uprights.
    const Vec3 low = shape.at(hips);
    for (const double side : {-1.0, 1.0}) {
        const Vec3 high = 0.5 * (shape.at(leftUpperArm) + shape.at(rightUpperArm)) - shape.scaled(0.06) * up;
        const Vec3 aside = side * 0.5 * glm::normalize(shape.at(leftUpperArm) - shape.at(rightUpperArm));
        shape.add(high + shape.scaled(0.16) * aside, low + shape.scaled(0.14) * aside, chest_m);
        shape.add(low + shape.scaled(0.17) * aside, low + shape.scaled(0.17) * aside - shape.scaled(0.1) * up,
                  waist_m);
    }
}

void addArm(Shape& shape, const Skeleton& skeleton, const HumanoidMap& map, const std::vector<Pose>& world,
            Side side, const std::optional<Vec3>& pointing_at) {
    const ArmBones arm = armBones(side);
    if (!shape.has({arm.upper_arm, arm.lower_arm, arm.hand})) return;
    if (pointing_at && shape.has({head})) {
        const StretchedArm stretched = stretchedArm(skeleton, map, world, side, *pointing_at);
        const Vec3 elbow = 0.4 * stretched.fingertip + 0.6 * stretched.shoulder;
        shape.add(stretched.shoulder, elbow, upper_arm_m);
        shape.add(elbow, stretched.fingertip, forearm_m);
        return;
    }
    shape.add(shape.at(arm.upper_arm), shape.at(arm.lower_arm), upper_arm_m);
    shape.add(shape.at(arm.lower_arm), shape.at(arm.hand), forearm_m);
    shape.add(shape.at(arm.hand), fingertipPosition(skeleton, map, world, side), hand_m);
}

}  // namespace

std::vector<Capsule> bodyShape(const Skeleton& skeleton, const HumanoidMap& map,
                               const std::vector<Pose>& world, const std::optional<Vec3>& pointing_at) {
    Shape shape(map, world);
    addTrunk(shape);
    for (const Limb& limb : legs)
        if (shape.has({limb.from, limb.to})) shape.add(shape.at(limb.from), shape.at(limb.to), limb.radius_m);
    for (const Side side : {Side::left, Side::right})
        addArm(shape, skeleton, map, world, side,
               pointing_at && handFor(*pointing_at) == side ? pointing_at : std::nullopt);
    return std::move(shape.capsules);
}

}  // namespace deixis::motion
