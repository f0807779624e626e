#include "app/session/trace.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace deixis::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr double longest_silence_s = 0.2;

Json json(const Vec3& v) {
    return Json::array({v.x, v.y, v.z});
}

Json json(const Pose& pose) {
    const Quat& q = pose.orientation;
    return Json::array({pose.position.x, pose.position.y, pose.position.z, q.w, q.x, q.y, q.z});
}

const char* name(studies::BallLook look) {
    switch (look) {
        case studies::BallLook::waiting:
            return "waiting";
        case studies::BallLook::selectable:
            return "selectable";
        case studies::BallLook::hovered:
            return "hovered";
        case studies::BallLook::chosen:
            return "chosen";
        case studies::BallLook::revealed:
            return "revealed";
    }
    throw std::logic_error("a ball with a look that has no name");
}

Json ballsJson(const std::vector<studies::BallView>& balls) {
    Json out = Json::array();
    for (const auto& ball : balls)
        out.push_back(
            {{"centre", json(ball.centre)}, {"radius_m", ball.radius_m}, {"look", name(ball.look)}});
    return out;
}

Json buttonsJson(const studies::PresentedFrame& frame) {
    Json out = Json::array();
    if (!frame.panel) return out;
    for (const auto& button : frame.panel->buttons) {
        const Vec3 centre{button.box.x + button.box.width / 2.0, button.box.y + button.box.height / 2.0, 0.0};
        out.push_back({{"id", button.id},
                       {"label", button.label},
                       {"role", std::string(studies::buttonRoleName(button.role))},
                       {"enabled", button.enabled},
                       {"chosen", button.chosen},
                       {"hovered", button.hovered},
                       {"centre", json(transformPoint(frame.panel->stage_from_panel, centre))}});
    }
    return out;
}

/// Where a slider's ends stand in the stage.
Json slidersJson(const studies::PresentedFrame& frame) {
    Json out = Json::array();
    if (!frame.panel) return out;
    for (const auto& slider : frame.panel->sliders) {
        const studies::PanelRect track = slider.track();
        const double middle = track.y + track.height / 2.0;
        const auto at = [&](double x) {
            return json(transformPoint(frame.panel->stage_from_panel, {x, middle, 0.0}));
        };
        out.push_back({{"id", slider.id},
                       {"low", slider.low},
                       {"high", slider.high},
                       {"value", slider.value ? Json(*slider.value) : Json(nullptr)},
                       {"enabled", slider.enabled},
                       {"left", at(track.x)},
                       {"right", at(track.x + track.width)}});
    }
    return out;
}

Json fieldsJson(const studies::PresentedFrame& frame) {
    Json out = Json::array();
    if (!frame.panel) return out;
    for (const auto& field : frame.panel->fields) {
        const Vec3 centre{field.box.x + field.box.width / 2.0, field.box.y + field.box.height / 2.0, 0.0};
        out.push_back({{"id", field.id},
                       {"text", field.text},
                       {"hint", field.hint},
                       {"active", field.active},
                       {"centre", json(transformPoint(frame.panel->stage_from_panel, centre))}});
    }
    return out;
}

/// Its texts, one a line.
std::string signText(const studies::PresentedFrame& frame) {
    std::string out;
    if (!frame.sign) return out;
    for (const auto& text : frame.sign->texts) out += (out.empty() ? "" : "\n") + text.text;
    return out;
}

Json rayJson(const std::optional<studies::RayView>& ray) {
    if (!ray) return nullptr;
    return {{"origin", json(ray->ray.origin)},
            {"direction", json(ray->ray.direction)},
            {"length_m", ray->length_m}};
}

Json lookJson(const std::optional<studies::FirstLook>& look) {
    if (!look) return nullptr;
    return Json::array({look->yaw_rad, look->pitch_rad, look->half_width, look->half_height});
}

Json notesJson(const std::vector<studies::StationNote>& notes) {
    Json out = Json::array();
    for (const auto& note : notes)
        out.push_back({{"kind", studies::noteKindName(note.kind)}, {"detail", note.detail}});
    return out;
}

bool sameButton(const studies::PanelButton& a, const studies::PanelButton& b) {
    return a.id == b.id && a.enabled == b.enabled && a.hovered == b.hovered && a.chosen == b.chosen &&
           a.label == b.label;
}

bool sameSlider(const studies::PanelSlider& a, const studies::PanelSlider& b) {
    return a.id == b.id && a.value == b.value && a.enabled == b.enabled;
}

bool sameField(const studies::PanelField& a, const studies::PanelField& b) {
    return a.id == b.id && a.text == b.text && a.active == b.active;
}

bool sameBall(const studies::BallView& a, const studies::BallView& b) {
    return a.look == b.look && a.centre == b.centre;
}

template <typename Parts, typename Same>
bool same(const Parts& a, const Parts& b, Same same_part) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_part);
}

}  // namespace

Result<std::ofstream> openTrace(const std::filesystem::path& path) {
    std::ofstream file(path, std::ios::app | std::ios::binary);
    if (!file) return fail(path.string(), "the trace cannot be opened for writing", "Name another file");
    return file;
}

bool Trace::changed(const studies::PresentedFrame& frame) const {
    if (!begun_ || presentedStateName(frame) != state_ || frame.stage != stage_ ||
        frame.viewer_place != place_ || frame.status != status_ || frame.notice != notice_ ||
        signText(frame) != sign_ || frame.panel.has_value() != panel_.has_value())
        return true;
    if (panel_ && !(same(frame.panel->buttons, panel_->buttons, sameButton) &&
                    same(frame.panel->sliders, panel_->sliders, sameSlider) &&
                    same(frame.panel->fields, panel_->fields, sameField)))
        return true;
    return !same(frame.balls, balls_, sameBall);
}

void Trace::remember(const studies::PresentedFrame& frame) {
    begun_ = true;
    state_ = presentedStateName(frame);
    stage_ = frame.stage;
    place_ = frame.viewer_place;
    status_ = frame.status;
    notice_ = frame.notice;
    sign_ = signText(frame);
    panel_ = frame.panel;
    balls_ = frame.balls;
}

void Trace::presented(const studies::InputFrame& input, const studies::PresentedFrame& frame) {
    kept_by_.presented(input, frame);
    const bool due = input.time_s - told_s_ >= longest_silence_s;
    if (input.notes.empty() && !due && !changed(frame)) return;
    remember(frame);
    told_s_ = input.time_s;
    const Json line{{"time_s", input.time_s},
                    {"utc_s", input.utc_s},
                    {"frame", frame.number},
                    {"state", presentedStateName(frame)},
                    {"stage", frame.stage},
                    {"status", studies::sessionStatusText(frame.status)},
                    {"place", frame.viewer_place},
                    {"notice", frame.notice},
                    {"trial", session_.trialUnderWay()},
                    {"stage_from_viewer", json(frame.stage_from_viewer)},
                    {"balls", ballsJson(frame.balls)},
                    {"buttons", buttonsJson(frame)},
                    {"sliders", slidersJson(frame)},
                    {"fields", fieldsJson(frame)},
                    {"sign", signText(frame)},
                    {"ray", rayJson(frame.ray)},
                    {"first_look", lookJson(frame.first_look)},
                    {"head", json(input.stage_from_head)},
                    {"notes", notesJson(input.notes)}};
    // A device's name may be in any encoding.
    file_ << line.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n' << std::flush;
    if (!file_) throw std::runtime_error("the trace cannot be written");
}

}  // namespace deixis::app
