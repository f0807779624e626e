#include "length_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <string_view>

#include "motion/humanoid/mapping.hpp"

namespace deixis::assets {

namespace {

struct Unit {
    double metres;
    std::string_view name;
};

// No two of them make one figure a person of 1.4 to 2.1 m. The CMU conversions by cgspeed are in inches
// divided by 0.45.
constexpr std::array<Unit, 6> units{{{1.0, "metre"},
                                     {0.1, "decimetre"},
                                     {0.0254 / 0.45, "1/0.45 inch"},
                                     {0.0254, "inch"},
                                     {0.01, "centimetre"},
                                     {0.001, "millimetre"}}};
constexpr double shortest_m = 1.4;
constexpr double tallest_m = 2.1;
constexpr double usual_m = 1.72;
// Children from about three years on; only in the units that recordings are in today, since in others a tall
// adult is likelier.
constexpr double smallest_child_m = 0.95;
constexpr std::array<std::string_view, 3> of_today{"metre", "centimetre", "millimetre"};

// Thigh and shin as a part of stature (Drillis & Contini 1966: hip 0.530, ankle 0.039).
constexpr double leg_of_stature = 0.491;
// Upper arm and forearm (the same).
constexpr double arm_of_stature = 0.186 + 0.146;

using motion::Bone;

double segmentLength(const motion::Clip& clip, int joint, int ancestor) {
    double length = 0.0;
    const motion::LocalPose& pose = clip.frames.front();
    while (joint >= 0 && joint != ancestor) {
        const auto index = static_cast<std::size_t>(joint);
        length += glm::length(pose.joints[index].position);
        joint = clip.skeleton.joints[index].parent;
    }
    return length;
}

/// Stature by the legs' bones, which no pose changes; 0 where the figure has no legs.
double statureByLegs(const motion::Clip& clip) {
    const motion::HumanoidMap map = motion::detectHumanoid(clip.skeleton);
    if (!map.has(Bone::leftUpperLeg) || !map.has(Bone::leftFoot)) return 0.0;
    return segmentLength(clip, map[Bone::leftFoot], map[Bone::leftUpperLeg]) / leg_of_stature;
}

/// The longest edge of the box around the first frame: in a T pose the stature, whatever the up axis.
double statureByExtent(const motion::Clip& clip) {
    const auto world = motion::worldPose(clip.skeleton, clip.frames.front());
    Vec3 low = world.front().position;
    Vec3 high = low;
    for (int i = 0; i < clip.skeleton.size(); ++i) {
        const Vec3 tip = motion::tipPosition(clip.skeleton, world, i);
        const Vec3 base = world[static_cast<std::size_t>(i)].position;
        low = glm::min(low, glm::min(tip, base));
        high = glm::max(high, glm::max(tip, base));
    }
    const Vec3 size = high - low;
    return std::max({size.x, size.y, size.z});
}

FoundUnit unitOf(double stature) {
    if (!(stature > 0.0) || !std::isfinite(stature))
        return {1.0, Origin::assumed, "metre, since the figure has no size"};
    for (const Unit& unit : units)
        if (const double metres = stature * unit.metres; metres >= shortest_m && metres <= tallest_m)
            return {unit.metres, Origin::detected, std::string(unit.name)};
    for (const Unit& unit : units)
        if (const double metres = stature * unit.metres;
            metres >= smallest_child_m && metres < shortest_m &&
            std::find(of_today.begin(), of_today.end(), unit.name) != of_today.end())
            return {unit.metres, Origin::assumed,
                    fmt::format("{}, in which the figure is a child {:.2f} m tall", unit.name, metres)};
    const auto distance = [&](const Unit& u) { return std::abs(std::log(stature * u.metres / usual_m)); };
    const Unit* best = &*std::min_element(
        units.begin(), units.end(), [&](const Unit& a, const Unit& b) { return distance(a) < distance(b); });
    return {best->metres, Origin::assumed,
            std::string(best->name) + ", since no common unit gives a person's size"};
}

/// Mean length of the line over those bones, of the frames that know them all; 0 where none does.
double meanLength(const std::vector<motion::BonePositions>& frames, std::initializer_list<Bone> line) {
    double sum = 0.0;
    int count = 0;
    for (const motion::BonePositions& p : frames) {
        if (!std::all_of(line.begin(), line.end(), [&](Bone bone) { return p[bone].has_value(); })) continue;
        ++count;
        for (const Bone* bone = line.begin(); bone + 1 != line.end(); ++bone)
            sum += glm::length(*p[bone[1]] - *p[bone[0]]);
    }
    return count == 0 ? 0.0 : sum / count;
}

}  // namespace

FoundUnit detectUnit(const motion::Clip& clip) {
    const double by_legs = statureByLegs(clip);
    return unitOf(by_legs > 0.0 ? by_legs : statureByExtent(clip));
}

FoundUnit detectUnit(const std::vector<motion::BonePositions>& frames) {
    using enum Bone;
    const double leg = 0.5 * (meanLength(frames, {leftUpperLeg, leftLowerLeg, leftFoot}) +
                              meanLength(frames, {rightUpperLeg, rightLowerLeg, rightFoot}));
    if (leg > 0.0) return unitOf(leg / leg_of_stature);
    const double arm = 0.5 * (meanLength(frames, {leftUpperArm, leftLowerArm, leftHand}) +
                              meanLength(frames, {rightUpperArm, rightLowerArm, rightHand}));
    return unitOf(arm / arm_of_stature);
}

std::string givenUnitName(double metres) {
    for (const Unit& unit : units)
        if (std::abs(unit.metres - metres) < 1e-9 * metres) return std::string(unit.name);
    return fmt::format("{:.6g} m", metres);
}

std::string unitWords(const FoundUnit& unit) {
    return unit.name + " (" + std::string(originName(unit.origin)) + ")";
}

}  // namespace deixis::assets
