#include <fmt/core.h>

#include <string>

#include "session_state.hpp"

namespace deixis::studies {

void SessionRunner::State::pause(const InputFrame& input) {
    const std::string reason = input.pause_reason.empty() ? "paused" : input.pause_reason;
    note("pause", reason);
    paused = true;
    view.frame.state = "paused";
    paused_since_s = now.time_s;
    view.frame.ray.reset();
    view.lookAtBalls(BallLook::waiting);
    view.frame.status = item().status + ", paused: " + reason;
    openPanel(
        messagePanel("Paused",
                     "Go on when you are ready. If you end the session here, the answers given so far are "
                     "kept and the rest can be done later.",
                     "", {{"Resume", button_id::resume}, {"End session", button_id::end_session}}, -1.0),
        input, messagePose);
}

void SessionRunner::State::stepPaused(const InputFrame& input) {
    const Aim met = view.aim(input.pointer, false);
    if (!settled()) return;
    if (input.select && met.button == button_id::end_session)
        endEarly("ended on the pause panel");
    else if (input.confirm || (input.select && met.button == button_id::resume))
        resume(input);
}

void SessionRunner::State::resume(const InputFrame& input) {
    const double length_s = now.time_s - paused_since_s;
    note("resume", fmt::format("after {:.3f} s", length_s));
    paused = false;
    view.frame.status = item().status;
    view.closePanel();
    switch (phase) {
        case Phase::page:
            poser.blendTo(idle, now.time_s);
            openPage(input);
            break;
        case Phase::lead_in:
            startLeadIn(playback.leadInLength_s());
            break;
        case Phase::playing:
            ++pauses;
            startLeadIn(study.inter_trial_s);
            break;
        case Phase::answering:
            ++pauses;
            paused_s += length_s;
            openAnswer(input);
            break;
        case Phase::confirmed:
            leave(input);
            break;
        case Phase::over:
            break;
    }
}

}  // namespace deixis::studies
