#include "xr_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "xr_input.hpp"

namespace deixis::app {

namespace {

// GL's names of the formats, so that no GL header is needed here.
constexpr std::int64_t gl_srgb8_alpha8 = 0x8C43;
constexpr std::int64_t gl_depth_component32f = 0x8CAC;

// In the registry since 1.0.29 and part of 1.1; older headers lack the name.
constexpr auto local_floor_space = static_cast<XrReferenceSpaceType>(1000426000);

constexpr XrViewConfigurationType stereo = XR_VIEW_CONFIGURATION_TYPE_PRIMARY_STEREO;

XrReferenceSpaceType bestSpace(XrSession session) {
    std::uint32_t count = 0;
    check(xrEnumerateReferenceSpaces(session, 0, &count, nullptr), "xrEnumerateReferenceSpaces");
    std::vector<XrReferenceSpaceType> offered(count);
    check(xrEnumerateReferenceSpaces(session, count, &count, offered.data()), "xrEnumerateReferenceSpaces");
    for (const XrReferenceSpaceType type : {XR_REFERENCE_SPACE_TYPE_STAGE, local_floor_space})
        if (std::find(offered.begin(), offered.end(), type) != offered.end()) return type;
    return XR_REFERENCE_SPACE_TYPE_LOCAL;
}

XrSpace referenceSpace(XrSession session, XrReferenceSpaceType type, const Pose& origin) {
    auto info = typed<XrReferenceSpaceCreateInfo>(XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
    info.referenceSpaceType = type;
    info.poseInReferenceSpace = xrPose(origin);
    XrSpace space = XR_NULL_HANDLE;
    check(xrCreateReferenceSpace(session, &info, &space), "xrCreateReferenceSpace");
    return space;
}

}  // namespace

Result<std::unique_ptr<XrSessionLoop>> XrSessionLoop::open(const XrRuntime& runtime, const GlWindow& window,
                                                           const XrSessionOptions& options) {
    if (auto usable = requireOpenGl(runtime); !usable) return tl::unexpected(usable.error());
    auto binding = bindGraphics(window);
    if (!binding) return tl::unexpected(binding.error());
    std::unique_ptr<XrSessionLoop> loop(new XrSessionLoop(runtime));
    loop->binding_ = std::move(*binding);
    auto info = typed<XrSessionCreateInfo>(XR_TYPE_SESSION_CREATE_INFO);
    info.next = loop->binding_->next();
    info.systemId = runtime.system();
    const XrResult made = xrCreateSession(runtime.instance(), &info, &loop->session_);
    if (XR_FAILED(made))
        return fail("headset", fmt::format("the runtime made no session: {}", nameOf(made)),
                    "Another VR program may be using the headset: close it, then try again");
    loop->createSpaces(options.assumed_eye_height_m);
    if (auto ready = loop->createSwapchains(options.resolution_scale); !ready)
        return tl::unexpected(ready.error());
    loop->chooseBlendMode();
    return loop;
}

XrSessionLoop::~XrSessionLoop() {
    if (session_ == XR_NULL_HANDLE) return;
    if (!lost_) {
        if (frame_open_) {
            auto info = typed<XrFrameEndInfo>(XR_TYPE_FRAME_END_INFO);
            info.displayTime = open_frame_time_;
            info.environmentBlendMode = blend_mode_;
            xrEndFrame(session_, &info);
        }
        // A session is ended in the state stopping, which a request brings about; a destroyed one need not
        // be.
        if (lifecycle_.running()) xrRequestExitSession(session_);
    }
    colour_ = {};
    depth_ = {};
    if (view_ != XR_NULL_HANDLE) xrDestroySpace(view_);
    if (tracking_ != XR_NULL_HANDLE) xrDestroySpace(tracking_);
    xrDestroySession(session_);
}

void XrSessionLoop::requestExit() {
    if (lifecycle_.running() && !lost_) check(xrRequestExitSession(session_), "xrRequestExitSession");
}

void XrSessionLoop::createSpaces(double assumed_eye_height_m) {
    space_type_ = bestSpace(session_);
    Pose origin;
    if (space_type_ == XR_REFERENCE_SPACE_TYPE_STAGE) {
        space_name_ = "stage";
    } else if (space_type_ == local_floor_space) {
        space_name_ = "local floor";
    } else {
        // Its origin is where the eyes were: the floor is taken to lie an assumed eye height below.
        space_name_ = "local";
        origin.position.y = -assumed_eye_height_m;
    }
    tracking_ = referenceSpace(session_, space_type_, origin);
    view_ = referenceSpace(session_, XR_REFERENCE_SPACE_TYPE_VIEW, {});
}

Result<void> XrSessionLoop::createSwapchains(double resolution_scale) {
    std::uint32_t count = 0;
    std::array<XrViewConfigurationView, 2> views{};
    for (auto& view : views) view = typed<XrViewConfigurationView>(XR_TYPE_VIEW_CONFIGURATION_VIEW);
    check(xrEnumerateViewConfigurationViews(runtime_.instance(), runtime_.system(), stereo, 2, &count,
                                            views.data()),
          "xrEnumerateViewConfigurationViews");
    const auto scaled = [&](std::uint32_t recommended, std::uint32_t max) {
        const double wanted = std::round(recommended * resolution_scale);
        return static_cast<int>(std::clamp(wanted, 16.0, static_cast<double>(max)));
    };
    XrSwapchainSize size;
    for (const auto& view : views) {
        size.width = std::max(size.width, scaled(view.recommendedImageRectWidth, view.maxImageRectWidth));
        size.height = std::max(size.height, scaled(view.recommendedImageRectHeight, view.maxImageRectHeight));
    }
    const std::int64_t colour_format = firstOfferedFormat(session_, {gl_srgb8_alpha8});
    if (colour_format == 0)
        return fail("headset", "the runtime offers no sRGB pictures (GL_SRGB8_ALPHA8)", "Update the runtime");
    for (auto& eye : colour_)
        eye = XrGlSwapchain(session_, colour_format, XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT, size);
    if (runtime_.has("XR_KHR_composition_layer_depth")) {
        const std::int64_t depth_format = firstOfferedFormat(session_, {gl_depth_component32f});
        for (auto& eye : depth_)
            if (depth_format != 0)
                eye = XrGlSwapchain(session_, depth_format, XR_SWAPCHAIN_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                                    size);
    }
    return {};
}

XrGlSwapchain XrSessionLoop::boardPicture(int width, int height) const {
    return {session_, gl_srgb8_alpha8, XR_SWAPCHAIN_USAGE_COLOR_ATTACHMENT_BIT, {width, height}};
}

void XrSessionLoop::chooseBlendMode() {
    std::uint32_t count = 0;
    const auto enumerate = [&](std::uint32_t capacity, XrEnvironmentBlendMode* modes) {
        check(xrEnumerateEnvironmentBlendModes(runtime_.instance(), runtime_.system(), stereo, capacity,
                                               &count, modes),
              "xrEnumerateEnvironmentBlendModes");
    };
    enumerate(0, nullptr);
    std::vector<XrEnvironmentBlendMode> modes(count, XR_ENVIRONMENT_BLEND_MODE_OPAQUE);
    enumerate(count, modes.data());
    const bool opaque =
        std::find(modes.begin(), modes.end(), XR_ENVIRONMENT_BLEND_MODE_OPAQUE) != modes.end();
    blend_mode_ = opaque || modes.empty() ? XR_ENVIRONMENT_BLEND_MODE_OPAQUE : modes.front();
}

std::array<renderer::HiddenArea, 2> XrSessionLoop::hiddenArea() const {
    std::array<renderer::HiddenArea, 2> areas;
    if (!runtime_.has("XR_KHR_visibility_mask")) return areas;
    const auto get = runtime_.function<PFN_xrGetVisibilityMaskKHR>("xrGetVisibilityMaskKHR");
    if (get == nullptr) return areas;
    for (std::uint32_t eye = 0; eye < 2; ++eye) {
        auto mask = typed<XrVisibilityMaskKHR>(XR_TYPE_VISIBILITY_MASK_KHR);
        const auto ask = [&] {
            return XR_SUCCEEDED(
                get(session_, stereo, eye, XR_VISIBILITY_MASK_TYPE_HIDDEN_TRIANGLE_MESH_KHR, &mask));
        };
        // Without it the picture is the same, only more of it is drawn than can be seen.
        if (!ask() || mask.vertexCountOutput == 0 || mask.indexCountOutput % 3 != 0) continue;
        std::vector<XrVector2f> corners(mask.vertexCountOutput);
        areas[eye].indices.resize(mask.indexCountOutput);
        mask.vertexCapacityInput = mask.vertexCountOutput;
        mask.vertices = corners.data();
        mask.indexCapacityInput = mask.indexCountOutput;
        mask.indices = areas[eye].indices.data();
        if (!ask()) {
            areas[eye] = {};
            continue;
        }
        for (const XrVector2f& corner : corners) areas[eye].corners.emplace_back(corner.x, corner.y);
    }
    return areas;
}

void XrSessionLoop::enter(XrSessionState state, XrTime time, XrEvents& events) {
    const XrDuty duty = lifecycle_.enter(state);
    // Some runtimes give no time with their events.
    const bool timed = station_zero_ns_ && time > 0;
    events.notes.push_back(
        {studies::NoteKind::xr_state, std::string(nameOf(state)), timed ? stationSeconds(time) : now_s()});
    switch (duty) {
        case XrDuty::begin_session: {
            auto info = typed<XrSessionBeginInfo>(XR_TYPE_SESSION_BEGIN_INFO);
            info.primaryViewConfigurationType = stereo;
            check(xrBeginSession(session_, &info), "xrBeginSession");
            last_display_time_ = 0;
            fixClock();
            break;
        }
        case XrDuty::end_session:
            check(xrEndSession(session_), "xrEndSession");
            break;
        case XrDuty::leave:
            events.leave = true;
            break;
        case XrDuty::lost:
            lost_ = true;
            events.lost.emplace("the runtime announced the loss of the session", XR_ERROR_SESSION_LOST);
            break;
        case XrDuty::none:
            break;
    }
}

XrEvents XrSessionLoop::poll() {
    XrEvents events;
    while (!events.lost) {
        auto event = typed<XrEventDataBuffer>(XR_TYPE_EVENT_DATA_BUFFER);
        const XrResult polled = xrPollEvent(runtime_.instance(), &event);
        if (polled == XR_EVENT_UNAVAILABLE) return events;
        if (XR_FAILED(polled)) {
            lost_ = true;
            events.lost.emplace(fmt::format("xrPollEvent failed: {}", nameOf(polled)), polled);
            return events;
        }
        switch (event.type) {
            case XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED: {
                const auto& changed = reinterpret_cast<const XrEventDataSessionStateChanged&>(event);
                if (changed.session == session_) enter(changed.state, changed.time, events);
                break;
            }
            case XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING:
                events.notes.push_back({studies::NoteKind::xr_state, "instance loss pending", now_s()});
                lost_ = true;
                events.lost.emplace("the runtime announced its end", XR_ERROR_INSTANCE_LOST);
                break;
            case XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING: {
                const auto& change = reinterpret_cast<const XrEventDataReferenceSpaceChangePending&>(event);
                if (change.session == session_ && change.referenceSpaceType == space_type_)
                    events.recentred_at = change.changeTime;
                break;
            }
            case XR_TYPE_EVENT_DATA_INTERACTION_PROFILE_CHANGED:
                events.profiles = true;
                break;
            case XR_TYPE_EVENT_DATA_VISIBILITY_MASK_CHANGED_KHR:
                events.hidden_area = true;
                break;
            case XR_TYPE_EVENT_DATA_EVENTS_LOST:
                events.notes.push_back(
                    {studies::NoteKind::xr_state, "the runtime lost some of its events", now_s()});
                break;
            default:
                break;
        }
    }
    return events;
}

}  // namespace deixis::app
