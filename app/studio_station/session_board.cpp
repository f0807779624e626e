#include "session_board.hpp"

#include <string>

namespace deixis::app {

namespace {

using nlohmann::ordered_json;

ordered_json boxJson(const studies::PanelRect& box) {
    return {box.x, box.y, box.width, box.height};
}

ordered_json textsJson(const studies::Panel& panel) {
    auto out = ordered_json::array();
    for (const studies::PanelText& text : panel.texts)
        out.push_back({{"box", boxJson(text.box)},
                       {"text", text.text},
                       {"size_m", text.size_m},
                       {"bold", text.bold},
                       {"centred", text.centred},
                       {"faint", text.faint},
                       {"level", text.level}});
    return out;
}

ordered_json buttonsJson(const studies::Panel& panel) {
    auto out = ordered_json::array();
    for (const studies::PanelButton& button : panel.buttons)
        out.push_back({{"box", boxJson(button.box)},
                       {"label", button.label},
                       {"caption", button.caption},
                       {"id", button.id},
                       {"enabled", button.enabled},
                       {"chosen", button.chosen},
                       {"role", std::string(studies::buttonRoleName(button.role))}});
    return out;
}

ordered_json slidersJson(const studies::Panel& panel) {
    auto out = ordered_json::array();
    for (const studies::PanelSlider& slider : panel.sliders)
        out.push_back({{"box", boxJson(slider.box)},
                       {"track", boxJson(slider.track())},
                       {"id", slider.id},
                       {"low", slider.low},
                       {"high", slider.high},
                       {"value", slider.value ? ordered_json(*slider.value) : ordered_json()},
                       {"labels", slider.labels},
                       {"label_size_m", slider.label_size_m},
                       {"enabled", slider.enabled}});
    return out;
}

ordered_json fieldsJson(const studies::Panel& panel) {
    auto out = ordered_json::array();
    for (const studies::PanelField& field : panel.fields)
        out.push_back({{"box", boxJson(field.box)},
                       {"id", field.id},
                       {"text", field.text},
                       {"hint", field.hint},
                       {"active", field.active},
                       {"enabled", field.enabled}});
    return out;
}

ordered_json panelJson(const studies::Panel& panel) {
    return {{"width_m", panel.width_m},
            {"height_m", panel.height_m},
            {"progress", panel.progress < 0.0 ? ordered_json() : ordered_json(panel.progress)},
            {"texts", textsJson(panel)},
            {"buttons", buttonsJson(panel)},
            {"sliders", slidersJson(panel)},
            {"fields", fieldsJson(panel)}};
}

ordered_json taskJson(const studies::AuthoringTask& task) {
    return {{"trial", task.trial},
            {"of", task.of},
            {"practice", task.practice},
            {"system", task.system},
            {"keyframes_only", task.keyframes_only},
            {"question", task.question},
            {"limit_s", task.limit_s},
            {"may_end_early", task.may_end_early}};
}

}  // namespace

ordered_json sessionBoard(const studies::PresentedFrame& frame) {
    return {{"state", std::string(studies::presentedStateName(frame.state))},
            {"stage", frame.stage},
            {"notice", frame.notice},
            {"over", frame.state == studies::PresentedState::over},
            {"panel", frame.panel ? panelJson(*frame.panel) : ordered_json()},
            {"authoring", frame.authoring ? taskJson(*frame.authoring) : ordered_json()}};
}

}  // namespace deixis::app
