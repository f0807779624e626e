#include "timed_trial.hpp"

namespace deixis::studies {

TimedTrial::TimedTrial(SessionCore& core, const TimelineItem& item, double feedback_s)
    : ClipTrial(core, item), limit_(task_.time_limit_s), feedback_s_(feedback_s) {}

bool TimedTrial::stepDone(const InputFrame& /*input*/, double since_s) {
    if (draft_.status == ResponseStatus::skipped) return true;
    if (!stage_.feedback) return since_s >= (late() ? AnswerLimit::told_s : confirm_s);
    const double answer_shown_s = late() ? 0.0 : confirm_s;
    if (since_s < answer_shown_s) return false;
    if (!revealed_) {
        revealed_ = true;
        core_.note(NoteKind::feedback);
        showDone();
    }
    return since_s >= answer_shown_s + feedback_s_;
}

void TimedTrial::resumeDone(const InputFrame& /*input*/) {
    if (draft_.status != ResponseStatus::skipped) showDone();
}

void TimedTrial::watchTime(const InputFrame& input) {
    if (!limit_.passed(taken_s(core_.now.time_s))) return;
    give(input, draft_.motion_end.time_s + draft_.paused_s + task_.time_limit_s, "");
    draft_.status = ResponseStatus::timed_out;
    core_.view.closePanel();
    finish();
}

void TimedTrial::finish() {
    core_.view.frame.ray.reset();
    complete();
    showDone();
}

void TimedTrial::beginAiming() {
    aiming_ = false;
    showState(PresentedState::choosing);
}

Aim TimedTrial::aimAtBalls(const InputFrame& input) {
    const Aim met = core_.view.aim(input.pointer, input.stage_from_head, true);
    if ((met.ball >= 0) != aiming_) {
        aiming_ = met.ball >= 0;
        showState(aiming_ ? PresentedState::aiming : PresentedState::choosing);
    }
    return met;
}

}  // namespace deixis::studies
