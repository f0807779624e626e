#include "studies/session.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "session_agenda.hpp"
#include "session_avatar.hpp"
#include "session_playback.hpp"
#include "session_view.hpp"

namespace deixis::studies {

namespace {

constexpr double orient_s = 0.6;    ///< added to the pause before a trial where the participant was moved
constexpr double confirm_s = 0.35;  ///< how long the answer given is shown
constexpr double settle_s = 0.4;    ///< a page takes no input earlier: a double click must not skip it

enum class Phase : unsigned char {
    page,
    lead_in,    ///< the pause before a clip
    playing,    ///< from the clip's first frame until its last pose has been shown
    answering,  ///< the answer is open
    confirmed,  ///< the answer given is shown for a moment
    over
};

}  // namespace

struct SessionRunner::State {
    State(const Study& study_in, const StudyPlan& plan, const ClipSource& clips_in,
          const motion::Skeleton& avatar_in, const motion::LocalPose& idle_in, const std::set<int>& answered)
        : study(study_in),
          clips(clips_in),
          avatar(avatar_in),
          idle(idle_in),
          agenda(buildAgenda(study_in, plan, answered)),
          poser(avatar_in, idle_in),
          playback(poser, idle_in) {
        for (const Trial& trial : plan.trials) {
            if (trial.practice) continue;
            ++scored;
            if (answered.count(trial.index) > 0) ++done;
        }
    }

    const Study& study;
    const ClipSource& clips;
    const motion::Skeleton& avatar;
    const motion::LocalPose& idle;
    std::vector<AgendaItem> agenda;
    AvatarPoser poser;  ///< moved by `playback` too
    SessionView view;
    std::vector<SessionEvent> events;

    Phase phase = Phase::page;
    std::size_t position = 0;
    int scored = 0;
    int done = 0;
    bool started = false;
    bool finished = false;
    bool quit = false;
    bool paused = false;
    double paused_since_s = 0.0;
    double panel_since_s = 0.0;
    double confirmed_since_s = 0.0;
    Moment now{};  ///< of the input last stepped to

    // The trial under way.
    ClipPlayback playback;
    std::uint64_t answer_frame = 0;  ///< the first in which the answer was open
    bool answer_open = false;        ///< balls white or panel there, in a frame
    bool answer_shown = false;       ///< and that frame was shown
    bool aiming = false;             ///< the ray is on a ball
    double paused_s = 0.0;
    int pauses = 0;
    int replays = 0;

    [[nodiscard]] const AgendaItem& item() const { return agenda[position]; }
    [[nodiscard]] const Trial& trial() const { return *item().trial; }
    [[nodiscard]] bool game() const { return trial().stage == StageKind::game; }

    void note(const char* kind, std::string detail = {}) { noteAt(now, kind, std::move(detail)); }
    void noteAt(const Moment& at, const char* kind, std::string detail) {
        const bool in_trial = position < agenda.size() && item().trial != nullptr;
        events.push_back(Note{kind, in_trial ? trial().index : -1, at, std::move(detail)});
    }

    /// In the game the place is part of the state's name.
    void showState(const char* base) {
        view.frame.state = base;
        if (item().trial != nullptr && game()) view.frame.state += "-" + trial().layout;
    }

    [[nodiscard]] double eyeHeight(const InputFrame& input) const {
        const double head_m = input.stage_from_head.position.y;
        return head_m > 0.9 && head_m < 2.2 ? head_m : study.eye_height_m;
    }

    void openPanel(Panel panel, const InputFrame& input, PanelPlace place) {
        view.openPanel(std::move(panel), eyeHeight(input), place);
        panel_since_s = now.time_s;
    }

    [[nodiscard]] bool settled() const { return now.time_s - panel_since_s >= settle_s; }

    // From item to item.

    void begin(const InputFrame& input) {
        started = true;
        note("session_start", done > 0 ? fmt::format("resumed after {} of {} answers", done, scored) : "");
        enter(input);
    }

    void enter(const InputFrame& input) {
        if (!item().starts_stage.empty()) note("stage_start", item().starts_stage);
        view.frame.status = item().status;
        const bool moved = view.place(*item().layout);
        view.frame.balls.clear();
        if (item().trial == nullptr)
            enterPage(input);
        else
            enterTrial(moved);
    }

