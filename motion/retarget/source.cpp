#include "source.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "motion/humanoid/rise_axis.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

constexpr std::size_t max_looks = 200;

/// A bone of a finger that points at nothing: no one asks for its place.
bool isOtherFinger(std::size_t b) {
    const auto bone = static_cast<Bone>(b);
    const bool index = (bone >= leftIndexProximal && bone <= leftIndexDistal) ||
                       (bone >= rightIndexProximal && bone <= rightIndexDistal);
    return bone >= leftThumbMetacarpal && !index;
}

double alongUp(const BodyShape& shape, Bone bone, const Vec3& rise) {
    const auto direction = shape.direction(bone);
    return direction ? glm::dot(*direction, rise) : 1.0;
}

constexpr double shortest_m = 1e-6;

/// How long a line is, seen along another that has a length.
double widthAcross(const Vec3& line, const Vec3& along) {
    return glm::length(glm::cross(line, along)) / glm::length(along);
}

/// Mean turn of the limbs from one pose to the next, radians.
double meanTurn(const BodyShape& from, const BodyShape& to) {
    double sum = 0.0;
    int count = 0;
    for (const Hinge& hinge : hinges())
        for (const Bone bone : {hinge.upper, hinge.lower}) {
            const auto a = from.direction(bone);
            const auto b = to.direction(bone);
            if (!a || !b) continue;
            sum += angleBetween(*a, *b);
            ++count;
        }
    return count > 0 ? sum / count : 0.0;
}

}  // namespace

double standing(const BodyShape& shape) {
    constexpr double no_figure = -6.0;
    const TrunkAxes axes = standingAxes(shape);
    const Vec3 hip_centre = 0.5 * (*shape.at(leftUpperLeg) + *shape.at(rightUpperLeg));
    const Vec3 trunk = *shape.at(head) - hip_centre;
    // Both lines must lie across the trunk, or nothing tells which way it faces.
    if (glm::length(axes.hips_up) < shortest_m || glm::length(trunk) < shortest_m ||
        widthAcross(axes.hip_line, axes.hips_up) < shortest_m ||
        widthAcross(axes.shoulder_line, axes.chest_up) < shortest_m)
        return no_figure;
    const Vec3 rise = glm::normalize(axes.hips_up);
    double score = glm::dot(glm::normalize(trunk), rise);
    for (const Bone bone : {leftUpperLeg, rightUpperLeg, leftLowerLeg, rightLowerLeg})
        score -= alongUp(shape, bone, rise);
    return score + 1.0 - std::abs(glm::dot(glm::normalize(axes.hip_line), rise));
}

Source::Source(const Clip& clip, const HumanoidMap& map) : clip_(clip), map_(map) {
    std::vector<bool> needed(clip.skeleton.joints.size(), false);
    std::vector<bool> placed(clip.skeleton.joints.size(), false);
    for (std::size_t b = 0; b < bone_count; ++b)
        for (int j = map.joint[b]; j >= 0; j = clip.skeleton.joints[static_cast<std::size_t>(j)].parent) {
            needed[static_cast<std::size_t>(j)] = true;
            if (!isOtherFinger(b)) placed[static_cast<std::size_t>(j)] = true;
        }
    for (std::size_t j = 0; j < needed.size(); ++j)
        if (needed[j]) needed_.push_back({j, clip.skeleton.joints[j].parent, placed[j]});

    const std::size_t count = std::min(clip.frames.size(), max_looks);
    looks_.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t frame = count < 2 ? 0 : i * (clip.frames.size() - 1) / (count - 1);
        auto world = worldPose(clip.skeleton, clip.frames[frame]);
        const BodyShape shape = shapeOf(clip.skeleton, map, world);
        looks_.push_back({frame, std::move(world), shape});
    }
}

Neutral Source::neutral() const {
    constexpr double well_enough = 4.5;
    auto world = worldPose(clip_.skeleton, restPose(clip_.skeleton));
    const BodyShape rest = shapeOf(clip_.skeleton, map_, world);
    if (standing(rest) > well_enough) return {std::move(world), rest, true};
    const auto best = std::max_element(looks_.begin(), looks_.end(), [](const Look& a, const Look& b) {
        return standing(a.shape) < standing(b.shape);
    });
    return {best->world, best->shape, false};
}

Vec3 Source::upAxis(const Neutral& neutral) const {
    std::vector<Vec3> rises;
    for (const Look& look : looks_) rises.push_back(standingAxes(look.shape).hips_up);
    constexpr double clearly = 0.7;
    if (neutral.is_rest && glm::normalize(standingAxes(neutral.shape).hips_up).y > clearly) return up;
    return riseAxis(rises).value_or(up);
}

bool Source::startsWithAddedPose() const {
    if (clip_.frames.size() < 3) return false;
    constexpr double jump_rad = 0.17;
    BodyShape shapes[3];
    for (std::size_t f = 0; f < 3; ++f)
        shapes[f] = shapeOf(clip_.skeleton, map_, worldPose(clip_.skeleton, clip_.frames[f]));
    const double first = meanTurn(shapes[0], shapes[1]);
    return first > jump_rad && first > 5.0 * meanTurn(shapes[1], shapes[2]);
}

void Source::place(std::size_t frame, const Quat& turn, std::vector<Pose>& world) const {
    const auto& local = clip_.frames[frame].joints;
    world.resize(local.size());
    for (const Needed& joint : needed_) {
        const Pose& here = local[joint.index];
        Pose& out = world[joint.index];
        if (joint.parent < 0) {
            out = {turn * here.position, turn * here.orientation};
            continue;
        }
        const Pose& above = world[static_cast<std::size_t>(joint.parent)];
        if (joint.placed) out.position = above.position + above.orientation * here.position;
        out.orientation = above.orientation * here.orientation;
    }
}

}  // namespace deixis::motion
