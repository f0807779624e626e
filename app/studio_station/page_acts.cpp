#include "page_acts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "assets/projects/studio_project.hpp"
#include "core/text.hpp"

namespace deixis::app {

namespace {

using server::Refusal;
using server::SessionRequest;
using Kind = SessionRequest::Kind;

constexpr double settle_s = 0.45;  // a little longer than boards take no input
constexpr double eye_m = 1.65;

Vec3 eyesAt(const Pose& stage_from_viewer) {
    return stage_from_viewer.position + Vec3(0.0, eye_m, 0.0);
}

Quat looking(const Vec3& forward) {
    const double pitch = std::asin(std::clamp(forward.y, -1.0, 1.0));
    return yawRotation(std::atan2(-forward.x, -forward.z)) *
           Quat(std::cos(pitch / 2.0), std::sin(pitch / 2.0), 0.0, 0.0);
}

template <typename Part>
const Part* findPart(const std::vector<Part>& parts, int id) {
    const auto found =
        std::find_if(parts.begin(), parts.end(), [id](const Part& part) { return part.id == id; });
    return found == parts.end() ? nullptr : &*found;
}

/// Whatever the page tells is kept; of what is no project nothing can be counted.
studies::AuthoredProject projectOf(const SessionRequest& request) {
    studies::AuthoredProject out{request.text, static_cast<int>(request.edits.size())};
    out.generated = request.generated;
    if (const auto project = assets::parseStudioProject(request.text, "project")) {
        out.poses = project->pose_controls;
        out.styles = project->style_controls;
    }
    return out;
}

int characters(const std::string& text) {
    return static_cast<int>(
        std::count_if(text.begin(), text.end(), [](char c) { return !continuesCharacter(c); }));
}

Refusal notEnabled(const char* field, const char* what) {
    return {409, fmt::format("this {} is not on the board, or takes nothing now", what), field};
}

}  // namespace

void PageActs::see(const studies::PresentedFrame& frame, std::uint64_t revision, double time_s) {
    frame_ = &frame;
    if (frame.board == board_) return;
    board_ = frame.board;
    first_revision_ = revision;
    board_since_s_ = time_s;
}

Ray PageActs::rayTo(double x_m, double y_m) const {
    const Vec3 point = transformPoint(frame_->panel->stage_from_panel, {x_m, y_m, 0.0});
    const Vec3 eyes = eyesAt(frame_->stage_from_viewer);
    return {eyes, glm::normalize(point - eyes)};
}

/// The ray comes to it, then select goes down.
void PageActs::press(const Ray& ray) {
    steps_.push_back({ray});
    steps_.push_back({ray, true});
}

std::optional<Refusal> PageActs::begin(const SessionRequest& request, double time_s) {
    if (frame_ == nullptr) return Refusal{409, "the session has not begun yet"};
    if (frame_->state == studies::PresentedState::over) return Refusal{409, "the session is over"};
    not_before_s_ = time_s;
    switch (request.kind) {
        case Kind::press:
        case Kind::slide:
        case Kind::type:
            return onBoard(request, time_s);
        case Kind::work:
        case Kind::finish:
            return authored(request, time_s);
        case Kind::pause:
            break;
    }
    Step step;
    step.pause = true;
    steps_.push_back(std::move(step));
    return std::nullopt;
}

std::optional<Refusal> PageActs::onBoard(const SessionRequest& request, double time_s) {
    if (!frame_->panel || request.revision < first_revision_)
        return Refusal{409, "the board that this was done on is gone", "revision"};
    not_before_s_ = std::max(time_s, board_since_s_ + settle_s);
    const studies::Panel& panel = *frame_->panel;
    const auto middleOf = [this](const studies::PanelRect& box) {
        return rayTo(box.x + box.width / 2.0, box.y + box.height / 2.0);
    };
    if (request.kind == Kind::press) {
        const auto* const button = findPart(panel.buttons, request.id);
        if (button == nullptr || !button->enabled) return notEnabled("button", "button");
        press(middleOf(button->box));
    } else if (request.kind == Kind::slide) {
        const auto* const slider = findPart(panel.sliders, request.id);
        if (slider == nullptr || !slider->enabled) return notEnabled("slider", "slider");
        if (request.value < slider->low || request.value > slider->high)
            return Refusal{
                400, fmt::format("found {}, expected {} to {}", request.value, slider->low, slider->high),
                "value"};
        const studies::PanelRect track = slider->track();
        const double share = (request.value - slider->low) / std::max(1, slider->high - slider->low);
        press(rayTo(track.x + share * track.width, track.y + track.height / 2.0));
    } else {
        const auto* const field = findPart(panel.fields, request.id);
        if (field == nullptr || !field->enabled) return notEnabled("field", "field");
        if (!field->active) press(middleOf(field->box));
        Step away;
        away.erased = characters(field->text);
        Step typing;
        typing.typed = request.text;
        steps_.push_back(std::move(away));
        steps_.push_back(std::move(typing));
    }
    return std::nullopt;
}

std::optional<Refusal> PageActs::authored(const SessionRequest& request, double time_s) {
    const auto& task = frame_->authoring;
    if (!task || task->trial != request.trial)
        return Refusal{
            409, task ? fmt::format("trial {} is under way", task->trial) : "no trial is under way", "trial"};
    const bool finishes = request.kind == Kind::finish;
    if (finishes && frame_->state == studies::PresentedState::paused)
        return Refusal{409, "the session is paused"};
    if (finishes && !task->may_end_early && task->left_s > 0.0)
        return Refusal{409, "this trial may not end early: its time is not up"};
    Step step;
    step.work = studies::AuthoredWork{request.trial, projectOf(request), finishes};
    // The page counts as the session does: pauses left out.
    const double used_s = task->limit_s - task->left_s;
    for (const server::ToldEdit& edit : request.edits)
        step.notes.push_back(
            {studies::NoteKind::edit, edit.json, time_s - std::max(0.0, used_s - edit.at_s)});
    steps_.push_back(std::move(step));
    return std::nullopt;
}

bool PageActs::act(studies::InputFrame& input) {
    const Pose viewer = frame_ != nullptr ? frame_->stage_from_viewer : Pose{};
    const Vec3 eyes = eyesAt(viewer);
    input.stage_from_head = {eyes, viewer.orientation};
    input.pointer = Ray{eyes, Vec3(0.0, -1.0, 0.0)};  // the hand rests
    if (steps_.empty() || input.time_s < not_before_s_) return false;
    Step step = std::move(steps_.front());
    steps_.pop_front();
    if (step.pointer) {
        input.pointer = step.pointer;
        input.stage_from_head.orientation = looking(step.pointer->direction);
    }
    input.select = input.select_held = step.select;
    input.typed = std::move(step.typed);
    input.erased = step.erased;
    input.work = std::move(step.work);
    input.notes = std::move(step.notes);
    input.pause = step.pause;
    return steps_.empty();
}

}  // namespace deixis::app
