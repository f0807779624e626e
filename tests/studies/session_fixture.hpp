// Somebody who drives a session frame by frame.
#pragma once

#include <functional>
#include <glm/geometric.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "session_study.hpp"
#include "text.hpp"

namespace deixis::tests {

inline InputFrame pauseFor(PauseReason reason) {
    InputFrame input;
    input.pause = true;
    input.pause_reason = reason;
    return input;
}

/// The ray from the participant's eyes to a point.
inline Ray lookAt(const PresentedFrame& frame, const Vec3& point) {
    const Vec3 eye = frame.stage_from_viewer.position + Vec3(0.0, 1.65, 0.0);
    return {eye, glm::normalize(point - eye)};
}

inline Vec3 buttonCentre(const Panel& panel, int id) {
    for (const PanelButton& button : panel.buttons)
        if (button.id == id)
            return transformPoint(panel.stage_from_panel, {button.box.x + button.box.width / 2.0,
                                                           button.box.y + button.box.height / 2.0, 0.0});
    return Vec3(0.0, 100.0, 0.0);
}

inline bool hasButton(const PresentedFrame& frame, int id) {
    if (!frame.panel) return false;
    for (const PanelButton& button : frame.panel->buttons)
        if (button.id == id && button.enabled) return true;
    return false;
}

/// Whether a single rating or a choice can be given.
inline bool answersOpen(const PresentedFrame& frame) {
    return frame.state == PresentedState::rating || frame.state == PresentedState::choosing ||
           frame.state == PresentedState::aiming;
}

/// Whether a page waits to be read.
inline bool resting(const PresentedFrame& frame) {
    const bool filled_in = frame.state == PresentedState::consent || frame.state == PresentedState::paused ||
                           frame.state == PresentedState::questionnaire ||
                           frame.state == PresentedState::reasons;
    return frame.panel && isFullPage(frame.state) && !filled_in;
}

inline std::optional<double> answerTo(const Response& response, const std::string& question,
                                      int stimulus = -1) {
    for (const Answer& answer : response.answers)
        if (answer.question == question && answer.stimulus == stimulus) return answer.value;
    return std::nullopt;
}

inline std::string textOf(const Response& response, const std::string& question) {
    for (const Answer& answer : response.answers)
        if (answer.question == question) return answer.text;
    return "(none)";
}

/// Of a single rating; 0: none was given.
inline int ratingOf(const Response& response) {
    return static_cast<int>(answerTo(response, "rating", 0).value_or(0.0));
}

inline std::string textOf(const Panel& panel) {
    std::string all;
    for (const PanelText& text : panel.texts) all += unwrapped(text.text) + "\n";
    return all;
}

/// Steps a session at a steady rate and keeps what it says.
struct Driver {
    /// The study by hand.
    explicit Driver(int items = 2, double clip_s = 1.0, bool practice = true) : clips(handClip(clip_s)) {
        study = handStudy();
        for (const char* name : {"naturalness-practice", "naturalness-begin", "game-practice", "game-begin"})
            if (!practice) removeStage(study, name);
        plan = handPlan(study, items);
    }
    /// Another one, to be planned.
    explicit Driver(std::vector<Stage> stages, double clip_s = 0.5) : clips(handClip(clip_s)) {
        study = handStudy();
        study.stages = std::move(stages);
        plan = emptyPlan(study);
    }

    Study study;
    StudyPlan plan;
    OneClip clips;
    const motion::Skeleton& avatar = motion::referenceHumanoid();
    motion::LocalPose idle = motion::relaxedPose(avatar);
    std::optional<SessionRunner> session;

    double time_s = 100.0;
    double frame_time_s = 1.0 / 60.0;
    double display_delay_s = 0.0;
    double place_offset_m = 0.0;         ///< how far off the place the participant stands
    bool holds_pointer = true;           ///< without one, a step that aims at nothing has no ray
    bool kept = true;                    ///< whether the answers given are on the disk
    bool recording_failed = false;       ///< nothing more can be kept
    std::optional<Quat> looking;         ///< of the head; none: along the ray, or straight ahead
    std::optional<double> select_ago_s;  ///< how long before the frame select went down; none: not told
    PresentedFrame frame;                ///< the last one
    bool just_opened = false;            ///< it is the first of an open answer
    bool keyboard = false;
    std::vector<Response> responses;  ///< of what counts
    std::vector<Response> practised;
    std::vector<Superseded> superseded;
    std::vector<Exclusion> exclusions;
    std::vector<Note> notes;
    std::vector<SessionEvent> all_events;
    Resume left;                       ///< what a further session goes on from
    std::size_t max_events = 1000000;  ///< what comes after these is lost, as by a kill

    [[nodiscard]] Stage& stage(const std::string& name) {
        for (Stage& one : study.stages)
            if (one.name == name) return one;
        throw std::out_of_range(name);
    }
    Trial& add(const std::string& stage_name, int item, std::vector<std::string> systems) {
        return addTrial(plan, stage(stage_name), item, std::move(systems));
    }

    void start(const std::set<int>& answered = {}) {
        for (const int index : answered) left.answered[index] = true;
        session.emplace(study, plan, clips, avatar, idle, left, keyboard);
    }
    /// Another session, from what this one left.
    void restart() {
        frame = {};
        start();
    }

