#include "xr_input.hpp"

namespace deixis::app {

namespace {

bool hasAll(XrSpaceLocationFlags flags, XrSpaceLocationFlags wanted) {
    return (flags & wanted) == wanted;
}

}  // namespace

Pose poseFrom(const XrPosef& pose) {
    const XrQuaternionf& q = pose.orientation;
    const XrVector3f& p = pose.position;
    return {Vec3(p.x, p.y, p.z), glm::normalize(Quat(q.w, q.x, q.y, q.z))};
}

XrPosef xrPose(const Pose& pose) {
    const Quat& q = pose.orientation;
    const Vec3& p = pose.position;
    return {
        {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)},
        {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}};
}

studies::TrackedPose trackedPose(const XrSpaceLocation& location) {
    const XrSpaceLocationFlags flags = location.locationFlags;
    studies::TrackedPose tracked;
    tracked.position_valid = hasAll(flags, XR_SPACE_LOCATION_POSITION_VALID_BIT);
    tracked.orientation_valid = hasAll(flags, XR_SPACE_LOCATION_ORIENTATION_VALID_BIT);
    tracked.tracked =
        hasAll(flags, XR_SPACE_LOCATION_POSITION_TRACKED_BIT | XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT);
    // What is not valid is undefined: it is not looked at.
    const Pose located = poseFrom(location.pose);
    if (tracked.position_valid) tracked.stage_from_device.position = located.position;
    if (tracked.orientation_valid) tracked.stage_from_device.orientation = located.orientation;
    return tracked;
}

}  // namespace deixis::app
