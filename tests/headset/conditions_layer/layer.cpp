// An OpenXR API layer between the program and a real runtime that brings about what a simulated headset
// cannot: taken off and put on, tracking lost, recentred by the runtime, no headset, fewer spaces, tracked
// eyes, the runtime gone. Only what the program calls is intercepted; everything else goes through.
//
// There is one instance and one session, used by one thread. What is drawn is not moved with a recentred
// space: the compositor's picture is then displaced. No test looks at it.
#include <openxr/openxr.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "commands.hpp"
#include "loader_interface.hpp"
#include "located.hpp"
#include "session_states.hpp"

namespace deixis::conditions {

namespace {

// In the registry since 1.0.29; older headers lack the name.
constexpr auto local_floor_space = static_cast<XrReferenceSpaceType>(1000426000);
constexpr const char* gaze_profile = "/interaction_profiles/ext/eye_gaze_interaction";

#define INTERCEPTED(F)                   \
    F(DestroyInstance)                   \
    F(GetSystem)                         \
    F(GetSystemProperties)               \
    F(PollEvent)                         \
    F(CreateSession)                     \
    F(EnumerateReferenceSpaces)          \
    F(CreateReferenceSpace)              \
    F(SuggestInteractionProfileBindings) \
    F(CreateActionSpace)                 \
    F(SyncActions)                       \
    F(ApplyHapticFeedback)               \
    F(LocateSpace)                       \
    F(LocateViews)                       \
    F(WaitFrame)                         \
    F(BeginFrame)                        \
    F(EndFrame)
#define USED(F)     \
    F(PathToString) \
    F(RequestExitSession)

/// What the test wants to know when the program has ended.
struct Counts {
    int begun = 0;
    int ended = 0;
    int pictures = 0;            ///< frames that ended with layers
    int hidden = 0;              ///< frames that were not to be rendered
    int pictures_in_hidden = 0;  ///< and ended with layers
    int calls_after_loss = 0;    ///< of what is intercepted here
};

struct Layer {
    struct {
        PFN_xrGetInstanceProcAddr GetInstanceProcAddr = nullptr;
#define NEXT(name) PFN_xr##name name = nullptr;
        INTERCEPTED(NEXT) USED(NEXT)
#undef NEXT
    } next;

    Commands commands;
    Conditions now;
    XrInstance instance = XR_NULL_HANDLE;
    XrSession session = XR_NULL_HANDLE;
    SessionStates states;
    Recentrings recentrings;
    std::set<XrSpace> heads;  ///< view spaces
    XrSpace head = XR_NULL_HANDLE;
    XrReferenceSpaceType program_space = XR_REFERENCE_SPACE_TYPE_LOCAL;
    XrAction gaze_action = XR_NULL_HANDLE;
    XrSpace gaze_space = XR_NULL_HANDLE;
    XrResult lost = XR_SUCCESS;
    XrTime display_time = 0;  ///< of the frame under way
    bool render = true;       ///< it
    Counts counts;

