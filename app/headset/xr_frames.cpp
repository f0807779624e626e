// The frames of an OpenXR session: wait, begin, locate, end; and the clock that they share with the station.
#ifndef _WIN32
#define XR_USE_TIMESPEC
#include <time.h>
#endif
#include <epoxy/gl.h>

#include <openxr/openxr.h>
#include <openxr/openxr_platform.h>

#include <cmath>

#include "xr_input.hpp"
#include "xr_session.hpp"

namespace deixis::app {

namespace {

constexpr double ns_per_s = 1e9;

XrSwapchainSubImage wholeImage(const XrGlSwapchain& chain) {
    XrSwapchainSubImage image{};
    image.swapchain = chain.handle();
    image.imageRect.extent = {chain.size().width, chain.size().height};
    return image;
}

XrCompositionLayerQuad quadLayer(const XrBoardLayer& board, XrSpace space) {
    auto quad = typed<XrCompositionLayerQuad>(XR_TYPE_COMPOSITION_LAYER_QUAD);
    quad.layerFlags = XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT;
    quad.space = space;
    quad.eyeVisibility = XR_EYE_VISIBILITY_BOTH;
    quad.subImage.swapchain = board.picture->handle();
    quad.subImage.imageRect.extent = {board.width, board.height};
    quad.pose = xrPose(board.tracking_from_centre);
    quad.size = {static_cast<float>(board.width_m), static_cast<float>(board.height_m)};
    return quad;
}

}  // namespace

double XrSessionLoop::now_s() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

double XrSessionLoop::stationSeconds(XrTime time) const {
    return static_cast<double>(time - station_zero_ns_.value_or(0)) / ns_per_s;
}

// Finds the station's time 0 on the runtime's clock. Both count seconds of the same length; where the runtime
// does not tell how its clock stands to the monotonic one, the first frame does (see begin()).
void XrSessionLoop::fixClock() {
    station_zero_ns_.reset();
#ifndef _WIN32
    if (!runtime_.has("XR_KHR_convert_timespec_time")) return;
    const auto convert =
        runtime_.function<PFN_xrConvertTimespecTimeToTimeKHR>("xrConvertTimespecTimeToTimeKHR");
    if (convert == nullptr) return;
    timespec monotonic{};
    clock_gettime(CLOCK_MONOTONIC, &monotonic);
    const double station_s = now_s();
    XrTime time = 0;
    if (XR_FAILED(convert(runtime_.instance(), &monotonic, &time))) return;
    station_zero_ns_ = time - std::llround(station_s * ns_per_s);
#endif
}

std::optional<XrFrame> XrSessionLoop::begin() {
    if (!lifecycle_.running()) return std::nullopt;
    const auto wait = typed<XrFrameWaitInfo>(XR_TYPE_FRAME_WAIT_INFO);
    auto state = typed<XrFrameState>(XR_TYPE_FRAME_STATE);
    const XrResult waited = xrWaitFrame(session_, &wait, &state);
    if (XR_FAILED(waited)) lost_ = true;
    check(waited, "xrWaitFrame");
    XrFrame frame;
    frame.begun_s = now_s();
    const auto begin = typed<XrFrameBeginInfo>(XR_TYPE_FRAME_BEGIN_INFO);
    const XrResult begun = xrBeginFrame(session_, &begin);
    if (XR_FAILED(begun)) lost_ = true;
    check(begun, "xrBeginFrame");
    frame_open_ = true;
    open_frame_time_ = state.predictedDisplayTime;
    if (!station_zero_ns_)
        station_zero_ns_ = state.predictedDisplayTime - state.predictedDisplayPeriod -
                           std::llround(frame.begun_s * ns_per_s);
    frame.display_time = state.predictedDisplayTime;
    frame.display_time_s = stationSeconds(state.predictedDisplayTime);
    frame.should_render = state.shouldRender == XR_TRUE;
    if (state.predictedDisplayPeriod > 0) {
        period_s_ = static_cast<double>(state.predictedDisplayPeriod) / ns_per_s;
        const auto passed = static_cast<double>(state.predictedDisplayTime - last_display_time_);
        if (last_display_time_ != 0)
            frame.dropped = std::max(
                0, static_cast<int>(std::lround(passed / static_cast<double>(state.predictedDisplayPeriod))) -
                       1);
    }
    last_display_time_ = state.predictedDisplayTime;
    return frame;
}

std::optional<XrEyes> XrSessionLoop::locateEyes(const XrFrame& frame) const {
    auto info = typed<XrViewLocateInfo>(XR_TYPE_VIEW_LOCATE_INFO);
    info.viewConfigurationType = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;
    info.displayTime = frame.display_time;
    info.space = tracking_;
    auto state = typed<XrViewState>(XR_TYPE_VIEW_STATE);
    XrEyes eyes;
    for (auto& view : eyes.views) view = typed<XrView>(XR_TYPE_VIEW);
    std::uint32_t count = 0;
    check(xrLocateViews(session_, &info, &state, 2, &count, eyes.views.data()), "xrLocateViews");
    constexpr XrViewStateFlags needed =
        XR_VIEW_STATE_POSITION_VALID_BIT | XR_VIEW_STATE_ORIENTATION_VALID_BIT;
    if ((state.viewStateFlags & needed) != needed) return std::nullopt;
    for (std::size_t i = 0; i < 2; ++i) {
        eyes.tracking_from_eye[i] = poseFrom(eyes.views[i].pose);
        const XrFovf& fov = eyes.views[i].fov;
        eyes.fov[i] = {fov.angleLeft, fov.angleRight, fov.angleUp, fov.angleDown};
    }
    return eyes;
}

studies::TrackedPose XrSessionLoop::locateHead(const XrFrame& frame) const {
    auto location = typed<XrSpaceLocation>(XR_TYPE_SPACE_LOCATION);
    check(xrLocateSpace(view_, tracking_, frame.display_time, &location), "xrLocateSpace");
    return trackedPose(location);
}

void XrSessionLoop::end(const XrFrame& frame, const XrLayers& layers) {
    std::vector<const XrCompositionLayerBaseHeader*> list;
    const auto add = [&](const auto& layer) {
        list.push_back(reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer));
    };
    XrCompositionLayerQuad beneath{};
    XrCompositionLayerQuad above{};
    auto picture = typed<XrCompositionLayerProjection>(XR_TYPE_COMPOSITION_LAYER_PROJECTION);
    std::array<XrCompositionLayerProjectionView, 2> views{};
    std::array<XrCompositionLayerDepthInfoKHR, 2> depths{};
    if (layers.beneath) {
        beneath = quadLayer(*layers.beneath, tracking_);
        add(beneath);
    }
    if (layers.eyes) {
        for (std::uint32_t i = 0; i < 2; ++i) {
            views[i] = typed<XrCompositionLayerProjectionView>(XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW);
            views[i].pose = layers.eyes->views[i].pose;
            views[i].fov = layers.eyes->views[i].fov;
            views[i].subImage = wholeImage(colour_[i]);
            if (!layers.has_depth) continue;
            depths[i] = typed<XrCompositionLayerDepthInfoKHR>(XR_TYPE_COMPOSITION_LAYER_DEPTH_INFO_KHR);
            depths[i].subImage = wholeImage(depth_[i]);
            depths[i].minDepth = 0.0F;
            depths[i].maxDepth = 1.0F;
            depths[i].nearZ = static_cast<float>(layers.near_m);
            depths[i].farZ = static_cast<float>(layers.far_m);
            views[i].next = &depths[i];
        }
        // Holes show the board beneath: colours are premultiplied.
        if (layers.beneath) picture.layerFlags = XR_COMPOSITION_LAYER_BLEND_TEXTURE_SOURCE_ALPHA_BIT;
        picture.space = tracking_;
        picture.viewCount = 2;
        picture.views = views.data();
        add(picture);
    }
    if (layers.above) {
        above = quadLayer(*layers.above, layers.above->before_face ? view_ : tracking_);
        add(above);
    }
    auto info = typed<XrFrameEndInfo>(XR_TYPE_FRAME_END_INFO);
    info.displayTime = frame.display_time;
    info.environmentBlendMode = blend_mode_;
    info.layerCount = static_cast<std::uint32_t>(list.size());
    info.layers = list.data();
    frame_open_ = false;
    const XrResult ended = xrEndFrame(session_, &info);
    // Some runtimes leave OpenGL errors of their own behind, which are not the renderer's.
    while (glGetError() != GL_NO_ERROR) {
    }
    if (XR_FAILED(ended)) lost_ = true;
    check(ended, "xrEndFrame");
}

}  // namespace deixis::app
