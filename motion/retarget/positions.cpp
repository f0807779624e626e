#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "assembly.hpp"
#include "motion/retarget/retarget.hpp"
#include "motion/skeleton/bone_index.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

BodyShape shapeOf(const BonePositions& positions, const Quat& turn) {
    BodyShape shape;
    for (std::size_t b = 0; b < bone_count; ++b)
        if (positions.at[b]) shape.start[b] = turn * *positions.at[b];
    return shape;
}

constexpr Bone leg_bones[] = {leftUpperLeg,  leftLowerLeg,  leftFoot,  leftToes,
                              rightUpperLeg, rightLowerLeg, rightFoot, rightToes};

/// What the positions are of.
enum class Part : unsigned char { whole, upper_body };

Part partOf(const std::vector<BonePositions>& positions) {
    const auto hasLegs = [](const BonePositions& p) {
        return std::any_of(std::begin(leg_bones), std::end(leg_bones),
                           [&](Bone bone) { return p[bone].has_value(); });
    };
    return std::any_of(positions.begin(), positions.end(), hasLegs) ? Part::whole : Part::upper_body;
}

const TrunkAxes upright{Vec3(1, 0, 0), up, Vec3(1, 0, 0), up};

/// Hips and chest each face their own way and share the line from hips to neck; without legs the hips stand.
TrunkAxes trunkAxes(const BodyShape& shape, Part part) {
    const Vec3 shoulder_line = *shape.at(leftUpperArm) - *shape.at(rightUpperArm);
    if (part == Part::upper_body) {
        const Vec3 base = shape.at(spine) ? *shape.at(spine) : *shape.at(hips);
        return {upright.hip_line, up, shoulder_line, *shape.at(neck) - base};
    }
    const Vec3 rise = *shape.at(neck) - *shape.at(hips);
    return {*shape.at(leftUpperLeg) - *shape.at(rightUpperLeg), rise, shoulder_line, rise};
}

bool hasLength(const Vec3& v) {
    constexpr double shortest_m = 0.01;
    return glm::length(v) > shortest_m;
}

bool spanPlane(const Vec3& a, const Vec3& b) {
    constexpr double smallest_sine = 1e-3;
    return glm::length(glm::cross(a, b)) > smallest_sine * glm::length(a) * glm::length(b);
}

/// What is wrong with a frame; empty where it can be solved.
std::string fault(const BonePositions& positions, Part part) {
    HumanoidMap known;
    for (std::size_t b = 0; b < bone_count; ++b) known.joint[b] = positions.at[b] ? 0 : -1;
    if (part == Part::upper_body && known.has(spine)) known[hips] = 0;
    auto missing = missingBones(known, part == Part::upper_body ? pointingBones() : requiredBones());
    if (!positions[neck]) missing.emplace_back("neck");
    if (!missing.empty()) return fmt::format("has no position for {}", fmt::join(missing, ", "));
    const BodyShape shape = shapeOf(positions, no_rotation);
    const TrunkAxes axes = trunkAxes(shape, part);
    const bool thin = !hasLength(axes.hip_line) || !hasLength(axes.shoulder_line) ||
                      !spanPlane(axes.hip_line, axes.hips_up) ||
                      !spanPlane(axes.shoulder_line, axes.chest_up) ||
                      !hasLength(*shape.at(head) - *shape.at(neck));
    if (part == Part::upper_body) return thin ? "has joints of the trunk in one place" : "";
    if (thin || legLength(shape) < 0.1) return "has joints of the trunk or the legs in one place";
    return {};
}

BoneTurns solve(const AvatarRest& avatar, const BodyShape& shape, Part part) {
    constexpr double prior = 0.15;
    const TrunkAxes axes = trunkAxes(shape, part);
    BoneTwists twist{};
    BoneTurns turns = alignBody(avatar.shape, upright, shape, axes, twist);
    for (const bool lower : {false, true}) {
        HingeFit fit(avatar.shape, prior);
        fit.add(turns, shape);
        for (const Hinge& hinge : hinges()) {
            const Bone bone = lower ? hinge.lower : hinge.upper;
            twist[indexOf(bone)] = fit.twist(bone);
        }
        turns = alignBody(avatar.shape, upright, shape, axes, twist);
    }
    const Vec3 forward = turns[indexOf(hips)] * Vec3(0, 0, 1);
    const Quat flat = yawRotation(std::atan2(forward.x, forward.z));
    for (const Bone bone : {leftFoot, rightFoot, leftToes, rightToes}) turns[indexOf(bone)] = flat;
    return turns;
}

