// Boards by hand before a simulated participant, and what its hand does to them: no session is behind them.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/synthesis/generator.hpp"
#include "studies/session/session.hpp"
#include "studies/simulation/simulated_participant.hpp"

namespace deixis::tests {

using namespace deixis::studies;

/// An upright board before the viewer that parts are added to from the left, one row under the other.
class BoardByHand {
  public:
    explicit BoardByHand(const Pose& stage_from_viewer = {{0.0, 0.0, 3.4}, no_rotation}) {
        panel.width_m = 1.6;
        panel.height_m = 1.1;
        panel.stage_from_panel = stage_from_viewer * Pose{{-0.8, 0.9, -1.3}, no_rotation};
    }
    PanelButton& button(int id, ButtonRole role, const std::string& label, bool enabled = true) {
        PanelButton made;
        made.box = next(0.14);
        made.id = id;
        made.role = role;
        made.label = label;
        made.enabled = enabled;
        panel.buttons.push_back(made);
        return panel.buttons.back();
    }
    void steps(int first_id, int low, int high, bool enabled = true) {
        for (int value = low; value <= high; ++value)
            button(first_id + value - low, ButtonRole::option, std::to_string(value), enabled);
        row();
    }
    PanelSlider& slider(int id, int low, int high) {
        PanelSlider made;
        made.box = next(0.6);
        made.id = id;
        made.low = low;
        made.high = high;
        panel.sliders.push_back(made);
        return panel.sliders.back();
    }
    void field(int id, const std::string& hint) {
        PanelField made;
        made.box = next(0.4);
        made.id = id;
        made.hint = hint;
        panel.fields.push_back(made);
    }
    void row() {
        x_ = 0.02;
        y_ -= 0.14;
    }

    Panel panel{};

  private:
    double x_ = 0.02, y_ = 0.97;
    PanelRect next(double width_m) {
        if (x_ + width_m > 1.58) row();
        const PanelRect box{x_, y_, width_m, 0.11};
        x_ += width_m + 0.01;
        return box;
    }
};

inline Panel signSaying(const std::string& first, const std::string& second = {}) {
    Panel sign;
    PanelText text;
    text.text = first;
    sign.texts.push_back(text);
    text.text = second;
    sign.texts.push_back(text);
    return sign;
}

/// Clips of a built-in system.
inline motion::Clip systemClip(const std::string& system, const Vec3& target) {
    const auto generator = motion::makeGenerator(system, motion::referenceHumanoid(), {});
    return (*generator)->generate({"T001", target, 7, {}}).clip;
}

inline const Vec3 target{0.4, 1.2, 2.0};

inline const motion::Clip& natural() {
    static const motion::Clip clip = systemClip("direct", target);
    return clip;
}
inline const motion::Clip& stiff() {
    static const motion::Clip clip = systemClip("stiff", target);
    return clip;
}

/// The participant and what is before it. Presses take effect in the frame in which they come.
struct Room {
    explicit Room(std::uint64_t seed, const SimulatedParameters& parameters = {}, bool keyboard = true)
        : participant(parameters, motion::referenceHumanoid(), seed, keyboard) {
        frame.stage_from_viewer = {{0.0, 0.0, 3.4}, no_rotation};
        frame.viewer_place = "across";
        frame.avatar_joints = idle();
    }

    SimulatedParticipant participant;
    PresentedFrame frame;
    double time_s = 0.0;
    InputFrame input;
    std::vector<int> pressed;           ///< ids of enabled buttons, in order
    std::vector<int> balls;             ///< places
    int misses = 0;                     ///< presses that met nothing
    std::function<void(int)> on_press;  ///< after an option has been marked
    std::optional<int> dragged{};       ///< slider, while select is held

    static std::vector<Pose> idle() {
        const motion::Skeleton& avatar = motion::referenceHumanoid();
        return motion::worldPose(avatar, motion::relaxedPose(avatar));
    }

    void step() {
        time_s += 1.0 / 30.0;
        input = participant.act(time_s);
        if (input.select) press();
        if (!input.select_held) dragged.reset();
        if (dragged) drag();
        type();
        participant.see(frame, time_s);
    }
    void wait(double seconds) {
        for (const double end_s = time_s + seconds; time_s < end_s;) step();
    }
    bool until(const std::function<bool()>& come, double longest_s = 60.0) {
        for (const double end_s = time_s + longest_s; time_s < end_s;) {
            if (come()) return true;
            step();
        }
        return come();
    }
    /// The avatar moves; `right`: the one that stands there.
    void play(const motion::Clip& clip, bool right = false) {
        motion::LocalPose pose;
        for (double at_s = 0.0; at_s <= clip.duration_s(); at_s += 1.0 / 30.0) {
            motion::sample(clip, at_s, pose);
            (right ? frame.right_avatar_joints : frame.avatar_joints) =
                motion::worldPose(motion::referenceHumanoid(), pose);
            step();
        }
    }
    /// Watches a clip without a board, or with the balls waiting.
    void watch(const motion::Clip& clip) {
        frame.panel.reset();
        frame.avatar_joints = idle();
        wait(0.6);
        play(clip);
    }
    [[nodiscard]] bool wasPressed(int id) const {
        return std::find(pressed.begin(), pressed.end(), id) != pressed.end();
    }

