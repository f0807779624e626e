// A small study by hand, and somebody who drives a session through it frame by frame.
#pragma once

#include <functional>
#include <glm/geometric.hpp>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "motion/reference_humanoid.hpp"
#include "studies/session.hpp"

namespace deixis::tests {

using namespace deixis::studies;

/// Two systems, each with one practice trial and `items` trials a stage; the game alternates the layouts.
inline StudyPlan handPlan(int items, bool practice = true) {
    StudyPlan plan;
    plan.participant = "P01";
    plan.study_name = "hand";
    const auto add = [&plan](StageKind stage, bool is_practice, int item, const char* system) {
        Trial trial;
        trial.index = static_cast<int>(plan.trials.size());
        trial.stage = stage;
        trial.practice = is_practice;
        trial.system = system;
        trial.target_id = "T00" + std::to_string(item + 1);
        trial.layout = "across";
        trial.target = {0.2 * item, 1.0 + 0.1 * item, 2.0};
        if (stage == StageKind::game) {
            trial.layout = trial.index % 2 == 0 ? "across" : "side-by-side";
            trial.distractors = {trial.target + Vec3(0.3, 0.0, 0.0), trial.target + Vec3(0.0, 0.3, 0.0)};
            trial.ball_order = {0, 1, 2};
            for (int turn = 0; turn < trial.index % 3; ++turn)
                trial.ball_order = {trial.ball_order[2], trial.ball_order[0], trial.ball_order[1]};
        }
        plan.trials.push_back(trial);
    };
    for (const StageKind stage : {StageKind::naturalness, StageKind::game}) {
        if (practice) add(stage, true, items, "one");
        for (int item = 0; item < items; ++item)
            for (const char* system : {"one", "two"}) add(stage, false, item, system);
    }
    return plan;
}

inline Study handStudy() {
    Study study;
    study.name = "hand";
    study.title = "A study by hand";
    study.welcome = "Hello.";
    study.break_text = "Rest.";
    study.goodbye = "Goodbye.";
    study.inter_trial_s = 0.6;
    study.layouts = {{"across", 0.0, 3.4, 180.0}, {"side-by-side", 0.7, -0.2, 0.0}};
    study.targets.ball_diameter_m = 0.1;
    study.rating.layout = "across";
    study.rating.question = "How natural do you find the animation?";
    study.rating.labels = {"very unnatural", "unnatural", "neither", "natural", "very natural"};
    study.rating.instructions = "Watch and rate.";
    study.rating.break_every = 2;
    study.game.layouts = {"across", "side-by-side"};
    study.game.question = "Which ball?";
    study.game.instructions = "Watch and choose.";
    return study;
}

/// The right arm goes up in front within `length_s` and stays there.
inline motion::Clip handClip(double length_s, double fps = 30.0) {
    motion::Clip clip;
    clip.skeleton = motion::referenceHumanoid();
    clip.frame_time_s = 1.0 / fps;
    const motion::LocalPose idle = motion::relaxedPose(clip.skeleton);
    const auto arm = static_cast<std::size_t>(clip.skeleton.find("rightUpperArm"));
    const int count = static_cast<int>(length_s * fps + 0.5) + 1;
    for (int i = 0; i < count; ++i) {
        motion::LocalPose pose = idle;
        const double angle = 0.3 + (count > 1 ? 1.0 * i / (count - 1) : 0.0);
        pose.joints[arm].orientation = yawRotation(-angle) * pose.joints[arm].orientation;
        clip.frames.push_back(pose);
    }
    return clip;
}

class OneClip : public ClipSource {
  public:
    explicit OneClip(motion::Clip clip) : clip_(std::move(clip)) {}
    [[nodiscard]] const motion::Clip& clip(const Trial&) const override { return clip_; }

  private:
    motion::Clip clip_;
};

inline InputFrame pauseFor(const char* reason) {
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

inline bool answersOpen(const PresentedFrame& frame) {
    if (hasButton(frame, button_id::first_rating)) return true;
    return !frame.balls.empty() && (frame.balls.front().look == BallLook::selectable ||
                                    frame.balls.front().look == BallLook::hovered);
}

inline bool resting(const PresentedFrame& frame) {
    return frame.panel && frame.panel->buttons.size() == 1;
}

/// Steps a session at a steady rate and keeps what it says.
struct Driver {
    explicit Driver(int items = 2, double clip_s = 1.0, bool practice = true)
        : plan(handPlan(items, practice)), clips(handClip(clip_s)) {}

    Study study = handStudy();
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
    std::optional<Quat> looking;         ///< of the head; none: along the ray, or straight ahead
    std::optional<double> select_ago_s;  ///< how long before the frame select went down; none: not told
    PresentedFrame frame;                ///< the last one
    std::vector<Response> responses;
    std::vector<Note> notes;

    void start(std::set<int> answered = {}) {
        session.emplace(study, plan, clips, avatar, idle, std::move(answered));
    }

    void keep(const std::vector<SessionEvent>& events) {
        for (const SessionEvent& event : events) {
            if (const auto* response = std::get_if<Response>(&event)) responses.push_back(*response);
            if (const auto* note = std::get_if<Note>(&event)) notes.push_back(*note);
        }
    }

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
        const SessionStep step = session->step(input);
        frame = step.frame;
        keep(step.events);
        keep(session->shown({frame.number, was_shown, time_s + display_delay_s}));
    }

    [[nodiscard]] InputFrame pointing(const Vec3& point, bool select) const {
        InputFrame input;
        input.pointer = lookAt(frame, point);
        input.select = select;
        return input;
    }

    void press(int id) { step(pointing(buttonCentre(*frame.panel, id), true)); }
    void choose(int place) { step(pointing(frame.balls[static_cast<std::size_t>(place)].centre, true)); }
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
        if (!waitUntil([this] { return resting(frame); })) return false;
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

    void answerSomehow(int number) {
        if (frame.balls.empty())
            press(button_id::first_rating + number % 5);
        else
            choose(number % 3);
    }

    /// Goes on to the end.
    bool finish() {
        for (int answers = 0; answers < 1000; ++answers) {
            while (!answersOpen(frame) && !session->finished()) {
                if (resting(frame))
                    leavePage();
                else
                    step();
            }
            if (session->finished()) return true;
            step();
            answerSomehow(answers);
        }
        return false;
    }

    [[nodiscard]] int count(const std::string& kind) const {
        int found = 0;
        for (const Note& note : notes)
            if (note.kind == kind) ++found;
        return found;
    }
    [[nodiscard]] const Note& last(const std::string& kind) const {
        for (auto note = notes.rbegin(); note != notes.rend(); ++note)
            if (note->kind == kind) return *note;
        static const Note none{};
        return none;
    }
};

}  // namespace deixis::tests
