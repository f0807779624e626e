#include <cmath>
#include <glm/geometric.hpp>

#include "motion/retarget.hpp"
#include "retarget_assembly.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

std::size_t index(Bone bone) {
    return static_cast<std::size_t>(bone);
}

BodyShape shapeOf(const BonePositions& positions, const Quat& turn) {
    BodyShape shape;
    for (std::size_t b = 0; b < bone_count; ++b)
        if (positions.at[b]) shape.start[b] = turn * *positions.at[b];
    return shape;
}

/// Hips and chest each face their own way and share the line from hips to neck.
TrunkAxes trunkAxes(const BodyShape& shape) {
    const Vec3 rise = *shape.at(neck) - *shape.at(hips);
    return {*shape.at(leftUpperLeg) - *shape.at(rightUpperLeg), rise,
            *shape.at(leftUpperArm) - *shape.at(rightUpperArm), rise};
}

bool hasLength(const Vec3& v) {
    constexpr double shortest_m = 0.01;
    return glm::length(v) > shortest_m;
}

/// What is wrong with a frame; empty where it can be solved.
std::string fault(const BonePositions& positions) {
    BoneSet known{};
    for (std::size_t b = 0; b < bone_count; ++b) known[b] = positions.at[b].has_value();
    auto missing = missingBones(known);
    if (!positions[neck]) missing += missing.empty() ? "neck" : ", neck";
    if (!missing.empty()) return "has no position for " + missing;
    const BodyShape shape = shapeOf(positions, no_rotation);
    const TrunkAxes axes = trunkAxes(shape);
    if (!hasLength(axes.hip_line) || !hasLength(axes.shoulder_line) || !hasLength(axes.hips_up) ||
        !hasLength(*shape.at(head) - *shape.at(neck)) || legLength(shape) < 0.1)
        return "has joints of the trunk or the legs in one place";
    return {};
}

BoneTurns solve(const AvatarRest& avatar, const TrunkAxes& avatar_axes, const BodyShape& shape) {
    constexpr double prior = 0.15;
    const TrunkAxes axes = trunkAxes(shape);
    BoneTwists twist{};
    BoneTurns turns = alignBody(avatar.shape, avatar_axes, shape, axes, twist);
    for (const bool lower : {false, true}) {
        HingeFit fit(avatar.shape, prior);
        fit.add(turns, shape);
        for (const Hinge& hinge : hinges()) {
            const Bone bone = lower ? hinge.lower : hinge.upper;
            twist[index(bone)] = fit.twist(bone);
        }
        turns = alignBody(avatar.shape, avatar_axes, shape, axes, twist);
    }
    const Vec3 forward = turns[index(hips)] * Vec3(0, 0, 1);
    const Quat flat = yawRotation(std::atan2(forward.x, forward.z));
    for (const Bone bone : {leftFoot, rightFoot, leftToes, rightToes}) turns[index(bone)] = flat;
    return turns;
}

/// Head and neck lean from the chest as the line from neck to head leans from its mean.
void turnHeads(const std::vector<BodyShape>& shapes, std::vector<BodyFrame>& frames) {
    const auto local = [&](std::size_t f) {
        return glm::conjugate(frames[f].rotation[index(upperChest)]) *
               glm::normalize(*shapes[f].at(head) - *shapes[f].at(neck));
    };
    Vec3 mean(0.0);
    for (std::size_t f = 0; f < frames.size(); ++f) mean += local(f);
    if (!hasLength(mean)) return;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        BoneTurns& turns = frames[f].rotation;
        turns[index(head)] = turns[index(upperChest)] * rotationBetween(mean, local(f));
        turns[index(neck)] = glm::slerp(turns[index(upperChest)], turns[index(head)], 0.5);
    }
}

}  // namespace

Result<Clip> clipFromPositions(const std::vector<BonePositions>& positions, double frame_time_s,
                               const Skeleton& avatar_skeleton, const HumanoidMap& avatar_map,
                               RetargetReport* report) {
    if (positions.empty()) return fail("", "found no frames, expected at least one");
    for (std::size_t f = 0; f < positions.size(); ++f)
        if (const auto problem = fault(positions[f]); !problem.empty())
            return fail(
                "", "frame " + std::to_string(f) + " " + problem + ", expected the joints of a whole person");
    const AvatarRest avatar = avatarRest(avatar_skeleton, avatar_map);

    Vec3 rise(0.0);
    for (const BonePositions& p : positions)
        rise += 0.5 * (*p[leftUpperArm] + *p[rightUpperArm]) - 0.5 * (*p[leftFoot] + *p[rightFoot]);
    const Quat level = rotationBetween(rise, up);

    std::vector<BodyShape> shapes;
    double leg_length_m = 0.0;
    for (const BonePositions& p : positions) {
        shapes.push_back(shapeOf(p, level));
        leg_length_m += legLength(shapes.back()) / static_cast<double>(positions.size());
    }
    const double scale = avatar.leg_length_m / leg_length_m;

    const TrunkAxes avatar_axes{Vec3(1, 0, 0), up, Vec3(1, 0, 0), up};
    std::vector<BodyFrame> frames;
    frames.reserve(shapes.size());
    for (const BodyShape& shape : shapes)
        frames.push_back({solve(avatar, avatar_axes, shape),
                          0.5 * scale * (*shape.at(leftUpperLeg) + *shape.at(rightUpperLeg))});
    turnHeads(shapes, frames);

    BoneSet driven{};
    for (const Bone bone :
         {hips, spine, chest, upperChest, neck, head, leftShoulder, rightShoulder, leftToes, rightToes})
        driven[index(bone)] = true;
    for (const Hinge& hinge : hinges())
        driven[index(hinge.upper)] = driven[index(hinge.lower)] = driven[index(hinge.end)] = true;
    if (report) report->scale = scale;
    return assemble(avatar, std::move(frames), driven, Ground::frame, frame_time_s);
}

}  // namespace deixis::motion
