#include "xr_session_lifecycle.hpp"

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

std::string_view nameOf(XrSessionState state) {
    switch (state) {
        case XR_SESSION_STATE_IDLE:
            return "idle";
        case XR_SESSION_STATE_READY:
            return "ready";
        case XR_SESSION_STATE_SYNCHRONIZED:
            return "synchronized";
        case XR_SESSION_STATE_VISIBLE:
            return "visible";
        case XR_SESSION_STATE_FOCUSED:
            return "focused";
        case XR_SESSION_STATE_STOPPING:
            return "stopping";
        case XR_SESSION_STATE_LOSS_PENDING:
            return "loss pending";
        case XR_SESSION_STATE_EXITING:
            return "exiting";
        default:
            return "unknown";
    }
}

}  // namespace deixis::app
