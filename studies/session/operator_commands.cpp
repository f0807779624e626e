// What the experimenter does and sees while a session runs.
#include <fmt/core.h>

#include <string>

#include "session_state.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

namespace {

/// The conditions of a trial, in words.
std::string conditionsOf(const Trial& trial) {
    std::string text = fmt::format("{}: trial {}", trial.stage, trial.index);
    for (const Stimulus& stimulus : trial.stimuli)
        text += fmt::format(", {} {}", stimulus.system, stimulus.item);
    for (const std::string* level : {&trial.layout, &trial.distance})
        if (!level->empty()) text += ", " + *level;
    if (!trial.check) return text;
    text += fmt::format(", check {}", checkKindName(trial.check->kind));
    if (trial.check->kind == CheckKind::number) text += fmt::format(" {}", trial.check->expected);
    if (trial.check->kind == CheckKind::repeat) text += fmt::format(" of trial {}", trial.check->of_trial);
    return text;
}

}  // namespace

void SessionRunner::State::carryOut(const InputFrame& input, const OperatorCommand& command) {
    if (over()) return;
    switch (command.action) {
        case OperatorAction::repeat_last:
            repeatLast(input, command.text);
            break;
        case OperatorAction::skip:
            skip(input, command.text);
            break;
        case OperatorAction::abort:
            core.note(NoteKind::operator_abort, command.text);
            end(SessionOutcome::aborted, "aborted");
            break;
        case OperatorAction::note:
            core.note(NoteKind::operator_note, command.text);
            break;
    }
}

/// Right away, unless a clip of the next trial has been seen: then after it.
void SessionRunner::State::repeatLast(const InputFrame& input, const std::string& reason) {
    const bool consent =
        last_answered &&
        declarationOf(plan.trials[static_cast<std::size_t>(*last_answered)].kind).asks_consent;
    if (!last_answered || consent || timeline.closingEarly()) {
        core.note(NoteKind::operator_repeat, "nothing to repeat");
        return;
    }
    core.noteAt(core.now, NoteKind::operator_repeat, reason);
    const int again = *last_answered;
    core.events.emplace_back(Superseded{again, reason, core.now});
    timeline.supersede(again);
    checks.forget(again);
    last_answered.reset();
    if (unit->done() || unit->begun()) return;  // it is left first
    if (paused)
        reselect = true;
    else
        proceed(input);
}

void SessionRunner::State::skip(const InputFrame& input, const std::string& reason) {
    if (unit->done() || reselect || !unit->skip(input, reason)) {
        core.note(NoteKind::operator_skip, "nothing to skip");
        return;
    }
    core.note(NoteKind::operator_skip, reason);
    done_since_s = core.now.time_s;
    if (auto response = unit->takeResponse()) keepAnswer(std::move(*response));
    if (paused) openPausePanel(input);
}

SessionProgress SessionRunner::State::progress() const {
    SessionProgress progress;
    progress.stages = timeline.progress(core.view.frame.stage);
    progress.checks_passed = checks.passed();
    progress.checks_failed = checks.failed();
    if (item && item->trial != nullptr && !over()) progress.trial = conditionsOf(*item->trial);
    return progress;
}

}  // namespace deixis::studies
