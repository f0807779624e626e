// Controllers, hands and eyes: one action set, its suggested bindings, and what they say in a frame.
#pragma once

#include <openxr/openxr.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pointing_hand.hpp"
#include "studies/station/station.hpp"
#include "xr_runtime.hpp"

namespace deixis::app {

/// Poses are in the tracking space; `TrackedPose::stage_from_device` then means tracking_from_device.
struct XrInputState {
    std::array<studies::TrackedPose, 2> aim{};   ///< by studies::Hand; -z points
    std::array<studies::TrackedPose, 2> grip{};  ///< by studies::Hand
    std::array<HandButton, 2> select{};          ///< by studies::Hand
    std::array<double, 2>
        farther{};               ///< by studies::Hand: -1 nearer to 1 farther, as far as the stick is pushed
    bool menu = false;           ///< went down in either hand
    bool recentre_held = false;  ///< in either hand, now
    std::optional<studies::TrackedPose> gaze;
    std::array<std::vector<studies::HandJoint>, 2> joints{};
};

struct XrInputOptions {
    bool gaze = false;  ///< ask for it where the runtime offers it
    bool joints = false;
};

class XrInput {
  public:
    /// Makes the actions and suggests bindings for KHR simple, Oculus Touch, Valve Index, HTC Vive, Microsoft
    /// motion controllers, and hand interaction where offered; attaches them to the session.
    XrInput(const XrRuntime& runtime, XrSession session, const XrInputOptions& options);
    ~XrInput();
    XrInput(const XrInput&) = delete;
    XrInput& operator=(const XrInput&) = delete;

    /// Syncs and reads everything at `display_time` relative to `tracking`. Without focus all is inactive.
    /// `station_seconds` turns a runtime's time into the station's.
    [[nodiscard]] XrInputState read(XrSpace tracking, XrTime display_time,
                                    const std::function<double(XrTime)>& station_seconds);
    /// A light tick in that hand.
    void tick(studies::Hand hand);
    /// The interaction profile of each hand, as it is now ("/interaction_profiles/valve/index_controller");
    /// empty: none.
    [[nodiscard]] std::array<std::string, 2> profiles() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Pose and flags of a located space.
[[nodiscard]] studies::TrackedPose trackedPose(const XrSpaceLocation& location);
[[nodiscard]] Pose poseFrom(const XrPosef& pose);
[[nodiscard]] XrPosef xrPose(const Pose& pose);

}  // namespace deixis::app
