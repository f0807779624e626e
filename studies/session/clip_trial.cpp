#include "clip_trial.hpp"

#include <fmt/core.h>

namespace deixis::studies {

ClipTrial::ClipTrial(SessionCore& core, const TimelineItem& item)
    : TrialUnit(core, item), playback_(core.poser, core.idle), plays_left_(task_.plays) {
    const Stimulus& stimulus = trial_.stimuli.at(0);
    playback_.load(core.clipOf(stimulus), core.soundOf(stimulus, task_));
}

void ClipTrial::enter(const InputFrame& /*input*/, bool moved) {
    core_.standAlone();
    startLeadIn(core_.study.inter_trial_s + (moved ? orient_s : 0.0));
}

void ClipTrial::startLeadIn(double length_s) {
    phase_ = Phase::lead_in;
    playback_.start(length_s, core_.now.time_s);
    showState(PresentedState::waiting);
    gate_.close();
    draft_.paused_s = 0.0;
    core_.view.closePanel();
    core_.view.closeSign();
    core_.view.lookAtBalls(BallLook::waiting);
}

void ClipTrial::step(const InputFrame& input) {
    noteEarlySelect(input);
    switch (phase_) {
        case Phase::lead_in:
            if (!playback_.leadIn(core_.now.time_s)) break;
            phase_ = Phase::playing;
            showState(PresentedState::playing);
            stepPlaying(input);
            break;
        case Phase::playing:
            stepPlaying(input);
            break;
        case Phase::answering:
            if (gate_.isOpen())
                stepAnswer(input);
            else
                reopenAnswer(input);
            break;
    }
}

void ClipTrial::stepPlaying(const InputFrame& input) {
    const bool was_halfway = playback_.halfway();
    playback_.play(core_.now.time_s, core_.view.frame.number);
    core_.view.frame.sound = playback_.sound();
    if (!playback_.halfway() || was_halfway) return;
    showState(checked(0) ? PresentedState::check : PresentedState::pointing);
    if (checked(0)) showSign(input, false);
}

void ClipTrial::reopenAnswer(const InputFrame& input) {
    core_.view.closeSign();
    gate_.open(core_.view.frame.number);
    openAnswer(input);
}

void ClipTrial::shown(std::uint64_t frame, const Moment& at) {
    if (phase_ == Phase::answering) gate_.shown(frame, at.time_s);
    if (phase_ != Phase::playing) return;
    const Shown what = playback_.shown(frame, at);
    if (what == Shown::onset) tellOnset(at);
    if (what != Shown::end) return;
    core_.noteAt(at, NoteKind::motion_end, "");
    draft_.motion_end = at;
    ++draft_.plays[0];
    if (--plays_left_ > 0)
        startLeadIn(core_.study.inter_trial_s);
    else
        phase_ = Phase::answering;
}

void ClipTrial::tellOnset(const Moment& at) {
    begun_ = true;
    onset_known_ = true;
    draft_.onset = at;
    std::string detail;
    if (draft_.replays > 0)
        detail = fmt::format("replay {}", draft_.replays);
    else if (draft_.plays[0] > 0)
        detail = fmt::format("play {}", draft_.plays[0] + 1);
    core_.noteAt(at, NoteKind::stimulus_onset, std::move(detail));
}

/// A clip that was interrupted starts over in any case.
void ClipTrial::resume(const InputFrame& input, double away_s) {
    if (phase_ == Phase::lead_in) {
        startLeadIn(playback_.leadInLength_s());
        return;
    }
    ++draft_.pauses;
    if (startsOver()) forgetAnswer();
    const bool repeat = startsOver() && !committed();
    if (repeat) {
        core_.note(NoteKind::trial_repeated);
        plays_left_ = task_.plays;
    }
    if (repeat || phase_ == Phase::playing) {
        startLeadIn(core_.study.inter_trial_s);
    } else {
        if (!committed()) draft_.paused_s += away_s;
        reopenAnswer(input);
    }
}

bool ClipTrial::wantsPointer() const {
    return !done_ && phase_ == Phase::answering && gate_.isOpen();
}

void ClipTrial::noteEarlySelect(const InputFrame& input) {
    const bool before_answer = phase_ != Phase::answering || (!gate_.accepts() && !committed());
    if (!input.select || !before_answer || early_select_) return;
    early_select_ = true;
    core_.noteAt(core_.momentAt(selectTime(input)), NoteKind::early_select,
                 presentedStateName(core_.view.frame));
}

bool ClipTrial::select(const InputFrame& input) {
    if (!input.select || !gate_.accepts()) return false;
    // What was pressed before the open answer could be seen is no answer to it.
    if (gate_.admitsSelect(input)) return true;
    const double select_s = earliestSelectTime(input);
    core_.noteAt(core_.momentAt(select_s), NoteKind::early_select,
                 fmt::format("{:.3f} s before the answer was open", gate_.since_s() - select_s));
    return false;
}

std::optional<ButtonSpec> ClipTrial::replayButton() const {
    if (draft_.replays >= task_.max_replays) return std::nullopt;
    return ButtonSpec{core_.words()("show_again"), button_id::replay, ButtonRole::play};
}

void ClipTrial::replay() {
    ++draft_.replays;
    core_.note(NoteKind::replay);
    plays_left_ = 1;
    startLeadIn(core_.study.inter_trial_s);
}

}  // namespace deixis::studies
