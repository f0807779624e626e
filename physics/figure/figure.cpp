#include "physics/figure/figure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>
#include <utility>

#include "hinges.hpp"
#include "motion/skeleton/axes.hpp"

namespace deixis::physics {

namespace {

using motion::Bone;
using motion::Side;
using motion::z_axis;

/// Of Deixis's own avatar: from the ankles to the head's joint, over its height.
constexpr double head_over_ankles_share = (1.530 - 0.085) / 1.750;

struct LegBones {
    Bone upper, lower, foot, toes;
};
LegBones legBones(Side side) {
    if (side == Side::left) return {Bone::leftUpperLeg, Bone::leftLowerLeg, Bone::leftFoot, Bone::leftToes};
    return {Bone::rightUpperLeg, Bone::rightLowerLeg, Bone::rightFoot, Bone::rightToes};
}

std::string named(Side side, std::string_view part) {
    return fmt::format("{} {}", motion::sideName(side), part);
}

class FigureMaker {
  public:
    FigureMaker(const motion::Skeleton& avatar, Stance stance) {
        figure_.skeleton = avatar;
        figure_.map = motion::mapByVrmNames(avatar);
        figure_.stance = stance;
        rest_ = motion::worldPose(avatar, motion::restPose(avatar));
    }

    Result<Figure> make() {
        if (auto fits = check(); !fits) return tl::unexpected(fits.error());
        const double ankle_y = 0.5 * (at(Bone::leftFoot).y + at(Bone::rightFoot).y);
        figure_.stature_m = (at(Bone::head).y - ankle_y) / head_over_ankles_share;
        if (!(figure_.stature_m > 0.1))
            return fail("", "the avatar's head is not above its feet in its rest pose",
                        "A body is made for an avatar that stands in the T pose");
        figure_.mass_kg = bodyMass(figure_.stature_m);
        addTrunk();
        for (const Side side : {Side::left, Side::right}) addArm(side);
        if (figure_.stance == Stance::free)
            for (const Side side : {Side::left, Side::right}) addLeg(side);
        return std::move(figure_);
    }

  private:
    [[nodiscard]] Result<void> check() const {
        const auto missing = motion::missingBones(figure_.map);
        if (!missing.empty())
            return fail("", fmt::format("the avatar has no bone '{}'", missing.front()),
                        "A body needs hips, head, both arms to the hands and both legs to the feet");
        if (!figure_.map.has(Bone::spine) && !figure_.map.has(Bone::chest) &&
            !figure_.map.has(Bone::upperChest))
            return fail("", "the avatar has neither of the bones 'spine', 'chest' and 'upperChest'",
                        "A body needs a trunk that turns over its hips");
        for (const motion::Joint& joint : figure_.skeleton.joints)
            if (std::abs(joint.rest.orientation.w) < 1.0 - 1e-9)
                return fail("", fmt::format("the avatar's joint '{}' has a rest rotation", joint.name),
                            "A body is made for an avatar in the T pose without rest rotations");
        const std::pair<Bone, Bone> limbs[] = {
            {Bone::leftUpperArm, Bone::leftLowerArm},   {Bone::leftLowerArm, Bone::leftHand},
            {Bone::rightUpperArm, Bone::rightLowerArm}, {Bone::rightLowerArm, Bone::rightHand},
            {Bone::leftUpperLeg, Bone::leftLowerLeg},   {Bone::leftLowerLeg, Bone::leftFoot},
            {Bone::rightUpperLeg, Bone::rightLowerLeg}, {Bone::rightLowerLeg, Bone::rightFoot}};
        for (const auto& [upper, lower] : limbs)
            if (glm::distance(at(upper), at(lower)) < 0.01)
                return fail("", fmt::format("the avatar's bone '{}' has no length", motion::boneName(upper)),
                            "Limbs need a length to have a mass");
        return {};
    }

