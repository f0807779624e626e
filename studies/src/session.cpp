#include "studies/session.hpp"

#include <fmt/core.h>

#include <utility>

#include "session_state.hpp"

namespace deixis::studies {

namespace {

constexpr double patience_with_disk_s = 1.5;
constexpr double settle_s = 0.4;  ///< a page takes no input earlier: a double click must not skip it

}  // namespace

SessionRunner::State::State(const Study& study_in, const StudyPlan& plan, const ClipSource& clips_in,
                            const motion::Skeleton& avatar_in, const motion::LocalPose& idle_in,
                            const std::set<int>& answered)
    : study(study_in),
      clips(clips_in),
      avatar(avatar_in),
      idle(idle_in),
      agenda(buildAgenda(study_in, plan, answered)),
      poser(avatar_in, idle_in),
      place_guard(study_in.headset.place_tolerance_m),
      playback(poser, idle_in) {
    for (const Trial& trial : plan.trials) {
        if (trial.practice) continue;
        ++scored;
        if (answered.count(trial.index) > 0) ++done;
    }
}

int SessionRunner::State::trialIndex() const {
    return started && phase != Phase::over && item().trial != nullptr ? trial().index : -1;
}

bool SessionRunner::State::settled() const {
    return now.time_s - panel_since_s >= settle_s;
}

Moment SessionRunner::State::momentAt(double time_s) const {
    return {time_s, now.utc_s + time_s - now.time_s};
}

bool SessionRunner::State::somethingToAimAt() const {
    return paused || phase == Phase::page || (phase == Phase::answering && answer_open);
}

void SessionRunner::State::note(const char* kind, std::string detail) {
    noteAt(now, kind, std::move(detail));
}

void SessionRunner::State::noteAt(const Moment& at, std::string kind, std::string detail) {
    events.push_back(Note{std::move(kind), trialIndex(), at, std::move(detail)});
}

void SessionRunner::State::showState(const char* base) {
    view.frame.state = base;
    if (item().trial != nullptr && game()) view.frame.state += "-" + trial().layout;
}

void SessionRunner::State::openPanel(Panel panel, const InputFrame& input, PanelPlace place) {
    const double head_m = input.stage_from_head.position.y;
    const bool plausible = head_m > 0.9 && head_m < 2.2;
    view.openPanel(std::move(panel), plausible ? head_m : study.eye_height_m, place);
    panel_since_s = now.time_s;
}

void SessionRunner::State::begin(const InputFrame& input) {
    started = true;
    note("session_start", done > 0 ? fmt::format("resumed after {} of {} answers", done, scored) : "");
    enter(input);
}

void SessionRunner::State::enter(const InputFrame& input) {
    if (!item().starts_stage.empty()) note("stage_start", item().starts_stage);
    view.frame.status = item().status;
    const bool moved = view.place(*item().layout);
    view.frame.balls.clear();
    if (item().trial == nullptr)
        enterPage(input);
    else
        enterTrial(moved);
}

void SessionRunner::State::enterPage(const InputFrame& input) {
    phase = Phase::page;
    poser.blendTo(idle, now.time_s);
    if (item().page.kind == PageKind::rest) note("break_start");
    openPage(input);
}

void SessionRunner::State::openPage(const InputFrame& input) {
    const AgendaPage& page = item().page;
    view.frame.state = pageName(page.kind);
    const double progress = scored > 0 ? static_cast<double>(done) / scored : 1.0;
    openPanel(messagePanel(page.title, page.body, page.emphasis, {{page.button, button_id::go_on}}, progress),
              input, messagePose);
}

void SessionRunner::State::leave(const InputFrame& input) {
    if (item().trial == nullptr && item().page.kind != PageKind::goodbye) {
        if (item().page.kind == PageKind::rest)
            note("break_end");
        else
            note("instructions_read", std::string(pageName(item().page.kind)));
    }
    if (position + 1 == agenda.size()) {
        note("finished");
        finished = true;
        end("finished");
        return;
    }
    ++position;
    enter(input);
}

void SessionRunner::State::end(const char* status) {
    phase = Phase::over;
    view.closePanel();
    view.frame.balls.clear();
    view.frame.status = status;
    view.frame.state = "over";
}

void SessionRunner::State::endEarly(const std::string& reason) {
    note("quit", reason);
    quit = true;
    end("ended early");
}

void SessionRunner::State::step(const InputFrame& input) {
    view.beginFrame();
    now = {input.time_s, input.utc_s};
    for (const StationNote& told : input.notes) noteAt(momentAt(told.time_s), told.kind, told.detail);
    if (phase == Phase::over) return;
    if (!started) begin(input);
    if (input.quit) {
        endEarly(input.quit_reason.empty() ? "quit" : input.quit_reason);
    } else if (paused) {
        stepPaused(input);
    } else if (input.pause) {
        pause(input);
    } else {
        stepPhase(input);
    }
    guard(input);
    // A pause freezes the avatar as it is; but it must be there, also where the first frame is paused.
    if (!paused || view.frame.avatar_joints.empty()) poser.write(view.frame.avatar_joints);
}

void SessionRunner::State::stepPhase(const InputFrame& input) {
    noteEarlySelect(input);
    switch (phase) {
        case Phase::page: {
            poser.advance(now.time_s);
            const Aim met = view.aim(input.pointer, input.stage_from_head, false);
            if (settled() && (input.confirm || (input.select && met.button == button_id::go_on)))
                leave(input);
            break;
        }
        case Phase::lead_in:
            stepLeadIn();
            break;
        case Phase::playing:
            stepPlaying();
            break;
        case Phase::answering:
            stepAnswering(input);
            break;
        case Phase::confirmed:
            stepConfirmed(input);
            break;
        case Phase::over:
            break;
    }
}

void SessionRunner::State::guard(const InputFrame& input) {
    if (phase == Phase::over) {
        view.notice("");
        return;
    }
    const int trial_to_mark = paused ? -1 : trialIndex();
    const auto keep = [this](const std::optional<GuardNote>& asked) {
        if (asked) note(asked->kind, asked->detail);
    };
    keep(place_guard.step(input.off_place_m, trial_to_mark));
    // While the station itself asks for the pause (nobody wears the headset, a menu is in front), no pointer
    // is expected.
    const bool wanted = somethingToAimAt() && !input.pause;
    keep(pointer_guard.step(input.pointer.has_value(), wanted, now.time_s, trial_to_mark));
    const bool waits_for_disk = phase == Phase::confirmed && !input.answers_kept && !paused &&
                                now.time_s - confirmed_since_s > patience_with_disk_s;
    if (waits_for_disk != told_of_disk) {
        told_of_disk = waits_for_disk;
        if (!paused) view.frame.status = item().status + (waits_for_disk ? ", waiting for the disk" : "");
    }
    if (waits_for_disk)
        view.notice("One moment, please: your answer is being saved.");
    else if (pointer_guard.lost())
        view.notice("Pick up a controller and press any button.");
    else if (place_guard.off())
        view.notice("Please step back onto your place.");
    else
        view.notice("");
}

void SessionRunner::State::shown(const FrameReport& report) {
    if (!report.shown || report.number > view.frame.number || paused) return;
    const Moment at = momentAt(report.display_time_s);
    if (phase == Phase::playing) {
        const Shown first = playback.shown(report.number, at);
        if (first == Shown::onset)
            noteAt(at, "stimulus_onset", replays > 0 ? fmt::format("replay {}", replays) : "");
        if (first == Shown::end) {
            noteAt(at, "motion_end", "");
            phase = Phase::answering;
        }
    } else if (phase == Phase::answering && answer_open && !answer_shown && report.number >= answer_frame) {
        answer_shown = true;
        answer_shown_s = at.time_s;
    }
}

SessionRunner::SessionRunner(const Study& study, const StudyPlan& plan, const ClipSource& clips,
                             const motion::Skeleton& avatar, const motion::LocalPose& idle_pose,
                             std::set<int> answered)
    : state_(std::make_unique<State>(study, plan, clips, avatar, idle_pose, answered)) {}

SessionRunner::~SessionRunner() = default;

SessionStep SessionRunner::step(const InputFrame& input) {
    state_->step(input);
    return {state_->view.frame, std::exchange(state_->events, {})};
}

std::vector<SessionEvent> SessionRunner::shown(const FrameReport& report) {
    state_->shown(report);
    return std::exchange(state_->events, {});
}

int SessionRunner::trialUnderWay() const {
    return state_->trialIndex();
}

bool SessionRunner::finished() const {
    return state_->finished;
}

bool SessionRunner::quit() const {
    return state_->quit;
}

}  // namespace deixis::studies