    void enterPage(const InputFrame& input) {
        phase = Phase::page;
        poser.blendTo(idle, now.time_s);
        if (item().page.kind == PageKind::rest) note("break_start");
        openPage(input);
    }

    void openPage(const InputFrame& input) {
        const AgendaPage& page = item().page;
        view.frame.state = pageName(page.kind);
        const double progress = scored > 0 ? static_cast<double>(done) / scored : 1.0;
        openPanel(
            messagePanel(page.title, page.body, page.emphasis, {{page.button, button_id::go_on}}, progress),
            input, messagePose);
    }

    void enterTrial(bool moved) {
        const motion::Clip& clip = clips.clip(trial());
        if (clip.frames.empty() || clip.frames.front().joints.size() != avatar.joints.size())
            throw std::invalid_argument(
                fmt::format("the clip of system '{}' for target '{}' has not the avatar's joints",
                            trial().system, trial().target_id));
        playback.load(clip);
        view.closePanel();
        for (std::size_t place = 0; game() && place < trial().ball_order.size(); ++place)
            view.frame.balls.push_back(
                {trial().ball(static_cast<int>(place)), study.targets.ball_diameter_m / 2.0});
        pauses = 0;
        replays = 0;
        startLeadIn(study.inter_trial_s + (moved ? orient_s : 0.0));
    }

