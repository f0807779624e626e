// The ray of a pointing gesture, on the source and on the avatar; private to retargeting.
#pragma once

#include <vector>

#include "assembly.hpp"

namespace deixis::motion {

/// Where the source's eye and fingertip are in a frame.
struct SightLine {
    Vec3 eye{0.0};
    Vec3 fingertip{0.0};
};

/// Finds the sight line of a source. Its eye, where it has no eyes, lies as to its head as the avatar's does;
/// its fingertip, where it has no index finger, is the end of its hand as it lies at rest, and where the hand
/// has no end, a hand's length on from the wrist along the forearm (0.108 of stature, Drillis & Contini
/// 1966).
class SightLineFinder {
  public:
    /// `scale`: the avatar's size over the source's.
    SightLineFinder(const Skeleton& source, const HumanoidMap& map, Side side, const AvatarRest& avatar,
                    double scale);
    /// `world`: the source's joints; `head`: rotation of the avatar's head in the same axes.
    [[nodiscard]] SightLine find(const std::vector<Pose>& world, const Quat& head) const;

  private:
    const HumanoidMap& map_;
    ArmBones arm_;
    Vec3 eye_from_head_{0.0};  // at the source's size
    int tip_joint_ = -1;
    Vec3 tip_{0.0};  // in its frame
    double hand_m_ = 0.0;
};

/// Turns the pointing arm about the shoulder, in each frame by the gesture's share, until the avatar's ray
/// misses the target by the angle and to the side by which the source's does; without a target, until it has
/// the source's direction. The elbow bends again only where the ray is farther from the shoulder than the
/// fingertip, and where the fingertip would come too near to the target or past it, unlike the source's.
/// `lines`: of the frames from the onset on to the end.
void keepPointingRay(const AvatarRest& avatar, const BodyPoser& poser, const BoneSet& driven,
                     const PointingGesture& gesture, const std::vector<SightLine>& lines,
                     std::vector<BodyFrame>& frames);

/// Median and largest error of rays from peak to hold.
[[nodiscard]] PointingError pointingError(const std::vector<SightLine>& peak_to_hold, const Vec3& target);

}  // namespace deixis::motion
