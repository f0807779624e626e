#include "session_core.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "studies/study_file/standing.hpp"

namespace deixis::studies {

namespace {

constexpr double settle_s = 0.4;
constexpr Vec3 mouth_in_head(0.0, 0.03, 0.1);  // of an adult, from the joint between neck and head

}  // namespace

double keyTime(const InputFrame& input) {
    return input.input_time_s.value_or(input.time_s);
}

double selectTime(const InputFrame& input) {
    return input.select_time_s.value_or(keyTime(input));
}

double earliestKeyTime(const InputFrame& input) {
    return input.read_before_s.value_or(keyTime(input));
}

double earliestSelectTime(const InputFrame& input) {
    return input.select_time_s.value_or(earliestKeyTime(input));
}

SessionCore::SessionCore(const Study& study_in, const ClipSource& clips_in, const motion::Skeleton& avatar_in,
                         const motion::LocalPose& idle_in, bool keyboard_in, std::string hint_in)
    : study(study_in),
      clips(clips_in),
      avatar(avatar_in),
      idle(idle_in),
      keyboard(keyboard_in),
      hint(std::move(hint_in)),
      poser(avatar_in, idle_in),
      right_poser(avatar_in, idle_in),
      head_joint_(static_cast<std::size_t>(std::max(0, avatar_in.find("head")))) {}

bool SessionCore::settled() const {
    return now.time_s - panel_since_s >= settle_s;
}

Moment SessionCore::momentAt(double time_s) const {
    return {time_s, now.utc_s + time_s - now.time_s};
}

const motion::Clip& SessionCore::clipOf(const Stimulus& stimulus) const {
    const motion::Clip& clip = clips.clip(stimulus);
    if (clip.frames.empty() || clip.frames.front().joints.size() != avatar.joints.size())
        throw std::invalid_argument(
            fmt::format("the clip of system '{}' for item '{}' does not have the avatar's joints",
                        stimulus.system, stimulus.item));
    return clip;
}

double SessionCore::eyeHeight(const InputFrame& input) const {
    const double head_m = input.stage_from_head.position.y;
    const bool plausible = head_m > 0.9 && head_m < 2.2;
    return plausible ? head_m : study.eye_height_m;
}

Vec3 SessionCore::eyes(const InputFrame& input) const {
    return view.frame.stage_from_viewer.position + Vec3(0.0, eyeHeight(input), 0.0);
}

void SessionCore::note(NoteKind kind, std::string detail) {
    noteAt(now, kind, std::move(detail));
}

void SessionCore::noteAt(const Moment& at, NoteKind kind, std::string detail) {
    events.push_back(Note{kind, trial_index, at, std::move(detail)});
}

void SessionCore::openPanel(Panel panel, const InputFrame& input, PanelPlace place) {
    view.openPanel(std::move(panel), eyeHeight(input), std::move(place));
    panel_since_s = now.time_s;
}

Panel SessionCore::endConfirmation(const std::string& text) const {
    return messagePanel(words()("end_title"), text, "",
                        {{words()("go_back"), button_id::back},
                         {words()("end_yes"), button_id::end_for_good, ButtonRole::leave}},
                        -1.0, hint);
}

void SessionCore::standAlone() {
    pair = false;
    poser.standAt(Vec3(0.0));
    view.frame.right_avatar_joints.clear();
}

void SessionCore::standAsPair() {
    const auto places = pairPlaces(view.frame.stage_from_viewer);
    if (!pair) right_poser.blendTo(idle, now.time_s - AvatarPoser::blend_s);
    pair = true;
    poser.standAt(places[0]);
    right_poser.standAt(places[1]);
}

void SessionCore::advanceAvatars() {
    poser.advance(now.time_s);
    right_poser.advance(now.time_s);
}

void SessionCore::writeAvatars() {
    poser.write(view.frame.avatar_joints);
    if (pair) right_poser.write(view.frame.right_avatar_joints);
}

const Pose& SessionCore::avatarHead(bool on_right) const {
    return (on_right ? view.frame.right_avatar_joints : view.frame.avatar_joints).at(head_joint_);
}

void SessionCore::placeSound() {
    if (!view.frame.sound) return;
    SoundView& sound = *view.frame.sound;
    sound.mouth = transformPoint(avatarHead(sound.on_right), mouth_in_head);
}

void AnswerGate::open(std::uint64_t frame) {
    frame_ = frame;
    shown_s_.reset();
}

void AnswerGate::shown(std::uint64_t frame, double at_s) {
    if (frame_ && frame >= *frame_ && !shown_s_) shown_s_ = at_s;
}

}  // namespace deixis::studies
