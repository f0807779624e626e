#include "xr_session_lifecycle.hpp"

#include <algorithm>
#include <array>

namespace deixis::app {

XrDuty XrSessionLifecycle::enter(XrSessionState state) {
    // Nothing comes after these two: the session is only to be destroyed.
    if (state_ == XR_SESSION_STATE_EXITING || state_ == XR_SESSION_STATE_LOSS_PENDING) return XrDuty::none;

    state_ = state;
    switch (state) {
        case XR_SESSION_STATE_READY:
            if (running_) return XrDuty::none;
            running_ = true;
            return XrDuty::begin_session;
        case XR_SESSION_STATE_STOPPING:
            if (!running_) return XrDuty::none;
            running_ = false;
            return XrDuty::end_session;
        case XR_SESSION_STATE_EXITING:
            running_ = false;
            return XrDuty::leave;
        case XR_SESSION_STATE_LOSS_PENDING:
            running_ = false;
            return XrDuty::lost;
        default:
            return XrDuty::none;
    }
}

bool XrSessionLifecycle::visible() const {
    return state_ == XR_SESSION_STATE_VISIBLE || state_ == XR_SESSION_STATE_FOCUSED;
}

namespace {

struct StateTraits {
    XrSessionState state;
    std::string_view name;
    const char* words;
};

constexpr std::array<StateTraits, 9> states{{
    {XR_SESSION_STATE_UNKNOWN, "unknown", "Starting"},
    {XR_SESSION_STATE_IDLE, "idle", "Waiting for the headset"},
    {XR_SESSION_STATE_READY, "ready", "Starting"},
    {XR_SESSION_STATE_SYNCHRONIZED, "synchronized", "Not worn, or hidden by another program"},
    {XR_SESSION_STATE_VISIBLE, "visible", "Seen, but a system menu takes the input"},
    {XR_SESSION_STATE_FOCUSED, "focused", "In use"},
    {XR_SESSION_STATE_STOPPING, "stopping", "Stopping"},
    {XR_SESSION_STATE_LOSS_PENDING, "loss pending", "The runtime is closing"},
    {XR_SESSION_STATE_EXITING, "exiting", "Ended by the runtime"},
}};

// States of later OpenXR versions are unknown here.
const StateTraits& traitsOf(XrSessionState state) {
    const auto* const found = std::find_if(states.begin(), states.end(),
                                           [&](const StateTraits& one) { return one.state == state; });
    return found == states.end() ? states.front() : *found;
}

}  // namespace

std::string_view nameOf(XrSessionState state) {
    return traitsOf(state).name;
}

DeviceWords wordsOf(XrSessionState state) {
    return {traitsOf(state).words, state == XR_SESSION_STATE_FOCUSED};
}

}  // namespace deixis::app
