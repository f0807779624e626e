#include "located.hpp"

#include <cmath>
#include <limits>

namespace deixis::conditions {

namespace {

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

XrQuaternionf times(const XrQuaternionf& a, const XrQuaternionf& b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

XrQuaternionf conjugate(const XrQuaternionf& q) {
    return {-q.x, -q.y, -q.z, q.w};
}

XrVector3f rotate(const XrQuaternionf& q, const XrVector3f& v) {
    const XrQuaternionf turned = times(times(q, {v.x, v.y, v.z, 0.0F}), conjugate(q));
    return {turned.x, turned.y, turned.z};
}

XrPosef inverse(const XrPosef& pose) {
    const XrQuaternionf back = conjugate(pose.orientation);
    return {back, rotate(back, {-pose.position.x, -pose.position.y, -pose.position.z})};
}

}  // namespace

XrQuaternionf turned(float yaw_deg, float pitch_deg) {
    constexpr float half_rad = 3.14159265F / 360.0F;
    return times({0.0F, std::sin(yaw_deg * half_rad), 0.0F, std::cos(yaw_deg * half_rad)},
                 {std::sin(pitch_deg * half_rad), 0.0F, 0.0F, std::cos(pitch_deg * half_rad)});
}

XrPosef multiply(const XrPosef& a, const XrPosef& b) {
    const XrVector3f moved = rotate(a.orientation, b.position);
    return {times(a.orientation, b.orientation),
            {a.position.x + moved.x, a.position.y + moved.y, a.position.z + moved.z}};
}

XrPosef Recentrings::apply(const XrPosef& pose, XrTime time) const {
    XrPosef now = pose;
    for (const One& one : all_)
        if (time >= one.from) now = multiply(inverse(one.old_from_new), now);
    return now;
}

void limit(Tracking tracking, XrSpaceLocationFlags& flags, XrPosef& pose) {
    constexpr XrSpaceLocationFlags turned_bits =
        XR_SPACE_LOCATION_ORIENTATION_VALID_BIT | XR_SPACE_LOCATION_ORIENTATION_TRACKED_BIT;
    switch (tracking) {
        case Tracking::tracked:
            return;
        case Tracking::guessed:
            flags &= turned_bits | XR_SPACE_LOCATION_POSITION_VALID_BIT;
            return;
        case Tracking::turning:
            flags &= turned_bits;
            pose.position = {nothing, nothing, nothing};
            return;
        case Tracking::lost:
            flags = 0;
            pose = {{nothing, nothing, nothing, nothing}, {nothing, nothing, nothing}};
            return;
    }
}

}  // namespace deixis::conditions