    [[nodiscard]] std::size_t joint(Bone bone) const { return static_cast<std::size_t>(figure_.map[bone]); }
    [[nodiscard]] Vec3 at(Bone bone) const { return rest_[joint(bone)].position; }
    /// The first that there is; the last must be there.
    [[nodiscard]] Bone firstOf(std::initializer_list<Bone> bones) const {
        for (const Bone bone : bones)
            if (figure_.map.has(bone)) return bone;
        return *(bones.end() - 1);
    }

    /// `mass` and `shape` in the coordinates of the avatar at rest.
    std::size_t add(std::string name, int parent, Bone start, Bone end, std::vector<Hinge> hinges,
                    const MassProperties& mass, const Shape& shape) {
        const Vec3 origin = at(start);
        Segment out;
        out.name = std::move(name);
        out.parent = parent;
        out.joint_m = parent < 0 ? origin : origin - origins_[static_cast<std::size_t>(parent)];
        out.bone = joint(end);
        out.first = figure_.hinges.size();
        out.count = hinges.size();
        out.mass = mass;
        out.mass.centre_m -= origin;
        out.shape = shape;
        out.shape.from_m -= origin;
        out.shape.to_m -= origin;
        figure_.hinges.insert(figure_.hinges.end(), hinges.begin(), hinges.end());
        figure_.segments.push_back(std::move(out));
        origins_.push_back(origin);
        return figure_.segments.size() - 1;
    }

    void turns(std::size_t segment, std::initializer_list<std::pair<Bone, double>> shares) {
        // What a missing bone would take falls to the next.
        double left = 0.0;
        for (const auto& [bone, share] : shares) {
            left += share;
            if (!figure_.map.has(bone)) continue;
            figure_.segments[segment].turning.push_back({joint(bone), left});
            left = 0.0;
        }
        figure_.segments[segment].turning.back().share += left;
    }

    /// Of a person of 1.75 m, in centimetres, for this one.
    [[nodiscard]] double scaled(double cm) const { return 0.01 * cm * figure_.stature_m / 1.75; }

    void addTrunk() {
        const Vec3 hips = 0.5 * (at(Bone::leftUpperLeg) + at(Bone::rightUpperLeg));
        const Bone base = firstOf({Bone::spine, Bone::chest, Bone::upperChest});
        const Bone top = firstOf({Bone::upperChest, Bone::chest, Bone::spine});
        const Bone neck = firstOf({Bone::neck, Bone::head});
        const Vec3 c7 = at(neck);
        const Vec3 xiphoid = c7 + upper_trunk_share * (hips - c7);
        const Vec3 navel = xiphoid + middle_trunk_share * (hips - c7);
        const double kg = figure_.mass_kg;
        add("pelvis", -1, Bone::hips, Bone::hips, {}, massOf(BodyPart::lower_trunk, kg, navel, hips, z_axis),
            {at(Bone::leftUpperLeg), at(Bone::rightUpperLeg), scaled(10.0)});
        chest_ = add("chest", 0, base, top, trunkHinges(),
                     together(massOf(BodyPart::upper_trunk, kg, c7, xiphoid, z_axis),
                              massOf(BodyPart::middle_trunk, kg, xiphoid, navel, z_axis)),
                     {navel, c7 + 0.3 * (xiphoid - c7), scaled(11.0)});
        // As the systems' trunks turn (docs/systems.md).
        turns(chest_, {{Bone::spine, 0.25}, {Bone::chest, 0.35}, {Bone::upperChest, 0.40}});
        const Vec3 vertex = c7 + Vec3(0.0, head_length_share * figure_.stature_m, 0.0);
        const std::size_t head = add("head", static_cast<int>(chest_), neck, Bone::head, neckHinges(),
                                     massOf(BodyPart::head, kg, vertex, c7, z_axis),
                                     {at(Bone::head), vertex - Vec3(0.0, scaled(9.0), 0.0), scaled(9.0)});
        turns(head, {{Bone::neck, 0.4}, {Bone::head, 0.6}});
    }

