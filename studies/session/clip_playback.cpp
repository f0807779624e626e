#include "clip_playback.hpp"

#include <algorithm>

namespace deixis::studies {

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
        poser_.show(*clip_, 0.0);
        return;
    }
    const double clip_time_s = std::clamp(now_s - onset_->time_s, 0.0, clip_->duration_s());
    poser_.show(*clip_, clip_time_s);
    halfway_ = clip_time_s >= clip_->duration_s() / 2.0;
    if (clip_time_s >= clip_->duration_s() && !last_frame_) last_frame_ = frame;
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
