#include <cstdio>
#include <glm/geometric.hpp>

#include "motion/humanoid/mapping.hpp"
#include "motion/humanoid/reference_humanoid.hpp"

namespace deixis::motion {

namespace {

using enum Bone;

/// Lengths of a figure, mean of both sides.
struct Sizes {
    double leg, arm, shoulders;
};
Sizes sizesOf(const HumanoidMap& map, const std::vector<Pose>& world) {
    const auto between = [&](Bone a, Bone b) {
        return glm::length(world[static_cast<std::size_t>(map[a])].position -
                           world[static_cast<std::size_t>(map[b])].position);
    };
    const auto limb = [&](Bone upper, Bone lower, Bone end) {
        return 0.5 * (between(upper, lower) + between(lower, end) +
                      between(mirroredBone(upper), mirroredBone(lower)) +
                      between(mirroredBone(lower), mirroredBone(end)));
    };
    return {limb(leftUpperLeg, leftLowerLeg, leftFoot), limb(leftUpperArm, leftLowerArm, leftHand),
            between(leftUpperArm, rightUpperArm)};
}

std::string metres(double length_m) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f m", length_m);
    return text;
}

}  // namespace

std::vector<std::string> mappingWarnings(const Skeleton& skeleton, const HumanoidMap& map,
                                         const std::vector<Pose>& world) {
    constexpr double doubtful = 0.5;  // of what is usual
    for (const Bone bone : requiredBones())
        if (!map.has(bone)) return {};
    static const Sizes person = [] {
        const Skeleton& reference = referenceHumanoid();
        return sizesOf(mapByVrmNames(reference), worldPose(reference, restPose(reference)));
    }();
    const Sizes figure = sizesOf(map, world);
    std::vector<std::string> warnings;
    const auto compare = [&](const std::string& what, double found, double of_person, Bone suspect) {
        const double usual = of_person / person.leg * figure.leg;
        if (found >= doubtful * usual) return;
        const auto question = [&](Bone bone) {
            return "'" + skeleton.joints[static_cast<std::size_t>(map[bone])].name + "' really " +
                   std::string(boneName(bone));
        };
        warnings.push_back(what + " " + metres(found) + ", less than half of what is usual with legs of " +
                           metres(figure.leg) + " (" + metres(usual) + "): is " + question(suspect) +
                           ", and " + question(mirroredBone(suspect)) +
                           "? NAME.humanoid.toml beside the file can say which joints are");
    };
    compare("the shoulders are apart by", figure.shoulders, person.shoulders, leftUpperArm);
    compare("the arms measure", figure.arm, person.arm, leftLowerArm);
    return warnings;
}

}  // namespace deixis::motion
