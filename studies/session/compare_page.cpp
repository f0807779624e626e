#include "compare_page.hpp"

#include <fmt/core.h>

namespace deixis::studies {

void ComparePage::enter(const InputFrame& input, bool /*moved*/) {
    core_.poser.blendTo(core_.idle, core_.now.time_s);
    core_.right_poser.blendTo(core_.idle, core_.now.time_s);
    for (std::size_t i = 0; i < trial_.stimuli.size(); ++i) {
        playbacks_.emplace_back(poserOf(i), core_.idle);
        playbacks_.back().load(core_.clipOf(trial_.stimuli[i]), core_.soundOf(trial_.stimuli[i], task_));
    }
    openBoard(input);
}

void ComparePage::openBoard(const InputFrame& input) {
    if (quiet()) showState(openState());
    core_.openPanel(board(), input, benchPose);
    changed_ = false;
    core_.view.aim(input.pointer, input.stage_from_head, false);
}

bool ComparePage::allSeen() const {
    for (std::size_t i = 0; i < count(); ++i)
        if (!seen(i)) return false;
    return true;
}

StimulusView ComparePage::viewOf(std::size_t i) const {
    StimulusView view;
    view.state = playing_ == i         ? PlayState::playing
                 : draft_.plays[i] > 0 ? PlayState::played
                                       : PlayState::unplayed;
    view.can_play = quiet();
    view.can_rate = seen(i);
    return view;
}

void ComparePage::step(const InputFrame& input) {
    if (beyondBoard()) {
        stepBeyond(input);
        return;
    }
    if (playing_) stepPlaying(input);
    const Aim met = core_.view.aim(input.pointer, input.stage_from_head, false);
    if (core_.settled()) {
        const int pressed = input.select ? met.button - button_id::first_play : -1;
        if (quiet() && pressed >= 0 && pressed < static_cast<int>(count()))
            play(static_cast<std::size_t>(pressed));
        else if (stepBoard(input, met))
            changed_ = true;
    }
    if (done_ || beyondBoard()) return;
    settleGate();
    if (changed_) core_.view.updatePanel(board());
    changed_ = false;
}

/// The answer opens with all seen and set, and closes while a clip plays.
void ComparePage::settleGate() {
    const bool open = quiet() && allSeen() && complete_enough();
    if (open == gate_.isOpen()) return;
    if (open)
        gate_.open(core_.view.frame.number);
    else
        gate_.close();
    changed_ = true;
}

void ComparePage::play(std::size_t i) {
    if (draft_.plays[i] >= task_.plays) {
        ++draft_.replays;
        core_.note(NoteKind::replay, fmt::format("stimulus {}", i));
    }
    playing_ = i;
    leading_in_ = true;
    draft_.paused_s = 0.0;
    changed_ = true;
    showState(PresentedState::waiting);
    playbacks_[i].start(core_.study.inter_trial_s, core_.now.time_s);
}

void ComparePage::stepPlaying(const InputFrame& input) {
    ClipPlayback& playback = playbacks_[*playing_];
    if (leading_in_) {
        if (!playback.leadIn(core_.now.time_s)) return;
        leading_in_ = false;
        showState(PresentedState::playing);
    }
    const bool was_halfway = playback.halfway();
    playback.play(core_.now.time_s, core_.view.frame.number);
    const bool on_right = &poserOf(*playing_) == &core_.right_poser;
    core_.view.frame.sound = playback.sound();
    if (core_.view.frame.sound) core_.view.frame.sound->on_right = on_right;
    if (!playback.halfway() || was_halfway) return;
    const bool number = checked(static_cast<int>(*playing_));
    showState(number ? PresentedState::check : PresentedState::pointing);
    if (number) showSign(input, on_right);
}

void ComparePage::shown(std::uint64_t frame, const Moment& at) {
    gate_.shown(frame, at.time_s);
    if (!playing_ || leading_in_) return;
    const std::size_t i = *playing_;
    const Shown what = playbacks_[i].shown(frame, at);
    if (what == Shown::onset) {
        begun_ = true;
        onset_known_ = true;
        draft_.onset = at;
        const int before = draft_.plays[i];
        core_.noteAt(
            at, NoteKind::stimulus_onset,
            before > 0 ? fmt::format("stimulus {}, play {}", i, before + 1) : fmt::format("stimulus {}", i));
    }
    if (what != Shown::end) return;
    core_.noteAt(at, NoteKind::motion_end, fmt::format("stimulus {}", i));
    draft_.motion_end = at;
    ++draft_.plays[i];
    playing_.reset();
    changed_ = true;
    core_.view.closeSign();
    showState(openState());
}

/// As if nothing had been shown yet.
void ComparePage::startOver() {
    if (begun_) core_.note(NoteKind::trial_repeated);
    draft_.plays.assign(count(), 0);
    draft_.paused_s = 0.0;
    core_.poser.blendTo(core_.idle, core_.now.time_s);
    core_.right_poser.blendTo(core_.idle, core_.now.time_s);
    playing_.reset();
    leading_in_ = false;
}

/// What was set stays, and a clip that was interrupted starts over; or the whole page does.
void ComparePage::resume(const InputFrame& input, double away_s) {
    ++draft_.pauses;
    if (startsOver()) {
        forgetAnswer();
        if (!beyondBoard()) startOver();
    }
    if (beyondBoard()) {
        resumeBeyond(input);
        return;
    }
    core_.view.closeSign();
    if (playing_) {
        leading_in_ = true;
        playbacks_[*playing_].start(core_.study.inter_trial_s, core_.now.time_s);
        showState(PresentedState::waiting);
    } else if (!startsOver()) {
        draft_.paused_s += away_s;
    }
    gate_.close();
    settleGate();
    openBoard(input);
}

bool ComparePage::stepDone(const InputFrame& /*input*/, double since_s) {
    return draft_.status == ResponseStatus::skipped || since_s >= confirm_s;
}

void ComparePage::resumeDone(const InputFrame& /*input*/) {
    showState(PresentedState::rated);
}

}  // namespace deixis::studies