    void keep(const Response& response) {
        const Trial& trial = plan.trials[static_cast<std::size_t>(response.trial_index)];
        (trial.practice ? practised : responses).push_back(response);
        if (answerTo(response, "consent") != 0.0)
            left.answered[trial.index] = trial.kind != StageKind::game || response.correct();
        left.first_answers.push_back(response);
        if (response.check_passed == false) ++left.check_failures[{trial.stage, trial.check->kind}];
        if (!response.exclusion.empty()) exclusions.push_back({response.exclusion, response.answered});
    }

    void keep(const std::vector<SessionEvent>& events) {
        for (const SessionEvent& event : events) {
            if (all_events.size() >= max_events) return;
            all_events.push_back(event);
            if (const auto* response = std::get_if<Response>(&event)) keep(*response);
            if (const auto* note = std::get_if<Note>(&event)) {
                notes.push_back(*note);
                if (note->kind == NoteKind::stimulus_onset) left.begun.insert(note->trial_index);
            }
            if (const auto* exclusion = std::get_if<Exclusion>(&event)) exclusions.push_back(*exclusion);
            if (const auto* again = std::get_if<Superseded>(&event)) {
                superseded.push_back(*again);
                left.answered.erase(again->trial_index);
            }
        }
    }

    [[nodiscard]] bool finished() const { return session->outcome() == SessionOutcome::finished; }
    [[nodiscard]] bool hasQuit() const { return session->outcome() == SessionOutcome::quit; }
    [[nodiscard]] bool running() const { return session->outcome() == SessionOutcome::running; }

    /// Its name, of the frame shown last.
    [[nodiscard]] std::string state() const { return presentedStateName(frame); }

    void step(InputFrame input = {}, bool was_shown = true) {
        time_s += frame_time_s;
        input.time_s = time_s;
        input.utc_s = time_s + 1.0e9;
        input.stage_from_head.position = frame.stage_from_viewer.position + Vec3(0.0, 1.65, 0.0);
        input.stage_from_head.orientation = frame.stage_from_viewer.orientation;
        if (input.pointer)
            input.stage_from_head.orientation =
                rotationBetween(Vec3(0.0, 0.0, -1.0), input.pointer->direction);
        else if (holds_pointer)
            input.pointer = Ray{input.stage_from_head.position - Vec3(0.0, 0.7, 0.0), -up};
        if (looking) input.stage_from_head.orientation = *looking;
        if (select_ago_s) input.select_time_s = time_s - *select_ago_s;
        input.off_place_m = place_offset_m;
        input.answers_kept = kept;
        input.recording_failed = recording_failed;
        const bool was_open = answersOpen(frame);
        const SessionStep step = session->step(input);
        frame = step.frame;
        just_opened = answersOpen(frame) && !was_open;
        keep(step.events);
        keep(session->shown({frame.number, was_shown, time_s + display_delay_s}));
    }

    [[nodiscard]] InputFrame pointing(const Vec3& point, bool select) const {
        InputFrame input;
        input.pointer = lookAt(frame, point);
        input.select = select;
        return input;
    }

    /// Where the answer has only just come up, the ray comes from elsewhere first.
    void press(int id) {
        if (just_opened) step();
        step(pointing(buttonCentre(*frame.panel, id), true));
    }
    void choose(int place) {
        if (just_opened) step();
        step(pointing(frame.balls[static_cast<std::size_t>(place)].centre, true));
    }
    void digit(int value) {
        InputFrame input;
        input.digit = value;
        step(input);
    }

    /// Steps without doing anything; false where it does not come about within a minute.
    bool waitUntil(const std::function<bool()>& come) {
        for (int i = 0; i < 3600; ++i) {
            if (come()) return true;
            step();
        }
        return false;
    }
    void wait(double seconds) {
        for (double passed = 0.0; passed < seconds; passed += frame_time_s) step();
    }

    bool leavePage() {
        if (!waitUntil([this] { return resting(frame) && hasButton(frame, button_id::go_on); })) return false;
        wait(0.5);
        press(button_id::go_on);
        return true;
    }

    /// Reads every page until the answer of a trial is open.
    bool toAnswer() {
        for (int i = 0; i < 3600; ++i) {
            if (answersOpen(frame)) {
                step();
                return true;
            }
            if (resting(frame))
                leavePage();
            else
                step();
        }
        return false;
    }

    /// Reads every page until the session is in that state.
    bool toState(const std::string& wanted) {
        return waitUntil([&] {
            if (state() != wanted && resting(frame)) leavePage();
            return state() == wanted;
        });
    }

    void order(OperatorAction action, const std::string& text = {}) {
        InputFrame input;
        input.commands.push_back({action, text});
        step(input);
    }

    void answerSomehow(int number) {
        if (frame.balls.empty())
            press(button_id::first_rating + number % 5);
        else
            choose(number % 3);
    }

    /// Goes on to the end.
    bool finish() {
        for (int answers = 0; answers < 1000; ++answers) {
            while (!answersOpen(frame) && !finished()) {
                if (resting(frame))
                    leavePage();
                else
                    step();
            }
            if (finished()) return true;
            step();
            answerSomehow(answers);
        }
        return false;
    }

    [[nodiscard]] int count(NoteKind kind) const {
        int found = 0;
        for (const Note& note : notes)
            if (note.kind == kind) ++found;
        return found;
    }
    [[nodiscard]] const Note& last(NoteKind kind) const {
        for (auto note = notes.rbegin(); note != notes.rend(); ++note)
            if (note->kind == kind) return *note;
        static const Note none{};
        return none;
    }
};

}  // namespace deixis::tests