    /// The result of a call where instance or session are lost by now.
    XrResult losing(const char* call) {
        if (lost == XR_SUCCESS && now.loss && now.loss->call == call)
            lost = now.loss->result;
        else if (lost != XR_SUCCESS)
            ++counts.calls_after_loss;
        return lost;
    }
};

std::unique_ptr<Layer> layer;

#define UNLESS_LOST(call) \
    if (const XrResult lost = layer->losing(call); XR_FAILED(lost)) return lost

void writeCounts() {
    const Counts& c = layer->counts;
    std::ofstream(layer->commands.file() + ".counts")
        << "{\"begun\": " << c.begun << ", \"ended\": " << c.ended << ", \"pictures\": " << c.pictures
        << ", \"hidden\": " << c.hidden << ", \"pictures_in_hidden\": " << c.pictures_in_hidden
        << ", \"calls_after_loss\": " << c.calls_after_loss << "}\n";
}

// Instance and system.

XrResult XRAPI_CALL xrDestroyInstance(XrInstance instance) {
    writeCounts();
    const XrResult result = layer->next.DestroyInstance(instance);
    layer.reset();
    return result;
}

XrResult XRAPI_CALL xrGetSystem(XrInstance instance, const XrSystemGetInfo* info, XrSystemId* system) {
    if (!layer->now.headset) return XR_ERROR_FORM_FACTOR_UNAVAILABLE;
    return layer->next.GetSystem(instance, info, system);
}

XrResult XRAPI_CALL xrGetSystemProperties(XrInstance instance, XrSystemId system,
                                          XrSystemProperties* properties) {
    const XrResult result = layer->next.GetSystemProperties(instance, system, properties);
    if (XR_FAILED(result) || !layer->now.gaze) return result;
    for (auto* more = static_cast<XrBaseOutStructure*>(properties->next); more != nullptr; more = more->next)
        if (more->type == XR_TYPE_SYSTEM_EYE_GAZE_INTERACTION_PROPERTIES_EXT)
            reinterpret_cast<XrSystemEyeGazeInteractionPropertiesEXT*>(more)->supportsEyeGazeInteraction =
                XR_TRUE;
    return result;
}

// Events.

template <typename Event>
Event& eventIn(XrEventDataBuffer* buffer, XrStructureType type) {
    auto& event = *reinterpret_cast<Event*>(buffer);
    event = {};
    event.type = type;
    return event;
}

bool tellState(XrEventDataBuffer* buffer) {
    const auto state = layer->states.next();
    if (!state) return false;
    auto& event = eventIn<XrEventDataSessionStateChanged>(buffer, XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED);
    event.session = layer->session;
    event.state = *state;
    event.time = layer->display_time;
    if (*state == XR_SESSION_STATE_LOSS_PENDING) layer->lost = XR_ERROR_SESSION_LOST;
    return true;
}

bool tellRecentring(XrEventDataBuffer* buffer) {
    if (layer->now.recentrings.empty() || layer->display_time == 0) return false;
    const Recentring wanted = layer->now.recentrings.front();
    layer->now.recentrings.pop_front();
    auto& event = eventIn<XrEventDataReferenceSpaceChangePending>(
        buffer, XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING);
    event.session = layer->session;
    event.referenceSpaceType = layer->program_space;
    event.changeTime = layer->display_time + static_cast<XrTime>(wanted.ahead_s * 1e9);
    event.poseValid = XR_TRUE;
    event.poseInPreviousSpace = wanted.old_from_new;
    layer->recentrings.add(wanted.old_from_new, event.changeTime);
    return true;
}

bool tellInstanceLoss(XrEventDataBuffer* buffer) {
    if (!layer->now.announce_instance_loss) return false;
    layer->now.announce_instance_loss = false;
    auto& event = eventIn<XrEventDataInstanceLossPending>(buffer, XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING);
    event.lossTime = layer->display_time;
    layer->lost = XR_ERROR_INSTANCE_LOST;
    return true;
}

XrResult XRAPI_CALL xrPollEvent(XrInstance instance, XrEventDataBuffer* buffer) {
    UNLESS_LOST("xrPollEvent");
    Layer& l = *layer;
    l.commands.read(l.now, l.counts.begun);
    l.states.allow(l.now.max);
    if (std::exchange(l.now.exit, false)) l.next.RequestExitSession(l.session);
    if (std::exchange(l.now.announce_session_loss, false)) l.states.tell(XR_SESSION_STATE_LOSS_PENDING);
    if (tellState(buffer) || tellRecentring(buffer) || tellInstanceLoss(buffer)) return XR_SUCCESS;
    while (true) {
        const XrResult result = l.next.PollEvent(instance, buffer);
        if (result != XR_SUCCESS || buffer->type != XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED) return result;
        l.states.enter(reinterpret_cast<XrEventDataSessionStateChanged*>(buffer)->state);
        if (tellState(buffer)) return XR_SUCCESS;
        buffer->type = XR_TYPE_EVENT_DATA_BUFFER;  // a step that the program must not see
    }
}

// Session and spaces.

XrResult XRAPI_CALL xrCreateSession(XrInstance instance, const XrSessionCreateInfo* info,
                                    XrSession* session) {
    const XrResult result = layer->next.CreateSession(instance, info, session);
    if (XR_FAILED(result)) return result;
    layer->session = *session;
    XrReferenceSpaceCreateInfo head{};
    head.type = XR_TYPE_REFERENCE_SPACE_CREATE_INFO;
    head.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_VIEW;
    head.poseInReferenceSpace.orientation.w = 1.0F;
    return layer->next.CreateReferenceSpace(*session, &head, &layer->head);  // goes with the session
}

bool offered(XrReferenceSpaceType type) {
    const Spaces spaces = layer->now.spaces;
    if (type == XR_REFERENCE_SPACE_TYPE_STAGE) return spaces == Spaces::all;
    if (type == local_floor_space) return spaces != Spaces::local;
    return true;
}

XrResult XRAPI_CALL xrEnumerateReferenceSpaces(XrSession session, std::uint32_t capacity,
                                               std::uint32_t* count, XrReferenceSpaceType* spaces) {
    std::array<XrReferenceSpaceType, 32> all{};
    std::uint32_t found = 0;
    const XrResult result = layer->next.EnumerateReferenceSpaces(
        session, static_cast<std::uint32_t>(all.size()), &found, all.data());
    if (XR_FAILED(result)) return result;
    auto* const end = std::remove_if(all.data(), all.data() + found,
                                     [](XrReferenceSpaceType type) { return !offered(type); });
    *count = static_cast<std::uint32_t>(end - all.data());
    if (capacity == 0) return XR_SUCCESS;
    if (capacity < *count) return XR_ERROR_SIZE_INSUFFICIENT;
    std::copy(all.data(), end, spaces);
    return XR_SUCCESS;
}

XrResult XRAPI_CALL xrCreateReferenceSpace(XrSession session, const XrReferenceSpaceCreateInfo* info,
                                           XrSpace* space) {
    const XrReferenceSpaceType type = info->referenceSpaceType;
    if (!offered(type)) return XR_ERROR_REFERENCE_SPACE_UNSUPPORTED;
    XrReferenceSpaceCreateInfo real = *info;
    if (type == XR_REFERENCE_SPACE_TYPE_LOCAL && layer->now.spaces == Spaces::local) {
        // Where the test says, wherever the runtime's own may be.
        const XrPosef raised{{0.0F, 0.0F, 0.0F, 1.0F}, {0.0F, layer->now.local_height_m, 0.0F}};
        real.referenceSpaceType = XR_REFERENCE_SPACE_TYPE_STAGE;
        real.poseInReferenceSpace = multiply(raised, info->poseInReferenceSpace);
    }
    const XrResult result = layer->next.CreateReferenceSpace(session, &real, space);
    if (XR_FAILED(result)) return result;
    if (type == XR_REFERENCE_SPACE_TYPE_VIEW)
        layer->heads.insert(*space);
    else
        layer->program_space = type;
    return result;
}

// Input.

XrResult XRAPI_CALL xrSuggestInteractionProfileBindings(
    XrInstance instance, const XrInteractionProfileSuggestedBinding* suggested) {
    std::array<char, XR_MAX_PATH_LENGTH> profile{};
    std::uint32_t length = 0;
    layer->next.PathToString(instance, suggested->interactionProfile,
                             static_cast<std::uint32_t>(profile.size()), &length, profile.data());
    if (std::strcmp(profile.data(), gaze_profile) == 0 && suggested->countSuggestedBindings > 0)
        layer->gaze_action = suggested->suggestedBindings[0].action;
    return layer->next.SuggestInteractionProfileBindings(instance, suggested);
}

XrResult XRAPI_CALL xrCreateActionSpace(XrSession session, const XrActionSpaceCreateInfo* info,
                                        XrSpace* space) {
    const XrResult result = layer->next.CreateActionSpace(session, info, space);
    if (XR_SUCCEEDED(result) && info->action == layer->gaze_action) layer->gaze_space = *space;
    return result;
}

XrResult XRAPI_CALL xrSyncActions(XrSession session, const XrActionsSyncInfo* info) {
    UNLESS_LOST("xrSyncActions");
    // All actions are inactive then. The program asks for none of them, so none is changed here.
    if (!layer->states.focused()) return XR_SESSION_NOT_FOCUSED;
    if (layer->now.input_held) return XR_SUCCESS;  // every action keeps the state of the last call
    return layer->next.SyncActions(session, info);
}

XrResult XRAPI_CALL xrApplyHapticFeedback(XrSession session, const XrHapticActionInfo* info,
                                          const XrHapticBaseHeader* feedback) {
    UNLESS_LOST("xrApplyHapticFeedback");
    if (!layer->states.focused()) return XR_SESSION_NOT_FOCUSED;
    return layer->next.ApplyHapticFeedback(session, info, feedback);
}

// Where things are.

XrResult XRAPI_CALL xrLocateSpace(XrSpace space, XrSpace base, XrTime time, XrSpaceLocation* location) {
    UNLESS_LOST("xrLocateSpace");
    const bool gaze = space == layer->gaze_space && layer->now.gaze;
    const XrResult result = layer->next.LocateSpace(gaze ? layer->head : space, base, time, location);
    if (XR_FAILED(result)) return result;
    if (gaze) {
        const Gaze& eyes = *layer->now.gaze;
        location->pose = multiply(location->pose, {turned(eyes.yaw_deg, eyes.pitch_deg), {}});
    }
    if (layer->heads.count(base) == 0) location->pose = layer->recentrings.apply(location->pose, time);
    if (gaze) limit(layer->now.gaze->tracking, location->locationFlags, location->pose);
    if (gaze || layer->heads.count(space) > 0)
        limit(layer->now.head, location->locationFlags, location->pose);
    return result;
}

XrResult XRAPI_CALL xrLocateViews(XrSession session, const XrViewLocateInfo* info, XrViewState* state,
                                  std::uint32_t capacity, std::uint32_t* count, XrView* views) {
    UNLESS_LOST("xrLocateViews");
    const XrResult result = layer->next.LocateViews(session, info, state, capacity, count, views);
    if (XR_FAILED(result) || capacity == 0) return result;
    const XrViewStateFlags real = state->viewStateFlags;
    for (std::uint32_t i = 0; i < *count; ++i) {
        views[i].pose = layer->recentrings.apply(views[i].pose, info->displayTime);
        state->viewStateFlags = real;  // bit for bit those of a space's location
        limit(layer->now.head, state->viewStateFlags, views[i].pose);
    }
    return result;
}

// Frames.

XrResult XRAPI_CALL xrWaitFrame(XrSession session, const XrFrameWaitInfo* info, XrFrameState* state) {
    UNLESS_LOST("xrWaitFrame");
    const XrResult result = layer->next.WaitFrame(session, info, state);
    if (XR_FAILED(result)) return result;
    layer->display_time = state->predictedDisplayTime;
    if (!layer->states.visible()) state->shouldRender = XR_FALSE;
    layer->render = state->shouldRender == XR_TRUE;
    return result;
}

XrResult XRAPI_CALL xrBeginFrame(XrSession session, const XrFrameBeginInfo* info) {
    UNLESS_LOST("xrBeginFrame");
    const XrResult result = layer->next.BeginFrame(session, info);
    if (XR_SUCCEEDED(result)) ++layer->counts.begun;
    return result;
}

XrResult XRAPI_CALL xrEndFrame(XrSession session, const XrFrameEndInfo* info) {
    UNLESS_LOST("xrEndFrame");
    Counts& counts = layer->counts;
    const bool picture = info->layerCount > 0;
    ++counts.ended;
    counts.pictures += picture ? 1 : 0;
    counts.hidden += layer->render ? 0 : 1;
    counts.pictures_in_hidden += picture && !layer->render ? 1 : 0;
    return layer->next.EndFrame(session, info);
}

// The loader's side.

template <typename Function>
void find(XrInstance instance, const char* name, Function& function) {
    PFN_xrVoidFunction found = nullptr;
    layer->next.GetInstanceProcAddr(instance, name, &found);
    function = reinterpret_cast<Function>(found);
}

XrResult XRAPI_CALL xrGetInstanceProcAddr(XrInstance instance, const char* name,
                                          PFN_xrVoidFunction* function) {
#define OURS(call)                                                  \
    if (std::strcmp(name, "xr" #call) == 0) {                       \
        *function = reinterpret_cast<PFN_xrVoidFunction>(xr##call); \
        return XR_SUCCESS;                                          \
    }
    INTERCEPTED(OURS)
#undef OURS
    return layer ? layer->next.GetInstanceProcAddr(instance, name, function) : XR_ERROR_HANDLE_INVALID;
}

XrResult XRAPI_CALL createLayerInstance(const XrInstanceCreateInfo* info, const LayerCreateInfo* layer_info,
                                        XrInstance* instance) {
    layer = std::make_unique<Layer>();
    layer->commands.read(layer->now, layer->counts.begun);
    LayerCreateInfo for_next = *layer_info;
    for_next.next_info = layer_info->next_info->next;
    const XrResult result = layer_info->next_info->next_create_layer_instance(info, &for_next, instance);
    if (XR_FAILED(result)) {
        layer.reset();
        return result;
    }
    layer->instance = *instance;
    layer->next.GetInstanceProcAddr = layer_info->next_info->next_get_instance_proc_addr;
#define FIND(call) find(*instance, "xr" #call, layer->next.call);
    INTERCEPTED(FIND)
    USED(FIND)
#undef FIND
    return result;
}

}  // namespace

}  // namespace deixis::conditions

/// The one function that the loader looks for.
extern "C" __attribute__((visibility("default"))) XrResult XRAPI_CALL xrNegotiateLoaderApiLayerInterface(
    const deixis::conditions::LoaderInfo* loader, const char*, deixis::conditions::LayerRequest* request) {
    using namespace deixis::conditions;
    if (loader == nullptr || request == nullptr || loader->type != LoaderStructure::loader_info ||
        request->type != LoaderStructure::api_layer_request ||
        loader->min_interface_version > interface_version ||
        loader->max_interface_version < interface_version)
        return XR_ERROR_INITIALIZATION_FAILED;
    request->layer_interface_version = interface_version;
    request->layer_api_version = XR_MAKE_VERSION(1, 0, 0);
    request->get_instance_proc_addr = xrGetInstanceProcAddr;
    request->create_layer_instance = createLayerInstance;
    return XR_SUCCESS;
}
