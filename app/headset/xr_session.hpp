// An OpenXR session on the window's GL context: its life, its space, its frames and the layers that they end
// with.
#pragma once

#include <openxr/openxr.h>

#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/window/gl_window.hpp"
#include "renderer/scene/stereo.hpp"
#include "studies/station/station.hpp"
#include "xr_graphics_binding.hpp"
#include "xr_runtime.hpp"
#include "xr_session_lifecycle.hpp"
#include "xr_swapchain.hpp"

namespace deixis::app {

struct XrSessionOptions {
    double resolution_scale = 1.0;  ///< of the size that the runtime recommends
    double assumed_eye_height_m = 1.65;
};

/// What the runtime's events asked for since the last poll.
struct XrEvents {
    std::vector<studies::StationNote> notes;
    bool leave = false;                  ///< the runtime wants the program to end its session for good
    bool hidden_area = false;            ///< setHiddenArea() is due again
    std::optional<XrTime> recentred_at;  ///< the runtime moves its space at this time
    bool profiles = false;               ///< other controllers
    std::optional<XrFailure> lost;       ///< session or runtime are gone; the last thing to happen
};

/// A frame that has begun.
struct XrFrame {
    XrTime display_time = 0;
    bool should_render = false;
    double display_time_s = 0.0;  ///< station clock
    double begun_s = 0.0;
    int dropped = 0;  ///< display periods since the frame before that had no frame
};

/// Both eyes in the tracking space, and where the runtime wants its picture.
struct XrEyes {
    std::array<XrView, 2> views{};
    std::array<Pose, 2> tracking_from_eye{};
    std::array<renderer::EyeFov, 2> fov{};
};

/// A board as a layer of its own: pose of its centre in the tracking space.
struct XrBoardLayer {
    const XrGlSwapchain* picture = nullptr;
    int width = 0, height = 0;  ///< pixels from the lower left corner
    Pose tracking_from_centre{};
    double width_m = 0.0, height_m = 0.0;
    bool before_face = false;  ///< the pose is in the head's frame instead
};

/// What a frame ends with, from back to front: boards beneath, the eyes' picture with holes for them, boards
/// above.
struct XrLayers {
    std::optional<XrBoardLayer> beneath;
    std::optional<XrEyes> eyes;  ///< none: nothing is shown
    bool has_depth = false;
    double near_m = 0.05, far_m = 60.0;  ///< of the depth picture, metres of the room
    std::optional<XrBoardLayer> above;
};

class XrSessionLoop {
  public:
    /// Fails with what a person can do about it. Runtime and window must outlive it.
    [[nodiscard]] static Result<std::unique_ptr<XrSessionLoop>> open(const XrRuntime& runtime,
                                                                     const GlWindow& window,
                                                                     const XrSessionOptions& options);
    /// Ends a frame that is still open, without layers, and the session where it runs.
    ~XrSessionLoop();
    XrSessionLoop(const XrSessionLoop&) = delete;
    XrSessionLoop& operator=(const XrSessionLoop&) = delete;

    /// Handles the runtime's events; begins and ends the session as they ask.
    [[nodiscard]] XrEvents poll();
    [[nodiscard]] const XrSessionLifecycle& lifecycle() const { return lifecycle_; }

    /// Waits for the next frame and begins it; none where the session is not running.
    [[nodiscard]] std::optional<XrFrame> begin();
    /// Where the eyes are at the frame's display time; none where they are not known.
    [[nodiscard]] std::optional<XrEyes> locateEyes(const XrFrame& frame) const;
    /// Where the head is then.
    [[nodiscard]] studies::TrackedPose locateHead(const XrFrame& frame) const;
    /// Asks the runtime to let the session go through its last states; frames continue until it has.
    void requestExit();
    /// Ends it. Called exactly once for each begun frame.
    void end(const XrFrame& frame, const XrLayers& layers);

    /// By eye, left first, all of one size. Depth: none where the runtime takes none.
    [[nodiscard]] std::array<XrGlSwapchain, 2>& colour() { return colour_; }
    [[nodiscard]] std::array<XrGlSwapchain, 2>& depth() { return depth_; }
    [[nodiscard]] const XrSwapchainSize& eyeSize() const { return colour_[0].size(); }
    [[nodiscard]] bool hasDepth() const { return static_cast<bool>(depth_[0]); }
    [[nodiscard]] XrGlSwapchain boardPicture(int width, int height) const;
    [[nodiscard]] std::array<renderer::HiddenArea, 2> hiddenArea() const;

    [[nodiscard]] XrSession handle() const { return session_; }
    [[nodiscard]] XrSpace tracking() const { return tracking_; }
    [[nodiscard]] const std::string& spaceName() const {
        return space_name_;
    }  ///< "stage", "local floor", "local"
    [[nodiscard]] bool knowsFloor() const { return space_name_ != "local"; }
    [[nodiscard]] double period_s() const { return period_s_; }  ///< between frames; 0 before the first
    [[nodiscard]] double now_s() const;                          ///< station clock
    [[nodiscard]] double stationSeconds(XrTime time) const;

  private:
    explicit XrSessionLoop(const XrRuntime& runtime) : runtime_(runtime) {}
    void createSpaces(double assumed_eye_height_m);
    Result<void> createSwapchains(double resolution_scale);
    void chooseBlendMode();
    void fixClock();
    void enter(XrSessionState state, XrTime time, XrEvents& events);

    const XrRuntime& runtime_;
    std::unique_ptr<XrGraphicsBinding> binding_;
    XrSession session_ = XR_NULL_HANDLE;
    XrSpace tracking_ = XR_NULL_HANDLE;
    XrSpace view_ = XR_NULL_HANDLE;
    XrReferenceSpaceType space_type_ = XR_REFERENCE_SPACE_TYPE_LOCAL;
    std::string space_name_;
    XrEnvironmentBlendMode blend_mode_ = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
    std::array<XrGlSwapchain, 2> colour_, depth_;
    XrSessionLifecycle lifecycle_;
    bool frame_open_ = false;
    bool lost_ = false;
    XrTime open_frame_time_ = 0;
    XrTime last_display_time_ = 0;
    double period_s_ = 0.0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::optional<std::int64_t> station_zero_ns_;  ///< the station's time 0 as the runtime counts
};

}  // namespace deixis::app
