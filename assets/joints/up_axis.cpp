#include "up_axis.hpp"

#include <algorithm>
#include <array>

#include "motion/humanoid/rise_axis.hpp"

namespace deixis::assets {

namespace {

struct Named {
    UpAxis axis;
    std::string_view name;
    Vec3 direction;
};
const std::array<Named, 6> axes{{{UpAxis::x, "x", {1, 0, 0}},
                                 {UpAxis::y, "y", {0, 1, 0}},
                                 {UpAxis::z, "z", {0, 0, 1}},
                                 {UpAxis::minus_x, "-x", {-1, 0, 0}},
                                 {UpAxis::minus_y, "-y", {0, -1, 0}},
                                 {UpAxis::minus_z, "-z", {0, 0, -1}}}};

FoundUp axisOf(const std::vector<Vec3>& rises) {
    const auto found = motion::riseAxis(rises);
    if (!found) return {UpAxis::y, Origin::assumed};
    const auto named =
        std::find_if(axes.begin(), axes.end(), [&](const Named& a) { return a.direction == *found; });
    return {named->axis, Origin::detected};
}

/// From the feet, or what is the lowest that is known, to the head or neck; 0 where nothing is known.
Vec3 riseOf(const motion::BonePositions& p) {
    using enum motion::Bone;
    const auto& top = p[head] ? p[head] : p[neck];
    if (!top) return Vec3(0.0);
    if (p[leftFoot] && p[rightFoot]) return *top - 0.5 * (*p[leftFoot] + *p[rightFoot]);
    if (p[hips]) return *top - *p[hips];
    if (p[spine] && p[neck]) return *p[neck] - *p[spine];
    return Vec3(0.0);
}

/// So many frames tell enough.
std::size_t strideOver(std::size_t frames) {
    constexpr std::size_t enough = 200;
    return std::max<std::size_t>(1, frames / enough);
}

}  // namespace

std::string_view upAxisName(UpAxis axis) {
    return axes[static_cast<std::size_t>(axis)].name;
}

std::optional<UpAxis> upAxisFromName(std::string_view name) {
    for (const Named& named : axes)
        if (named.name == name) return named.axis;
    return std::nullopt;
}

Quat yFromUp(UpAxis axis) {
    if (axis == UpAxis::y) return no_rotation;
    return rotationBetween(axes[static_cast<std::size_t>(axis)].direction, up);
}

FoundUp findUp(const motion::Clip& clip, const motion::HumanoidMap& map, const std::optional<UpAxis>& given) {
    if (given) return {*given, Origin::given};
    std::vector<Vec3> rises;
    std::vector<Pose> world;
    motion::BonePositions positions;
    for (std::size_t f = 0; f < clip.frames.size(); f += strideOver(clip.frames.size())) {
        motion::worldPose(clip.skeleton, clip.frames[f], world);
        for (std::size_t b = 0; b < motion::bone_count; ++b)
            if (const int joint = map.joint[b]; joint >= 0)
                positions.at[b] = world[static_cast<std::size_t>(joint)].position;
        rises.push_back(riseOf(positions));
    }
    return axisOf(rises);
}

FoundUp findUp(const std::vector<motion::BonePositions>& frames, const std::optional<UpAxis>& given) {
    if (given) return {*given, Origin::given};
    std::vector<Vec3> rises;
    for (std::size_t f = 0; f < frames.size(); f += strideOver(frames.size()))
        rises.push_back(riseOf(frames[f]));
    return axisOf(rises);
}

void turnUp(motion::Clip& clip, UpAxis axis) {
    if (axis == UpAxis::y) return;
    const Pose turn{Vec3(0.0), yFromUp(axis)};
    for (std::size_t j = 0; j < clip.skeleton.joints.size(); ++j) {
        motion::Joint& joint = clip.skeleton.joints[j];
        if (joint.parent >= 0) continue;
        joint.rest = turn * joint.rest;
        for (motion::LocalPose& frame : clip.frames) frame.joints[j] = turn * frame.joints[j];
    }
}

}  // namespace deixis::assets
