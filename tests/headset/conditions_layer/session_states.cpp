#include "session_states.hpp"

#include <algorithm>

namespace deixis::conditions {

namespace {

// Between these three a running session goes up and down, one step at a time; their values are in order.
bool runs(XrSessionState state) {
    return state >= XR_SESSION_STATE_SYNCHRONIZED && state <= XR_SESSION_STATE_FOCUSED;
}

}  // namespace

void SessionStates::tell(XrSessionState state) {
    queue_.push_back(state);
    queued_ = state;
}

void SessionStates::walk(XrSessionState goal) {
    while (queued_ != goal)
        tell(static_cast<XrSessionState>(static_cast<int>(queued_) + (queued_ < goal ? 1 : -1)));
}

void SessionStates::enter(XrSessionState real) {
    real_ = real;
    if (!runs(real)) {
        // A session stops from synchronized only.
        if (runs(queued_) && real == XR_SESSION_STATE_STOPPING) walk(XR_SESSION_STATE_SYNCHRONIZED);
        tell(real);
        return;
    }
    if (!runs(queued_)) tell(XR_SESSION_STATE_SYNCHRONIZED);
    walk(std::min(real_, max_));
}

void SessionStates::allow(XrSessionState max) {
    max_ = max;
    if (runs(real_) && runs(queued_)) walk(std::min(real_, max_));
}

std::optional<XrSessionState> SessionStates::next() {
    if (queue_.empty()) return std::nullopt;
    told_ = queue_.front();
    queue_.pop_front();
    return told_;
}

bool SessionStates::visible() const {
    return told_ == XR_SESSION_STATE_VISIBLE || told_ == XR_SESSION_STATE_FOCUSED;
}

}  // namespace deixis::conditions
