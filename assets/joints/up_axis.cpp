#include "up_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

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

/// Sums directions; those without length do not count.
class MeanDirection {
  public:
    void add(const Vec3& v) {
        if (const double length = glm::length(v); length > 1e-9 && std::isfinite(length)) sum_ += v / length;
    }
    [[nodiscard]] FoundUp axis() const {
        constexpr double least_cosine = 0.707;  // 45 degrees
        const auto best = std::max_element(axes.begin(), axes.end(), [&](const Named& a, const Named& b) {
            return glm::dot(sum_, a.direction) < glm::dot(sum_, b.direction);
        });
        if (glm::dot(sum_, best->direction) < least_cosine * glm::length(sum_) || glm::length(sum_) < 1e-9)
            return {UpAxis::y, Origin::assumed};
        return {best->axis, Origin::detected};
    }

  private:
    Vec3 sum_{0.0};
};

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
    MeanDirection rise;
    std::vector<Pose> world;
    motion::BonePositions positions;
    for (std::size_t f = 0; f < clip.frames.size(); f += strideOver(clip.frames.size())) {
        motion::worldPose(clip.skeleton, clip.frames[f], world);
        for (std::size_t b = 0; b < motion::bone_count; ++b)
            if (const int joint = map.joint[b]; joint >= 0)
                positions.at[b] = world[static_cast<std::size_t>(joint)].position;
        rise.add(riseOf(positions));
    }
    return rise.axis();
}

FoundUp findUp(const std::vector<motion::BonePositions>& frames, const std::optional<UpAxis>& given) {
    if (given) return {*given, Origin::given};
    MeanDirection rise;
    for (std::size_t f = 0; f < frames.size(); f += strideOver(frames.size())) rise.add(riseOf(frames[f]));
    return rise.axis();
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
