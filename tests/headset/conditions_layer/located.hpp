// Poses as the runtime gave them, changed as the conditions want them.
#pragma once

#include <openxr/openxr.h>

#include <vector>

#include "commands.hpp"

namespace deixis::conditions {

/// A rotation to the left about +y, after one up about +x.
[[nodiscard]] XrQuaternionf turned(float yaw_deg, float pitch_deg);
[[nodiscard]] XrPosef multiply(const XrPosef& a, const XrPosef& b);

/// The recentrings so far, each with the time from which it holds.
class Recentrings {
  public:
    void add(const XrPosef& old_from_new, XrTime from) { all_.push_back({old_from_new, from}); }
    /// The pose in the space as it is at that time, from the runtime's, which was never recentred.
    [[nodiscard]] XrPosef apply(const XrPosef& pose, XrTime time) const;

  private:
    struct One {
        XrPosef old_from_new;
        XrTime from;
    };
    std::vector<One> all_;
};

/// Takes from a location what is not tracked. What is not valid becomes NaN, so that whoever uses it is found
/// out.
void limit(Tracking tracking, XrSpaceLocationFlags& flags, XrPosef& pose);

}  // namespace deixis::conditions
