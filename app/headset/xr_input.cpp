#include "xr_input.hpp"

#include <fmt/format.h>

#include <cstring>

#include "xr_bindings.hpp"
#include "xr_hand_joints.hpp"

namespace deixis::app {

namespace {

constexpr std::array hand_names{"left", "right"};  // by studies::Hand
constexpr XrPosef no_offset{{0.0F, 0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 0.0F}};
constexpr XrDuration tick_ns = 15'000'000;
constexpr float tick_amplitude = 0.3F;

template <std::size_t Size>
void copyName(char (&to)[Size], const char* name) {
    std::strncpy(to, name, Size - 1);
}

}  // namespace

struct XrInput::Impl {
    const XrRuntime& runtime;
    XrSession session;
    std::array<XrPath, 2> hands{};
    XrActionSet actions = XR_NULL_HANDLE;
    XrAction aim = XR_NULL_HANDLE, grip = XR_NULL_HANDLE, select = XR_NULL_HANDLE, menu = XR_NULL_HANDLE;
    XrAction farther = XR_NULL_HANDLE;
    XrAction recentre = XR_NULL_HANDLE, haptic = XR_NULL_HANDLE, gaze = XR_NULL_HANDLE;
    std::array<XrSpace, 2> aim_spaces{}, grip_spaces{};
    XrSpace gaze_space = XR_NULL_HANDLE;
    std::unique_ptr<XrHandJoints> joints;

    Impl(const XrRuntime& of, XrSession in) : runtime(of), session(in) {}
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl();

