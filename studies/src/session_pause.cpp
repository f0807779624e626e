#include <fmt/core.h>

#include <string>

#include "session_state.hpp"

namespace deixis::studies {

namespace {

struct PauseText {
    std::string title;
    std::string body;
};

/// What the participant reads, by the reason of the pause.
PauseText pauseText(const std::string& reason) {
    if (reason == "headset taken off")
        return {"Welcome back",
                "All has waited for you. Go on when the headset sits well and you are ready."};
    if (reason == "tracking lost")
        return {
            "One moment",
            "The headset has lost sight of the room. Stay where you are and look around slowly; go on when "
            "the room stands still again."};
    if (reason == "focus lost")
        return {"Paused", "Something else has come to the front. Go on when you are ready."};
    if (reason == "operator")
        return {"Paused",
                "The experimenter has paused the session. Please wait until you are asked to go on."};
    return {"Paused", "Go on when you are ready."};
}

}  // namespace

void SessionRunner::State::pause(const InputFrame& input) {
    const std::string reason = input.pause_reason.empty() ? "paused" : input.pause_reason;
    note("pause", reason);
    paused = true;
    view.frame.state = "paused";
    paused_since_s = now.time_s;
    view.frame.ray.reset();
    view.lookAtBalls(BallLook::waiting);
    view.frame.status = item().status + ", paused: " + reason;
    pause_reason = reason;
    openPausePanel(input);
}

void SessionRunner::State::openPausePanel(const InputFrame& input) {
    const PauseText text = pauseText(pause_reason);
    openPanel(
        messagePanel(text.title,
                     text.body + " If you end the session here, the answers given so far are kept and "
                                 "the rest can be done later.",
                     "", {{"Resume", button_id::resume}, {"End session", button_id::end_session}}, -1.0),
        input, messagePose);
}

// One press must not end a study.
void SessionRunner::State::askWhetherToEnd(const InputFrame& input) {
    openPanel(
        messagePanel("End the session?",
                     "The answers given so far are kept. The rest can be done later: the session then "
                     "goes on where it stopped.",
                     "", {{"Go back", button_id::back}, {"Yes, end it", button_id::end_for_good}}, -1.0),
        input, messagePose);
}

void SessionRunner::State::stepPaused(const InputFrame& input) {
    const Aim met = view.aim(input.pointer, input.stage_from_head, false);
    if (!settled()) return;
    const int pressed = input.select ? met.button : 0;
    if (pressed == button_id::end_session)
        askWhetherToEnd(input);
    else if (pressed == button_id::end_for_good)
        endEarly("ended on the pause panel");
    else if (pressed == button_id::back)
        openPausePanel(input);
    else if (input.confirm || pressed == button_id::resume)
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
        case Phase::answering:
            ++pauses;
            resumeTrial(input, length_s);
            break;
        case Phase::confirmed:
            showState(game() ? "chosen" : "rated");
            stepConfirmed(input);
            break;
        case Phase::over:
            break;
    }
}

/// A clip that was interrupted starts over in any case.
void SessionRunner::State::resumeTrial(const InputFrame& input, double away_s) {
    const bool repeat = study.after_interruption == AfterInterruption::repeat;
    if (repeat) note("trial_repeated");
    if (repeat || phase == Phase::playing) {
        startLeadIn(study.inter_trial_s);
    } else {
        paused_s += away_s;
        openAnswer(input);
    }
}

}  // namespace deixis::studies
