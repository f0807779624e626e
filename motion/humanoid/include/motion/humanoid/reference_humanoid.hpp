// The skeleton of Deixis's own avatar: 1.75 m tall, 55 joints with VRM names, T pose facing +z, no rest
// rotations. Segment lengths follow Drillis & Contini (1966) as fractions of body height, rounded to 5 mm;
// finger lengths are typical adult values.
#pragma once

#include "motion/skeleton/skeleton.hpp"

namespace deixis::motion {

constexpr double reference_height_m = 1.75;

/// Joints in Bone order, named by boneName(); fingertips, toes, jaw and eyes carry end sites.
[[nodiscard]] const Skeleton& referenceHumanoid();

/// An avatar at ease: arms down and a little out, elbows slightly bent, fingers relaxed. `skeleton` stands in
/// the T pose facing +z, without rest rotations, its bones with VRM names; bones that it lacks are left out.
[[nodiscard]] LocalPose relaxedPose(const Skeleton& skeleton);

}  // namespace deixis::motion