    void leave(const InputFrame& input) {
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

    void end(const char* status) {
        phase = Phase::over;
        view.closePanel();
        view.frame.balls.clear();
        view.frame.status = status;
        view.frame.state = "over";
    }

    void endEarly(const char* reason) {
        note("quit", reason);
        quit = true;
        end("ended early");
    }

    // A trial.

    void startLeadIn(double length_s) {
        phase = Phase::lead_in;
        playback.start(length_s, now.time_s);
        showState("waiting");
        answer_open = false;
        answer_shown = false;
        paused_s = 0.0;
        view.closePanel();
        view.lookAtBalls(BallLook::waiting);
    }

    void stepLeadIn() {
        if (!playback.leadIn(now.time_s)) return;
        phase = Phase::playing;
        showState("playing");
        stepPlaying();
    }

    void stepPlaying() {
        const bool was_halfway = playback.halfway();
        if (playback.play(now.time_s, view.frame.number)) view.frame.key_moment = true;
        if (playback.halfway() && !was_halfway) showState("pointing");
    }

    void openAnswer(const InputFrame& input) {
        answer_open = true;
        answer_shown = false;
        aiming = false;
        answer_frame = view.frame.number;
        showState(game() ? "choosing" : "rating");
        std::optional<ButtonSpec> replay;
        if (replays < (game() ? study.game.max_replays : study.rating.max_replays))
            replay = ButtonSpec{"Show again", button_id::replay};
        if (!game())
            openPanel(
                ratingPanel(study.rating.question, study.rating.labels, button_id::first_rating, replay),
                input, lecternPose);
        else if (replay)
            openPanel(questionPanel(study.game.question, *replay), input, deskPose);
        else
            view.closePanel();
        view.aim(input.pointer, game());
    }

    void stepAnswering(const InputFrame& input) {
        if (!answer_open) {
            openAnswer(input);
            return;
        }
        const Aim met = view.aim(input.pointer, game());
        if (game() && (met.ball >= 0) != aiming) {
            aiming = met.ball >= 0;
            showState(aiming ? "aiming" : "choosing");
        }
        if (!answer_shown) return;
        const int steps = static_cast<int>(study.rating.labels.size());
        if (input.select && met.button == button_id::replay) {
            ++replays;
            note("replay");
            startLeadIn(study.inter_trial_s);
        } else if (input.select && met.button >= button_id::first_rating) {
            answer(input, "ray", met.button - button_id::first_rating + 1, -1);
        } else if (input.select && met.ball >= 0) {
            answer(input, "ray", 0, met.ball);
        } else if (!game() && input.digit && *input.digit >= 1 && *input.digit <= steps) {
            answer(input, "key", *input.digit, -1);
        }
    }

    void answer(const InputFrame& input, const char* by, int rating, int place) {
        const bool correct = place >= 0 && place == trial().targetPlace();
        if (trial().practice) {
            note("practice_answer", rating > 0
                                        ? fmt::format("rating {}", rating)
                                        : fmt::format("place {}, {}", place, correct ? "correct" : "wrong"));
        } else {
            Response response;
            response.trial_index = trial().index;
            response.rating = rating;
            response.chosen_place = place;
            response.correct = correct;
            response.onset = playback.onset();
            response.motion_end = playback.motionEnd();
            const double read_s = input.input_time_s.value_or(now.time_s);
            response.answered = {read_s, now.utc_s + read_s - now.time_s};
            response.response_time_s = read_s - playback.motionEnd().time_s - paused_s;
            response.paused_s = paused_s;
            response.replays = replays;
            response.pauses = pauses;
            response.input = by;
            response.stage_from_head = input.stage_from_head;
            response.pointer = input.pointer;
            events.push_back(std::move(response));
            ++done;
        }
        phase = Phase::confirmed;
        showState(game() ? "chosen" : "rated");
        confirmed_since_s = now.time_s;
        view.frame.key_moment = true;
        view.frame.ray.reset();
        view.lookAtBalls(BallLook::selectable, place, BallLook::chosen);
        view.confirmButton(rating > 0 ? button_id::first_rating + rating - 1 : 0);
    }

    // Pauses.

    void pause(const InputFrame& input) {
        const std::string reason = input.pause_reason.empty() ? "paused" : input.pause_reason;
        note("pause", reason);
        paused = true;
        view.frame.state = "paused";
        paused_since_s = now.time_s;
        view.frame.ray.reset();
        view.lookAtBalls(BallLook::waiting);
        view.frame.status = item().status + ", paused: " + reason;
        openPanel(messagePanel(
                      "Paused",
                      "Go on when you are ready. If you end the session here, the answers given so far are "
                      "kept and the rest can be done later.",
                      "", {{"Resume", button_id::resume}, {"End session", button_id::end_session}}, -1.0),
                  input, messagePose);
    }

    void stepPaused(const InputFrame& input) {
        const Aim met = view.aim(input.pointer, false);
        if (!settled()) return;
        if (input.select && met.button == button_id::end_session)
            endEarly("ended on the pause panel");
        else if (input.confirm || (input.select && met.button == button_id::resume))
            resume(input);
    }

    void resume(const InputFrame& input) {
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

    // One frame.

    void step(const InputFrame& input) {
        view.beginFrame();
        now = {input.time_s, input.utc_s};
        if (phase == Phase::over) return;
        if (!started) begin(input);
        if (input.quit) {
            endEarly("quit");
        } else if (paused) {
            stepPaused(input);
        } else if (input.pause) {
            pause(input);
        } else {
            stepPhase(input);
        }
        // A pause freezes the avatar as it is; but it must be there, also where the first frame is paused.
        if (!paused || view.frame.avatar_joints.empty()) poser.write(view.frame.avatar_joints);
    }

    void stepPhase(const InputFrame& input) {
        switch (phase) {
            case Phase::page: {
                poser.advance(now.time_s);
                const Aim met = view.aim(input.pointer, false);
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
                if (now.time_s - confirmed_since_s >= confirm_s) leave(input);
                break;
            case Phase::over:
                break;
        }
    }

    void shown(const FrameReport& report) {
        if (!report.shown || report.number > view.frame.number || paused) return;
        const Moment at{report.display_time_s, now.utc_s + report.display_time_s - now.time_s};
        if (phase == Phase::playing) {
            const Shown first = playback.shown(report.number, at);
            if (first == Shown::onset)
                noteAt(at, "stimulus_onset", replays > 0 ? fmt::format("replay {}", replays) : "");
            if (first == Shown::end) {
                noteAt(at, "motion_end", "");
                phase = Phase::answering;
            }
        } else if (phase == Phase::answering && answer_open && report.number >= answer_frame) {
            answer_shown = true;
        }
    }
};

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
    const State& s = *state_;
    if (!s.started || s.phase == Phase::over || s.item().trial == nullptr) return -1;
    return s.trial().index;
}

bool SessionRunner::finished() const {
    return state_->finished;
}

bool SessionRunner::quit() const {
    return state_->quit;
}

}  // namespace deixis::studies
