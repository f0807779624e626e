// Stages of every kind, by hand, and hands for what can be done in them.
#pragma once

#include <string>
#include <vector>

#include "session_fixture.hpp"

namespace deixis::tests {

inline Scale slider(int low, int high) {
    return {ScaleKind::slider, low, high, {"bad", "good"}};
}

inline Stage ratingStage(const char* name = "rating") {
    Stage stage;
    stage.name = name;
    stage.kind = StageKind::rating;
    stage.measure = "naturalness";
    stage.question = "How natural?";
    stage.scale = five_steps;
    return stage;
}

inline Stage parallelStage(const Scale& scale) {
    Stage stage = ratingStage("parallel");
    stage.kind = StageKind::parallel_rating;
    stage.scale = scale;
    return stage;
}

inline Stage pairStage() {
    Stage stage = ratingStage("pairs");
    stage.kind = StageKind::pairwise;
    stage.question = "Which one points better?";
    return stage;
}

inline Stage gameStage(const char* name = "game") {
    Stage stage;
    stage.name = name;
    stage.kind = StageKind::game;
    stage.question = "Which ball?";
    return stage;
}

inline Question question(const char* id, QuestionKind kind, bool required = true) {
    Question made;
    made.id = id;
    made.kind = kind;
    made.text = std::string("About ") + id + "?";
    made.required = required;
    made.scale = five_steps;
    if (kind == QuestionKind::choice || kind == QuestionKind::choices)
        made.options = {{"a", "Option A"}, {"b", "Option B"}, {"c", "Option C"}};
    return made;
}

inline Stage questionnaireStage(std::vector<Question> questions, int per_page = 4) {
    Stage stage;
    stage.name = "questions";
    stage.kind = StageKind::questionnaire;
    stage.questionnaire.name = "hand";
    stage.questionnaire.title = "Some questions";
    stage.questionnaire.questions = std::move(questions);
    stage.questionnaire.per_page = per_page;
    return stage;
}

inline const PanelSlider* sliderOf(const PresentedFrame& frame, int id) {
    if (frame.panel)
        for (const PanelSlider& one : frame.panel->sliders)
            if (one.id == id) return &one;
    return nullptr;
}

/// A point on a slider's track, for a value.
inline Vec3 sliderPoint(const PresentedFrame& frame, int id, double value) {
    const PanelSlider* one = sliderOf(frame, id);
    if (one == nullptr) return Vec3(0.0, 100.0, 0.0);
    const PanelRect track = one->track();
    const double share = (value - one->low) / (one->high - one->low);
    return transformPoint(frame.panel->stage_from_panel,
                          {track.x + share * track.width, track.y + track.height / 2.0, 0.0});
}

inline Vec3 fieldCentre(const PresentedFrame& frame, int id) {
    if (frame.panel)
        for (const PanelField& field : frame.panel->fields)
            if (field.id == id)
                return transformPoint(
                    frame.panel->stage_from_panel,
                    {field.box.x + field.box.width / 2.0, field.box.y + field.box.height / 2.0, 0.0});
    return Vec3(0.0, 100.0, 0.0);
}

inline void setSlider(Driver& driver, int id, int value) {
    driver.step(driver.pointing(sliderPoint(driver.frame, id, value), true));
}

inline void type(Driver& driver, const std::string& text, int erased = 0) {
    InputFrame input;
    input.typed = text;
    input.erased = erased;
    driver.step(input);
}

inline const PanelButton* buttonOf(const PresentedFrame& frame, int id) {
    if (frame.panel)
        for (const PanelButton& button : frame.panel->buttons)
            if (button.id == id) return &button;
    return nullptr;
}

/// Of the buttons of an answer that has been given, those marked; none may be pressed any more.
inline std::vector<int> markedOptions(const PresentedFrame& frame) {
    std::vector<int> marked;
    if (!frame.panel) return marked;
    for (const PanelButton& button : frame.panel->buttons) {
        CHECK_FALSE(button.enabled);
        if (button.chosen) marked.push_back(button.id);
    }
    return marked;
}

/// Plays a clip of a page to its end.
inline bool playToEnd(Driver& driver, int stimulus) {
    const int ends = driver.count(NoteKind::motion_end);
    if (!driver.waitUntil([&] { return hasButton(driver.frame, button_id::first_play + stimulus); }))
        return false;
    driver.wait(0.45);
    driver.press(button_id::first_play + stimulus);
    const bool ended = driver.waitUntil([&] { return driver.count(NoteKind::motion_end) > ends; });
    driver.wait(0.05);
    return ended;
}

/// Answers whatever is open, plainly, and else goes on; one frame or a few.
inline void carryOn(Driver& driver) {
    const PresentedFrame& frame = driver.frame;
    const auto pressFirst = [&driver](int from, int to) {
        for (const PanelButton& button : driver.frame.panel->buttons)
            if (button.enabled && button.id >= from && button.id < to) {
                driver.press(button.id);
                return true;
            }
        return false;
    };
    if (!frame.panel) {
        if (answersOpen(frame))
            driver.choose(0);
        else
            driver.step();
        return;
    }
    if (resting(frame)) {
        if (hasButton(frame, button_id::go_on)) driver.press(button_id::go_on);
        driver.step();
        return;
    }
    if (frame.state == PresentedState::consent) {
        driver.press(button_id::agree);
    } else if (frame.state == PresentedState::watching || frame.state == PresentedState::comparing) {
        const std::string again = driver.study.words("play_again");
        for (const PanelButton& button : frame.panel->buttons)
            if (button.role == ButtonRole::play && button.enabled && button.caption != again &&
                button.label.find(again) == std::string::npos) {
                driver.press(button.id);
                driver.step();
                return;
            }
        for (const PanelSlider& one : frame.panel->sliders)
            if (one.enabled && !one.value) {
                setSlider(driver, one.id, (one.low + one.high) / 2);
                return;
            }
        if (!hasButton(frame, button_id::go_on) || !pressFirst(button_id::go_on, button_id::go_on + 1))
            pressFirst(button_id::first_rating, button_id::first_rating + 5);
    } else if (frame.state == PresentedState::questionnaire || frame.state == PresentedState::reasons) {
        if (hasButton(frame, button_id::go_on)) {
            driver.press(button_id::go_on);
        } else {
            for (const PanelSlider& one : frame.panel->sliders)
                if (!one.value) {
                    setSlider(driver, one.id, one.high);
                    return;
                }
            std::set<int> answered;  // questions
            for (const PanelButton& button : frame.panel->buttons)
                if (button.chosen) answered.insert(button.id / 100);
            for (const PanelButton& button : frame.panel->buttons)
                if (button.id >= button_id::first_option && answered.count(button.id / 100) == 0) {
                    driver.press(button.id);
                    break;
                }
        }
    } else if (frame.state == PresentedState::rating || frame.state == PresentedState::confidence) {
        pressFirst(button_id::first_rating, button_id::first_play);
    } else if (answersOpen(frame)) {
        driver.choose(0);
        return;
    }
    driver.step();
}

/// Carries on until something comes about; false where it does not within ten minutes.
template <typename Come>
bool carryOnUntil(Driver& driver, Come come) {
    for (int i = 0; i < 36000 && !come(); ++i) carryOn(driver);
    return come();
}

inline std::vector<int> trialsOf(const std::vector<Response>& responses) {
    std::vector<int> trials;
    for (const Response& response : responses) trials.push_back(response.trial_index);
    return trials;
}

}  // namespace deixis::tests
