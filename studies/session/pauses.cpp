#include <fmt/core.h>

#include <string>

#include "session_state.hpp"

namespace deixis::studies {

namespace {

struct PauseWords {
    const char* title;
    const char* text;
};

/// Keys of what the participant reads, by the reason of the pause.
PauseWords pauseWords(PauseReason reason) {
    switch (reason) {
        case PauseReason::headset_taken_off:
            return {"paused_headset_title", "paused_headset_text"};
        case PauseReason::tracking_lost:
            return {"paused_tracking_title", "paused_tracking_text"};
        case PauseReason::focus_lost:
            return {"paused_title", "paused_focus_text"};
        case PauseReason::experimenter:
            return {"paused_title", "paused_operator_text"};
        default:
            return {"paused_title", "paused_text"};
    }
}

}  // namespace

void SessionRunner::State::pause(const InputFrame& input) {
    const std::string reason(pauseReasonName(input.pause_reason));
    SessionView& view = core.view;
    core.note(NoteKind::pause, reason);
    paused = true;
    view.show(PresentedState::paused);
    paused_since_s = core.now.time_s;
    view.frame.ray.reset();
    view.closeSign();
    view.lookAtBalls(BallLook::waiting);
    view.frame.status = item->status.with("paused: " + reason);
    pause_reason = input.pause_reason;
    openPausePanel(input);
}

void SessionRunner::State::openPausePanel(const InputFrame& input) {
    const LanguageTable& words = study.words;
    const PauseWords keys = pauseWords(pause_reason);
    core.openPanel(messagePanel(words(keys.title), words(keys.text) + " " + words("paused_end_hint"), "",
                                {{words("resume"), button_id::resume, ButtonRole::go_on},
                                 {words("end_session"), button_id::end_session, ButtonRole::leave}},
                                -1.0, core.hint),
                   input, messagePose);
}

// One press must not end a study.
void SessionRunner::State::askWhetherToEnd(const InputFrame& input) {
    core.openPanel(core.endConfirmation(study.words("end_text")), input, messagePose);
}

void SessionRunner::State::stepPaused(const InputFrame& input) {
    if (input.resume) {
        resume(input);
        return;
    }
    const Aim met = core.view.aim(input.pointer, input.stage_from_head, false);
    if (!core.settled()) return;
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
    const double length_s = core.now.time_s - paused_since_s;
    core.note(NoteKind::resume, fmt::format("after {:.3f} s", length_s));
    paused = false;
    core.view.frame.status = item->status;
    core.view.closePanel();
    if (reselect) {
        proceed(input);
    } else if (unit->done()) {
        done_since_s += length_s;
        unit->resumeDone(input);
        stepUnit(input);
    } else {
        unit->resume(input, length_s);
    }
}

}  // namespace deixis::studies