  private:
    struct Point {
        double x, y;
    };
    [[nodiscard]] Point onPlane() const {
        const Pose panel_from_stage = inverse(frame.panel->stage_from_panel);
        const Vec3 origin = transformPoint(panel_from_stage, input.pointer->origin);
        const Vec3 direction = panel_from_stage.orientation * input.pointer->direction;
        const Vec3 met = origin - origin.z / direction.z * direction;
        return {met.x, met.y};
    }
    static bool inside(const PanelRect& box, const Point& at) {
        return at.x >= box.x && at.x <= box.x + box.width && at.y >= box.y && at.y <= box.y + box.height;
    }
    bool pressBall() {
        std::optional<std::size_t> nearest;
        double nearest_m = 1e9;
        for (std::size_t i = 0; i < frame.balls.size(); ++i) {
            const double met = distanceToSphere(*input.pointer, frame.balls[i].centre, 0.05);
            if (met < 0.0 || met >= nearest_m) continue;
            nearest = i;
            nearest_m = met;
        }
        if (!nearest) return false;
        balls.push_back(static_cast<int>(*nearest));
        return true;
    }
    void press() {
        if (pressBall()) return;
        if (!frame.panel) {
            ++misses;
            return;
        }
        const Point at = onPlane();
        for (PanelSlider& slider : frame.panel->sliders)
            if (slider.enabled && inside(slider.box, at)) {
                dragged = slider.id;
                pressed.push_back(slider.id);
                return;
            }
        for (PanelField& field : frame.panel->fields)
            if (field.enabled && inside(field.box, at)) {
                for (PanelField& other : frame.panel->fields) other.active = other.id == field.id;
                pressed.push_back(field.id);
                return;
            }
        for (PanelButton& button : frame.panel->buttons)
            if (button.enabled && inside(button.box, at)) {
                pressed.push_back(button.id);
                if (button.role == ButtonRole::option) choose(button);
                if (on_press) on_press(pressed.back());
                return;
            }
        ++misses;
    }
    void choose(PanelButton& chosen) {
        for (PanelButton& button : frame.panel->buttons)
            if (button.id / 100 == chosen.id / 100) button.chosen = button.id == chosen.id;
    }
    void drag() {
        for (PanelSlider& slider : frame.panel->sliders)
            if (slider.id == *dragged) slider.value = slider.valueAt(onPlane().x);
    }
    void type() {
        if (!frame.panel) return;
        for (PanelField& field : frame.panel->fields) {
            if (!field.active) continue;
            field.text += input.typed;
            for (int i = 0; i < input.erased && !field.text.empty(); ++i) field.text.pop_back();
        }
    }
};

/// A rating of the movement just seen; its buttons go once one is pressed.
inline int rateBySteps(Room& room, int low, int high) {
    BoardByHand board;
    board.steps(button_id::first_rating, low, high);
    room.frame.panel = board.panel;
    room.pressed.clear();
    room.on_press = [&room](int) {
        for (PanelButton& button : room.frame.panel->buttons) button.enabled = false;
    };
    REQUIRE(room.until([&room] { return !room.pressed.empty(); }));
    const int value = room.pressed.front() - button_id::first_rating + low;
    room.on_press = nullptr;
    room.frame.panel.reset();
    return value;
}

/// The same by a slider, which is confirmed.
inline int rateBySlider(Room& room, int low, int high) {
    BoardByHand board;
    board.slider(button_id::first_slider, low, high);
    board.button(button_id::go_on, ButtonRole::go_on, "Confirm", false);
    room.frame.panel = board.panel;
    room.pressed.clear();
    const auto done = [&room] {
        room.frame.panel->buttons.front().enabled = room.frame.panel->sliders.front().value.has_value();
        return room.wasPressed(button_id::go_on);
    };
    REQUIRE(room.until(done));
    const int value = *room.frame.panel->sliders.front().value;
    room.frame.panel.reset();
    return value;
}

}  // namespace deixis::tests
