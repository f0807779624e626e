// The OpenXR session's life (OpenXR 1.0, 9.3 "Session Lifecycle"), as plain logic: what each state asks of
// the program.
#pragma once

#include <openxr/openxr.h>

#include <string_view>

#include "app/operator/operator_words.hpp"

namespace deixis::app {

/// What is to be done now that a state was entered.
enum class XrDuty : unsigned char {
    none,
    begin_session,  ///< ready: xrBeginSession
    end_session,    ///< stopping: xrEndSession
    leave,          ///< exiting: the person or the runtime ended the program's session
    lost,           ///< loss pending: the session is gone, it may be made again later
};

class XrSessionLifecycle {
  public:
    /// Enters a state, as the runtime's event said.
    XrDuty enter(XrSessionState state);

    [[nodiscard]] XrSessionState state() const { return state_; }
    /// Between xrBeginSession and xrEndSession: frames must be waited for, begun and ended.
    [[nodiscard]] bool running() const { return running_; }
    /// The person sees the pictures (visible or focused).
    [[nodiscard]] bool visible() const;
    /// And the program gets input.
    [[nodiscard]] bool focused() const { return state_ == XR_SESSION_STATE_FOCUSED; }

  private:
    XrSessionState state_ = XR_SESSION_STATE_UNKNOWN;
    bool running_ = false;
};

/// "idle", "ready", "synchronized", "visible", "focused", "stopping", "loss pending", "exiting".
[[nodiscard]] std::string_view nameOf(XrSessionState state);

/// The same for the operator; in use only with focus.
[[nodiscard]] DeviceWords wordsOf(XrSessionState state);

}  // namespace deixis::app
