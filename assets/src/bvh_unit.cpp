#include "bvh_unit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string_view>

#include "motion/retarget.hpp"

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

// Thigh and shin as a part of stature (Drillis & Contini 1966: hip 0.530, ankle 0.039).
constexpr double leg_of_stature = 0.491;

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
    using motion::Bone;
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

}  // namespace

LengthUnit detectUnit(const motion::Clip& clip) {
    double stature = statureByLegs(clip);
    if (stature <= 0.0) stature = statureByExtent(clip);
    if (stature <= 0.0) return {1.0, "metre (assumed: the figure has no size)"};
    for (const Unit& unit : units)
        if (const double metres = stature * unit.metres; metres >= shortest_m && metres <= tallest_m)
            return {unit.metres, std::string(unit.name) + " (detected)"};
    const auto distance = [&](const Unit& u) { return std::abs(std::log(stature * u.metres / usual_m)); };
    const Unit* best = &*std::min_element(
        units.begin(), units.end(), [&](const Unit& a, const Unit& b) { return distance(a) < distance(b); });
    return {best->metres, std::string(best->name) + " (guessed: no common unit gives a person's size)"};
}

}  // namespace deixis::assets
