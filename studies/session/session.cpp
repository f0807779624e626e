#include "studies/session/session.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "session_state.hpp"
#include "studies/study_file/stage_kind.hpp"
#include "studies/study_file/standing.hpp"

namespace deixis::studies {

namespace {

constexpr double patience_with_disk_s = 1.5;

/// Where nothing can be got wrong every answer is correct.
bool countsAsCorrect(const Trial& trial, const Response& response) {
    return !declarationOf(trial.kind).right_or_wrong || response.correct();
}

std::string practiceFailed(const Stage& practice) {
    return fmt::format("{}{}", practice_failed_reason, practice.name);
}

}  // namespace

SessionRunner::State::State(const Study& study_in, const StudyPlan& plan_in, const ClipSource& clips,
                            const motion::Skeleton& avatar, const motion::LocalPose& idle, Resume resume,
                            bool keyboard, std::string hint)
    : study(study_in),
      plan(plan_in),
      begun(resume.begun),
      core(study_in, clips, avatar, idle, keyboard, std::move(hint)),
      timeline(study_in, plan_in, resume.answered, resume.gap_s),
      checks(study_in, plan_in, resume),
      place_guard(study_in.headset.place_tolerance_m) {
    core.unfinished = std::move(resume.work);
}

void SessionRunner::State::begin(const InputFrame& input) {
    started = true;
    int units = 0;
    int done = 0;
    for (const Trial& trial : plan.trials) {
        if (trial.practice) continue;
        ++units;
        if (timeline.answered().count(trial.index) > 0) ++done;
    }
    core.note(NoteKind::session_start,
              timeline.answered().empty() ? "" : fmt::format("resumed after {} of {} answers", done, units));
    proceed(input);
}

/// On to what comes next.
void SessionRunner::State::proceed(const InputFrame& input) {
    reselect = false;
    core.trial_index = -1;
    if (!timeline.closingEarly())
        if (const Stage* failed = timeline.failedPractice()) {
            // What an earlier session left; else it was stored with the answer.
            core.events.push_back(Exclusion{practiceFailed(*failed), core.now});
            timeline.close(SessionOutcome::excluded);
        }
    item = timeline.next();
    if (item) {
        enter(input);
        return;
    }
    if (timeline.closing() == SessionOutcome::finished) core.note(NoteKind::finished);
    end(timeline.closing(), "finished");
}

void SessionRunner::State::enter(const InputFrame& input) {
    SessionView& view = core.view;
    if (item->stage != nullptr && item->stage->name != stage) {
        stage = item->stage->name;
        core.note(NoteKind::stage_start, timeline.begun(*item->stage) ? stage + ", continued" : stage);
    }
    view.frame.stage = item->stage != nullptr ? item->stage->name : "";
    view.frame.status = item->status;
    const bool moved = view.place(*item->layout);
    view.closePanel();
    view.closeSign();
    view.frame.balls.clear();
    view.frame.first_look.reset();
    view.frame.authoring.reset();
    core.share_done = timeline.share();
    if (item->trial != nullptr) core.trial_index = item->trial->index;
    unit = makeUnit(core, *item);
    unit->enter(input, moved);
    if (unit->done()) done_since_s = core.now.time_s;
    if (auto response = unit->takeResponse()) keepAnswer(std::move(*response));
}

void SessionRunner::State::stepUnit(const InputFrame& input) {
    const bool was_done = unit->done();
    if (!was_done) {
        unit->step(input);
        if (!unit->done()) return;
        done_since_s = core.now.time_s;
        if (auto response = unit->takeResponse())
            keepAnswer(std::move(*response));
        else
            timeline.read(item->page);
        if (item->trial == nullptr) proceed(input);
        return;
    }
    if (unit->stepDone(input, core.now.time_s - done_since_s) && input.answers_kept) proceed(input);
}

void SessionRunner::State::keepAnswer(Response response) {
    const Trial& trial = *item->trial;
    response.begun_before = begun.count(trial.index) > 0;
    response.viewer = viewerPlace(*item->layout, Standing::headset);  // the one that it has here
    const auto check = checks.score(response);
    if (check) response.check_passed = check->passed;
    checks.keep(response);
    timeline.answer(trial.index, countsAsCorrect(trial, response));
    last_answered = trial.index;
    if (core.unfinishedWork(trial.index) != nullptr) core.unfinished.reset();
    const bool failed = check && !check->passed;
    const CheckRule rule = failed ? checks.ruleFor(trial) : CheckRule::note;
    const Stage* failed_practice = trial.practice ? timeline.failedPractice() : nullptr;
    // It is kept together with the answer that it follows from: nothing can come in between.
    if (rule == CheckRule::exclude || rule == CheckRule::end)
        exclude(response, fmt::format("{}{}, trial {}", check_failed_reason, trial.stage, trial.index));
    if (failed_practice != nullptr) exclude(response, practiceFailed(*failed_practice));
    core.events.push_back(response);

    if (declarationOf(trial.kind).asks_consent && response.answers.front().value == 0.0)
        timeline.close(SessionOutcome::declined);
    if (failed) core.note(NoteKind::check_failed, check->what);
    if (rule == CheckRule::warn) timeline.warn();
    if (rule == CheckRule::end || failed_practice != nullptr) timeline.close(SessionOutcome::excluded);
    if (trial.practice) scorePractice(trial);
}

/// Tells how an attempt went once it is complete.
void SessionRunner::State::scorePractice(const Trial& trial) {
    const Stage& practised = *item->stage;
    if (!practised.practice || practised.practice->criterion <= 0.0) return;
    const std::vector<Attempt> attempts = practiceAttempts(plan, practised, timeline.answered());
    const Attempt& attempt = attempts.at(static_cast<std::size_t>(trial.attempt));
    if (!attempt.complete()) return;
    core.note(attempt.met(practised.practice->criterion) ? NoteKind::practice_met : NoteKind::practice_failed,
              fmt::format("{:.2f}", attempt.share()));
}

void SessionRunner::State::exclude(Response& response, std::string reason) {
    if (excluded) return;
    excluded = true;
    response.exclusion = std::move(reason);
}

void SessionRunner::State::end(SessionOutcome how, const char* status) {
    outcome = how;
    core.trial_index = -1;
    core.view.closePanel();
    core.view.closeSign();
    core.view.frame.balls.clear();
    core.view.frame.authoring.reset();
    core.view.frame.status = {status};
    core.view.show(PresentedState::over);
    core.view.frame.stage.clear();
}

/// Who has declined or been excluded and does not wait for the closing page has not quit.
void SessionRunner::State::endEarly(const std::string& reason) {
    core.note(NoteKind::quit, reason);
    end(timeline.closingEarly() ? timeline.closing() : SessionOutcome::quit, "ended early");
}

/// Nothing can be kept any more: the closing page tells the participant whom to ask.
void SessionRunner::State::stop(const InputFrame& input) {
    paused = false;
    timeline.close(SessionOutcome::quit);
    proceed(input);
}

void SessionRunner::State::step(const InputFrame& input) {
    SessionView& view = core.view;
    view.beginFrame();
    core.now = {input.time_s, input.utc_s};
    for (const StationNote& told : input.notes)
        core.noteAt(core.momentAt(told.time_s), told.kind, told.detail);
    if (over()) return;
    if (!started) begin(input);
    if (input.recording_failed && !over() && !timeline.closingEarly()) stop(input);
    for (const OperatorCommand& command : input.commands) carryOut(input, command);
    if (input.work && unit && !over()) unit->takeWork(*input.work);
    if (over()) {
        // An abort has ended it.
    } else if (input.quit) {
        endEarly(input.quit_reason.empty() ? "quit" : input.quit_reason);
    } else if (paused) {
        stepPaused(input);
    } else if (input.pause) {
        pause(input);
    } else {
        core.advanceAvatars();
        stepUnit(input);
    }
    guard(input);
    view.frame.scene_visible = !over() && !isFullPage(view.frame.state) && !unit->showsPage();
    // A pause freezes the avatar as it is; but it must be there, also where the first frame is paused.
    if (!paused || view.frame.avatar_joints.empty()) core.writeAvatars();
    core.placeSound();
}

void SessionRunner::State::guard(const InputFrame& input) {
    if (over()) {
        core.view.notice("");
        return;
    }
    const int trial_to_mark = paused ? -1 : core.trial_index;
    const auto keep = [this](const std::optional<GuardNote>& asked) {
        if (asked) core.note(asked->kind, asked->detail);
    };
    keep(place_guard.step(input.off_place_m, trial_to_mark));
    // While the station itself asks for the pause (nobody wears the headset, a menu is in front), no pointer
    // is expected.
    const bool wanted = (paused || unit->wantsPointer()) && !input.pause;
    keep(pointer_guard.step(input.pointer.has_value(), wanted, core.now.time_s, trial_to_mark));
    tell(unit->done() && !input.answers_kept && !paused &&
         core.now.time_s - done_since_s > patience_with_disk_s);
}

/// One sentence at a time: what the participant must do comes before what is only told.
void SessionRunner::State::tell(bool waits_for_disk) {
    if (waits_for_disk != disk_wait_shown) {
        disk_wait_shown = waits_for_disk;
        if (!paused) core.view.frame.status = item->status.with(waits_for_disk ? "waiting for the disk" : "");
    }
    const LanguageTable& words = study.words;
    if (waits_for_disk)
        core.view.notice(words("notice_saving"));
    else if (pointer_guard.lost())
        core.view.notice(words("notice_pointer"));
    else if (place_guard.off())
        core.view.notice(words("notice_place"));
    else
        core.view.notice(paused ? "" : unit->notice());
}

void SessionRunner::State::shown(const FrameReport& report) {
    if (!report.shown || report.number > core.view.frame.number || paused || over() || !unit) return;
    if (!unit->done()) unit->shown(report.number, core.momentAt(report.display_time_s));
}

SessionRunner::SessionRunner(const Study& study, const StudyPlan& plan, const ClipSource& clips,
                             const motion::Skeleton& avatar, const motion::LocalPose& idle_pose,
                             Resume resume, bool keyboard, std::string hint)
    : state_(std::make_unique<State>(study, plan, clips, avatar, idle_pose, std::move(resume), keyboard,
                                     std::move(hint))) {}

SessionRunner::~SessionRunner() = default;

SessionStep SessionRunner::step(const InputFrame& input) {
    state_->step(input);
    return {state_->core.view.frame, std::exchange(state_->core.events, {})};
}

std::vector<SessionEvent> SessionRunner::shown(const FrameReport& report) {
    state_->shown(report);
    return std::exchange(state_->core.events, {});
}

int SessionRunner::trialUnderWay() const {
    return state_->core.trial_index;
}

SessionOutcome SessionRunner::outcome() const {
    return state_->outcome;
}

SessionProgress SessionRunner::progress() const {
    return state_->progress();
}

std::string_view sessionOutcomeName(SessionOutcome outcome) {
    switch (outcome) {
        case SessionOutcome::running:
            return "running";
        case SessionOutcome::finished:
            return "finished";
        case SessionOutcome::quit:
            return "quit";
        case SessionOutcome::aborted:
            return "aborted";
        case SessionOutcome::declined:
            return "declined";
        case SessionOutcome::excluded:
            return "excluded";
    }
    return "";
}

namespace {

constexpr std::array<std::string_view, 3> response_status_names{"answered", "timed_out", "skipped"};

}  // namespace

std::string_view responseStatusName(ResponseStatus status) {
    return response_status_names.at(static_cast<std::size_t>(status));
}

ResponseStatus responseStatusNamed(std::string_view name) {
    const auto* const found = std::find(response_status_names.begin(), response_status_names.end(), name);
    if (found == response_status_names.end())
        throw std::invalid_argument("unknown response status: " + std::string(name));
    return static_cast<ResponseStatus>(found - response_status_names.begin());
}

}  // namespace deixis::studies