/// Head and neck lean from the chest as the line from neck to head leans from its mean.
void turnHeads(const std::vector<BodyShape>& shapes, std::vector<BodyFrame>& frames) {
    const auto local = [&](std::size_t f) {
        return glm::conjugate(frames[f].rotation[indexOf(upperChest)]) *
               glm::normalize(*shapes[f].at(head) - *shapes[f].at(neck));
    };
    Vec3 mean(0.0);
    for (std::size_t f = 0; f < frames.size(); ++f) mean += local(f);
    if (!hasLength(mean)) return;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        BoneTurns& turns = frames[f].rotation;
        turns[indexOf(head)] = turns[indexOf(upperChest)] * rotationBetween(mean, local(f));
        turns[indexOf(neck)] = glm::slerp(turns[indexOf(upperChest)], turns[indexOf(head)], 0.5);
    }
}

/// The mean line from between the feet to between the shoulders, which is to stand upright.
Vec3 meanRise(const std::vector<BonePositions>& positions) {
    Vec3 rise(0.0);
    for (const BonePositions& p : positions)
        rise += 0.5 * (*p[leftUpperArm] + *p[rightUpperArm]) - 0.5 * (*p[leftFoot] + *p[rightFoot]);
    return rise / static_cast<double>(positions.size());
}

/// About the vertical, so that the shoulders face +z on the mean.
Quat facingOf(const std::vector<BonePositions>& positions) {
    Vec3 line(0.0);
    for (const BonePositions& p : positions) line += *p[leftUpperArm] - *p[rightUpperArm];
    return yawRotation(-std::atan2(-line.z, line.x));
}

double armLength(const BodyShape& shape) {
    double length = 0.0;
    for (const Hinge& hinge : hinges())
        if (hinge.end == leftHand || hinge.end == rightHand)
            length += 0.5 * (glm::length(*shape.at(hinge.lower) - *shape.at(hinge.upper)) +
                             glm::length(*shape.at(hinge.end) - *shape.at(hinge.lower)));
    return length;
}

}  // namespace

Result<Clip> clipFromPositions(const std::vector<BonePositions>& positions, double frame_time_s,
                               const Skeleton& avatar_skeleton, const HumanoidMap& avatar_map,
                               RetargetReport* report) {
    if (positions.empty()) return fail("", "found no frames, expected at least one");
    const Part part = partOf(positions);
    const std::string expected =
        part == Part::whole ? "the joints of a whole body" : "those of a whole body or an upper body";
    for (std::size_t f = 0; f < positions.size(); ++f)
        if (const auto problem = fault(positions[f], part); !problem.empty())
            return fail("", "frame " + std::to_string(f) + " " + problem + ", expected " + expected);
    const AvatarRest avatar = avatarRest(avatar_skeleton, avatar_map);
    const auto size = [&](const BodyShape& shape) {
        return part == Part::whole ? legLength(shape) : armLength(shape);
    };

    Quat turn = no_rotation;
    if (part == Part::upper_body) {
        turn = facingOf(positions);
    } else {
        const Vec3 rise = meanRise(positions);
        if (!hasLength(rise)) return fail("", "has shoulders and feet in one place, expected " + expected);
        turn = rotationBetween(rise, up);
    }
    std::vector<BodyShape> shapes;
    double mean_size = 0.0;
    for (const BonePositions& p : positions) {
        shapes.push_back(shapeOf(p, turn));
        mean_size += size(shapes.back()) / static_cast<double>(positions.size());
    }
    if (!(mean_size > 0.0)) return fail("", "has arms without length, expected those of a person");
    const double scale = size(avatar.shape) / mean_size;

    const auto hipCentre = [](const BodyShape& shape) {
        return 0.5 * (*shape.at(leftUpperLeg) + *shape.at(rightUpperLeg));
    };
    std::vector<BodyFrame> frames;
    frames.reserve(shapes.size());
    for (const BodyShape& shape : shapes)
        frames.push_back({solve(avatar, shape, part),
                          part == Part::whole ? scale * hipCentre(shape) : hipCentre(avatar.shape)});
    turnHeads(shapes, frames);

    BoneSet driven{};
    for (const Bone bone :
         {hips, spine, chest, upperChest, neck, head, leftShoulder, rightShoulder, leftToes, rightToes})
        driven[indexOf(bone)] = true;
    for (const Hinge& hinge : hinges())
        driven[indexOf(hinge.upper)] = driven[indexOf(hinge.lower)] = driven[indexOf(hinge.end)] = true;
    for (std::size_t b = indexOf(leftThumbMetacarpal); b < bone_count; ++b)
        driven[b] = std::all_of(positions.begin(), positions.end(),
                                [&](const BonePositions& p) { return p.at[b].has_value(); });
    if (report) report->scale = scale;
    return assemble(avatar, std::move(frames), driven, Ground::frame, frame_time_s);
}

}  // namespace deixis::motion