    void makeActionSet();
    [[nodiscard]] XrAction makeAction(XrActionType type, const char* name, const char* words,
                                      bool of_hands) const;
    void suggest(const XrControllerBindings& controller) const;
    void suggestGaze() const;
    [[nodiscard]] XrSpace makeSpace(XrAction action, XrPath hand) const;
    [[nodiscard]] XrActionStateBoolean button(XrAction action, std::size_t hand) const;
    [[nodiscard]] double axis(XrAction action, std::size_t hand) const;
};

XrInput::Impl::~Impl() {
    joints.reset();
    for (XrSpace space : {aim_spaces[0], aim_spaces[1], grip_spaces[0], grip_spaces[1], gaze_space})
        if (space != XR_NULL_HANDLE) xrDestroySpace(space);
    if (actions != XR_NULL_HANDLE) xrDestroyActionSet(actions);  // and its actions
}

void XrInput::Impl::makeActionSet() {
    auto creation = typed<XrActionSetCreateInfo>(XR_TYPE_ACTION_SET_CREATE_INFO);
    copyName(creation.actionSetName, "deixis");
    copyName(creation.localizedActionSetName, "Deixis");
    check(xrCreateActionSet(runtime.instance(), &creation, &actions), "xrCreateActionSet");
}

XrAction XrInput::Impl::makeAction(XrActionType type, const char* name, const char* words,
                                   bool of_hands) const {
    auto creation = typed<XrActionCreateInfo>(XR_TYPE_ACTION_CREATE_INFO);
    creation.actionType = type;
    copyName(creation.actionName, name);
    copyName(creation.localizedActionName, words);
    if (of_hands) {
        creation.countSubactionPaths = static_cast<std::uint32_t>(hands.size());
        creation.subactionPaths = hands.data();
    }
    XrAction action = XR_NULL_HANDLE;
    check(xrCreateAction(actions, &creation, &action), "xrCreateAction");
    return action;
}

constexpr std::string_view simple_profile = "/interaction_profiles/khr/simple_controller";

void XrInput::Impl::suggest(const XrControllerBindings& controller) const {
    std::vector<XrActionSuggestedBinding> bindings;
    for (std::size_t hand = 0; hand < hands.size(); ++hand) {
        const auto bind = [&](XrAction action, const char* kind, const char* component) {
            if (*component == '\0') return;
            const std::string text = fmt::format("/user/hand/{}/{}/{}", hand_names[hand], kind, component);
            bindings.push_back({action, runtime.path(text.c_str())});
        };
        bind(aim, "input", "aim/pose");
        bind(grip, "input", "grip/pose");
        bind(select, "input", controller.select);
        bind(menu, "input", controller.menu[hand]);
        bind(recentre, "input", controller.recentre);
        bind(farther, "input", controller.farther);
        bind(haptic, "output", controller.haptic ? "haptic" : "");
    }
    auto suggestion =
        typed<XrInteractionProfileSuggestedBinding>(XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING);
    suggestion.interactionProfile = runtime.path(controller.profile);
    suggestion.countSuggestedBindings = static_cast<std::uint32_t>(bindings.size());
    suggestion.suggestedBindings = bindings.data();
    const XrResult result = xrSuggestInteractionProfileBindings(runtime.instance(), &suggestion);
    // Some runtimes refuse controllers that they do not know; the others remain.
    if (result == XR_ERROR_PATH_UNSUPPORTED && controller.profile != simple_profile) return;
    check(result, fmt::format("xrSuggestInteractionProfileBindings({})", controller.profile).c_str());
}

void XrInput::Impl::suggestGaze() const {
    const XrActionSuggestedBinding binding{gaze, runtime.path("/user/eyes_ext/input/gaze_ext/pose")};
    auto suggestion =
        typed<XrInteractionProfileSuggestedBinding>(XR_TYPE_INTERACTION_PROFILE_SUGGESTED_BINDING);
    suggestion.interactionProfile = runtime.path("/interaction_profiles/ext/eye_gaze_interaction");
    suggestion.countSuggestedBindings = 1;
    suggestion.suggestedBindings = &binding;
    check(xrSuggestInteractionProfileBindings(runtime.instance(), &suggestion),
          "xrSuggestInteractionProfileBindings(eye_gaze_interaction)");
}

XrSpace XrInput::Impl::makeSpace(XrAction action, XrPath hand) const {
    auto creation = typed<XrActionSpaceCreateInfo>(XR_TYPE_ACTION_SPACE_CREATE_INFO);
    creation.action = action;
    creation.subactionPath = hand;
    creation.poseInActionSpace = no_offset;
    XrSpace space = XR_NULL_HANDLE;
    check(xrCreateActionSpace(session, &creation, &space), "xrCreateActionSpace");
    return space;
}

XrActionStateBoolean XrInput::Impl::button(XrAction action, std::size_t hand) const {
    auto wanted = typed<XrActionStateGetInfo>(XR_TYPE_ACTION_STATE_GET_INFO);
    wanted.action = action;
    wanted.subactionPath = hands[hand];
    auto state = typed<XrActionStateBoolean>(XR_TYPE_ACTION_STATE_BOOLEAN);
    check(xrGetActionStateBoolean(session, &wanted, &state), "xrGetActionStateBoolean");
    return state;
}

double XrInput::Impl::axis(XrAction action, std::size_t hand) const {
    auto wanted = typed<XrActionStateGetInfo>(XR_TYPE_ACTION_STATE_GET_INFO);
    wanted.action = action;
    wanted.subactionPath = hands[hand];
    auto state = typed<XrActionStateFloat>(XR_TYPE_ACTION_STATE_FLOAT);
    check(xrGetActionStateFloat(session, &wanted, &state), "xrGetActionStateFloat");
    return state.isActive == XR_TRUE ? static_cast<double>(state.currentState) : 0.0;
}

XrInput::XrInput(const XrRuntime& runtime, XrSession session, const XrInputOptions& options)
    : impl_(std::make_unique<Impl>(runtime, session)) {
    Impl& input = *impl_;
    for (std::size_t hand = 0; hand < hand_names.size(); ++hand)
        input.hands[hand] = runtime.path(fmt::format("/user/hand/{}", hand_names[hand]).c_str());

    input.makeActionSet();
    input.aim = input.makeAction(XR_ACTION_TYPE_POSE_INPUT, "aim", "Aim of the ray", true);
    input.grip = input.makeAction(XR_ACTION_TYPE_POSE_INPUT, "grip", "Hand", true);
    input.select = input.makeAction(XR_ACTION_TYPE_BOOLEAN_INPUT, "select", "Select", true);
    input.menu = input.makeAction(XR_ACTION_TYPE_BOOLEAN_INPUT, "menu", "Pause", true);
    input.recentre = input.makeAction(XR_ACTION_TYPE_BOOLEAN_INPUT, "recentre", "Recentre (hold)", true);
    input.farther = input.makeAction(XR_ACTION_TYPE_FLOAT_INPUT, "farther", "Farther or nearer", true);
    input.haptic = input.makeAction(XR_ACTION_TYPE_VIBRATION_OUTPUT, "tick", "Tick", true);
    for (const auto& controller : controllerBindings())
        if (*controller.extension == '\0' || runtime.has(controller.extension)) input.suggest(controller);
    const bool gaze = options.gaze && runtime.tracksEyes();
    if (gaze) {
        input.gaze = input.makeAction(XR_ACTION_TYPE_POSE_INPUT, "gaze", "Gaze", false);
        input.suggestGaze();
    }

    auto attachment = typed<XrSessionActionSetsAttachInfo>(XR_TYPE_SESSION_ACTION_SETS_ATTACH_INFO);
    attachment.countActionSets = 1;
    attachment.actionSets = &input.actions;
    check(xrAttachSessionActionSets(session, &attachment), "xrAttachSessionActionSets");

    for (std::size_t hand = 0; hand < hand_names.size(); ++hand) {
        input.aim_spaces[hand] = input.makeSpace(input.aim, input.hands[hand]);
        input.grip_spaces[hand] = input.makeSpace(input.grip, input.hands[hand]);
    }
    if (gaze) input.gaze_space = input.makeSpace(input.gaze, XR_NULL_PATH);
    if (options.joints && runtime.tracksHands())
        input.joints = std::make_unique<XrHandJoints>(runtime, session);
}

XrInput::~XrInput() = default;

XrInputState XrInput::read(XrSpace tracking, XrTime display_time,
                           const std::function<double(XrTime)>& station_seconds) {
    const Impl& input = *impl_;
    XrInputState state;
    if (input.gaze_space != XR_NULL_HANDLE) state.gaze.emplace();

    const XrActiveActionSet active{input.actions, XR_NULL_PATH};
    auto sync = typed<XrActionsSyncInfo>(XR_TYPE_ACTIONS_SYNC_INFO);
    sync.countActiveActionSets = 1;
    sync.activeActionSets = &active;
    if (check(xrSyncActions(input.session, &sync), "xrSyncActions") == XR_SESSION_NOT_FOCUSED) return state;

    const auto locate = [&](XrSpace space) {
        auto location = typed<XrSpaceLocation>(XR_TYPE_SPACE_LOCATION);
        check(xrLocateSpace(space, tracking, display_time, &location), "xrLocateSpace");
        return trackedPose(location);
    };
    for (std::size_t hand = 0; hand < hand_names.size(); ++hand) {
        state.aim[hand] = locate(input.aim_spaces[hand]);
        state.grip[hand] = locate(input.grip_spaces[hand]);

        const XrActionStateBoolean select = input.button(input.select, hand);
        HandButton& button = state.select[hand];
        button.active = select.isActive == XR_TRUE;
        button.pressed = select.currentState == XR_TRUE;
        button.changed = select.changedSinceLastSync == XR_TRUE;
        if (button.changed && select.lastChangeTime > 0)
            button.changed_s = station_seconds(select.lastChangeTime);

        state.farther[hand] = input.axis(input.farther, hand);
        const XrActionStateBoolean menu = input.button(input.menu, hand);
        state.menu |= menu.currentState == XR_TRUE && menu.changedSinceLastSync == XR_TRUE;
        state.recentre_held |= input.button(input.recentre, hand).currentState == XR_TRUE;
    }
    if (state.gaze) *state.gaze = locate(input.gaze_space);
    if (input.joints) state.joints = input.joints->read(tracking, display_time);
    return state;
}

void XrInput::tick(studies::Hand hand) {
    auto where = typed<XrHapticActionInfo>(XR_TYPE_HAPTIC_ACTION_INFO);
    where.action = impl_->haptic;
    where.subactionPath = impl_->hands[static_cast<std::size_t>(hand)];
    auto vibration = typed<XrHapticVibration>(XR_TYPE_HAPTIC_VIBRATION);
    vibration.duration = tick_ns;
    vibration.frequency = XR_FREQUENCY_UNSPECIFIED;
    vibration.amplitude = tick_amplitude;
    check(xrApplyHapticFeedback(impl_->session, &where,
                                reinterpret_cast<const XrHapticBaseHeader*>(&vibration)),
          "xrApplyHapticFeedback");
}

std::array<std::string, 2> XrInput::profiles() const {
    std::array<std::string, 2> names;
    for (std::size_t hand = 0; hand < names.size(); ++hand) {
        auto state = typed<XrInteractionProfileState>(XR_TYPE_INTERACTION_PROFILE_STATE);
        check(xrGetCurrentInteractionProfile(impl_->session, impl_->hands[hand], &state),
              "xrGetCurrentInteractionProfile");
        names[hand] = impl_->runtime.text(state.interactionProfile);
    }
    return names;
}

}  // namespace deixis::app
