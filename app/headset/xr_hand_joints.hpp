// The joints of both hands, through XR_EXT_hand_tracking.
#pragma once

#include <openxr/openxr.h>

#include <array>
#include <vector>

#include "studies/station/station.hpp"
#include "xr_runtime.hpp"

namespace deixis::app {

class XrHandJoints {
  public:
    /// The runtime tracks hands (XrRuntime::tracksHands).
    XrHandJoints(const XrRuntime& runtime, XrSession session);
    ~XrHandJoints();
    XrHandJoints(const XrHandJoints&) = delete;
    XrHandJoints& operator=(const XrHandJoints&) = delete;

    /// By studies::Hand, relative to `tracking`; empty for a hand that is not seen.
    [[nodiscard]] std::array<std::vector<studies::HandJoint>, 2> read(XrSpace tracking, XrTime time) const;

  private:
    PFN_xrDestroyHandTrackerEXT destroy_ = nullptr;
    PFN_xrLocateHandJointsEXT locate_ = nullptr;
    std::array<XrHandTrackerEXT, 2> trackers_{XR_NULL_HANDLE, XR_NULL_HANDLE};
};

}  // namespace deixis::app
