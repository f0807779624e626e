// Which session states the program is told of: the runtime's, held back to the most that is allowed.
#pragma once

#include <openxr/openxr.h>

#include <deque>
#include <optional>

namespace deixis::conditions {

class SessionStates {
  public:
    /// The runtime has entered a state.
    void enter(XrSessionState real);
    /// The program may come no further than this: synchronized, visible or focused.
    void allow(XrSessionState max);
    /// Tells a state that the runtime knows nothing of, such as a pending loss.
    void tell(XrSessionState state);

    /// The next state that the program must be told of, which counts as told from then on; none: all is told.
    [[nodiscard]] std::optional<XrSessionState> next();
    /// What the program knows.
    [[nodiscard]] XrSessionState told() const { return told_; }
    [[nodiscard]] bool visible() const;
    [[nodiscard]] bool focused() const { return told_ == XR_SESSION_STATE_FOCUSED; }

  private:
    void walk(XrSessionState goal);

    XrSessionState real_ = XR_SESSION_STATE_UNKNOWN;
    XrSessionState max_ = XR_SESSION_STATE_FOCUSED;
    XrSessionState queued_ = XR_SESSION_STATE_UNKNOWN;  ///< told when all of the queue is
    XrSessionState told_ = XR_SESSION_STATE_UNKNOWN;
    std::deque<XrSessionState> queue_;
};

}  // namespace deixis::conditions
