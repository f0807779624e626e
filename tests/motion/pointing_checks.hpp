// What the tests of pointing clips measure.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <vector>

#include "core/random.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/pointing/rays.hpp"
#include "motion/synthesis/generator.hpp"

namespace deixis::tests {

inline double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// On the half-cylinder before the avatar: azimuth +-85 degrees, radius 1.9 to 2.2 m, height 0.1 to 2.1 m.
inline Vec3 drawTarget(Random& random) {
    const double azimuth = radiansFromDegrees(random.uniform(-85.0, 85.0));
    const double radius = random.uniform(1.9, 2.2);
    const double height = random.uniform(0.1, 2.1);
    return {radius * std::sin(azimuth), height, radius * std::cos(azimuth)};
}

inline std::vector<Vec3> drawTargets(int count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Vec3> out;
    for (int i = 0; i < count; ++i) out.push_back(drawTarget(random));
    return out;
}

inline const motion::HumanoidMap& referenceMap() {
    static const motion::HumanoidMap map = motion::mapByVrmNames(motion::referenceHumanoid());
    return map;
}

inline std::vector<Pose> worldAt(const motion::Clip& clip, int frame) {
    return motion::worldPose(clip.skeleton, clip.frames[static_cast<std::size_t>(frame)]);
}

inline Vec3 joint(const std::vector<Pose>& world, motion::Bone bone) {
    return world[static_cast<std::size_t>(referenceMap()[bone])].position;
}

inline Vec3 fingertipAt(const motion::GeneratedClip& made, int frame) {
    return motion::fingertipPosition(made.clip.skeleton, referenceMap(), worldAt(made.clip, frame),
                                     made.hand);
}

/// Ray from the eye through the fingertip in the middle of the hold.
inline Ray eyeRay(const motion::GeneratedClip& made,
                  motion::PointingRay kind = motion::PointingRay::eye_fingertip) {
    const auto world = worldAt(made.clip, (made.peak_frame + made.hold_frame) / 2);
    return motion::pointingRay(made.clip.skeleton, referenceMap(), world, made.hand, kind);
}

inline double errorDeg(const motion::GeneratedClip& made, const Vec3& target,
                       motion::PointingRay kind = motion::PointingRay::eye_fingertip) {
    return degreesFromRadians(motion::angularError(eyeRay(made, kind), target));
}

/// The largest angle by which a joint differs between two poses, radians.
inline double maxTurn(const motion::LocalPose& a, const motion::LocalPose& b) {
    double max = 0.0;
    for (std::size_t j = 0; j < a.joints.size(); ++j) {
        const double cosine = std::abs(glm::dot(a.joints[j].orientation, b.joints[j].orientation));
        max = std::max(max, 2.0 * std::acos(std::min(1.0, cosine)));
    }
    return max;
}

}  // namespace deixis::tests
