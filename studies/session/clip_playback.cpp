#include "clip_playback.hpp"

#include <algorithm>

namespace deixis::studies {

void ClipPlayback::load(const motion::Clip& clip, const ClipSound* sound) {
    clip_ = &clip;
    sound_ = sound;
}

void ClipPlayback::start(double length_s, double now_s) {
    length_s_ = std::max(length_s, 2.0 * AvatarPoser::blend_s);
    end_s_ = now_s + length_s_;
    approaching_ = false;
    halfway_ = false;
    first_frame_.reset();
    last_frame_.reset();
    onset_.reset();
    poser_.blendTo(idle_, now_s);
}

bool ClipPlayback::leadIn(double now_s) {
    poser_.advance(now_s);
    if (approaching_) return !poser_.blending();
    if (now_s >= end_s_ - AvatarPoser::blend_s) {
        approaching_ = true;
        poser_.blendTo(clip_->frames.front(), now_s);
    }
    return false;
}

void ClipPlayback::play(double now_s, std::uint64_t frame) {
    if (!first_frame_) first_frame_ = frame;
    if (!onset_) {
        clip_time_s_ = 0.0;
        poser_.show(*clip_, 0.0);
        return;
    }
    const double length_s = std::max(clip_->duration_s(), sound_ != nullptr ? sound_->duration_s : 0.0);
    clip_time_s_ = std::clamp(now_s - onset_->time_s, 0.0, length_s);
    poser_.show(*clip_, clip_time_s_);
    halfway_ = clip_time_s_ >= length_s / 2.0;
    if (clip_time_s_ >= length_s && !last_frame_) last_frame_ = frame;
}

std::optional<SoundView> ClipPlayback::sound() const {
    if (sound_ == nullptr || clip_time_s_ >= sound_->duration_s) return std::nullopt;
    return SoundView{sound_->id, clip_time_s_};
}

Shown ClipPlayback::shown(std::uint64_t frame, const Moment& at) {
    if (!onset_) {
        if (!first_frame_ || frame < *first_frame_) return Shown::nothing;
        onset_ = at;
        return Shown::onset;
    }
    if (!last_frame_ || frame < *last_frame_) return Shown::nothing;
    return Shown::end;
}

}  // namespace deixis::studies