    void addArm(Side side) {
        const motion::ArmBones bones = motion::armBones(side);
        const Vec3 shoulder = at(bones.upper_arm), elbow = at(bones.lower_arm), wrist = at(bones.hand);
        const Bone middle = side == Side::left ? Bone::leftMiddleProximal : Bone::rightMiddleProximal;
        const Vec3 ahead = glm::normalize(wrist - elbow);
        const Vec3 knuckle =
            figure_.map.has(middle) ? at(middle) : wrist + hand_length_share * figure_.stature_m * ahead;
        const double kg = figure_.mass_kg;
        const auto upper =
            add(named(side, "upper arm"), static_cast<int>(chest_), bones.upper_arm, bones.upper_arm,
                shoulderHinges(side, elbow - shoulder),
                massOf(BodyPart::upper_arm, kg, shoulder, elbow, z_axis), {shoulder, elbow, scaled(4.5)});
        // The shoulder girdle stays as it is.
        turns(upper, {{bones.shoulder, 0.0}, {bones.upper_arm, 1.0}});
        const auto forearm =
            add(named(side, "forearm"), static_cast<int>(upper), bones.lower_arm, bones.lower_arm,
                elbowHinges(side), massOf(BodyPart::forearm, kg, elbow, wrist, z_axis),
                {elbow, wrist, scaled(4.0)});
        turns(forearm, {{bones.lower_arm, 1.0}});
        add(named(side, "hand"), static_cast<int>(forearm), bones.hand, bones.hand, {},
            massOf(BodyPart::hand, kg, wrist, knuckle, z_axis),
            {wrist, knuckle + 0.8 * (knuckle - wrist), scaled(3.0)});
    }

    void addLeg(Side side) {
        const LegBones bones = legBones(side);
        const Vec3 hip = at(bones.upper), knee = at(bones.lower), ankle = at(bones.foot);
        const double kg = figure_.mass_kg;
        const auto thigh = add(named(side, "thigh"), 0, bones.upper, bones.upper, hipHinges(side),
                               massOf(BodyPart::thigh, kg, hip, knee, z_axis), {hip, knee, scaled(7.0)});
        turns(thigh, {{bones.upper, 1.0}});
        const auto shank =
            add(named(side, "shank"), static_cast<int>(thigh), bones.lower, bones.lower, kneeHinges(side),
                massOf(BodyPart::shank, kg, knee, ankle, z_axis), {knee, ankle, scaled(5.0)});
        turns(shank, {{bones.lower, 1.0}});
        // A quarter of the foot is behind the ankle (assumed), the sole is on the floor, y = 0.
        const double length_m = foot_length_share * figure_.stature_m;
        const Vec3 heel{ankle.x, 0.4 * ankle.y, ankle.z - 0.25 * length_m};
        const Vec3 toe = heel + Vec3(0.0, 0.0, length_m);
        Shape sole{{heel.x, 0.35 * ankle.y, heel.z}, {toe.x, 0.35 * ankle.y, toe.z}};
        sole.half_box_m = {scaled(4.5), 0.35 * ankle.y, 0.5 * length_m};
        const auto foot = add(named(side, "foot"), static_cast<int>(shank), bones.foot, bones.foot,
                              ankleHinges(side), massOf(BodyPart::foot, kg, heel, toe, z_axis), sole);
        turns(foot, {{bones.foot, 1.0}});
    }

    Figure figure_;
    std::vector<Pose> rest_;
    std::vector<Vec3> origins_;
    std::size_t chest_ = 0;
};

template <typename Items>
std::size_t indexByName(const Items& items, std::string_view name) {
    for (std::size_t i = 0; i < items.size(); ++i)
        if (items[i].name == name) return i;
    throw std::out_of_range(fmt::format("the body has no '{}'", name));
}

}  // namespace

std::size_t Figure::segment(std::string_view name) const {
    return indexByName(segments, name);
}

std::size_t Figure::hinge(std::string_view name) const {
    return indexByName(hinges, name);
}

Result<Figure> makeFigure(const motion::Skeleton& avatar, Stance stance) {
    return FigureMaker(avatar, stance).make();
}

}  // namespace deixis::physics
