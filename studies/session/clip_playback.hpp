// One clip on the avatar: the pause before it, its time, and which of its frames were really shown.
#pragma once

#include <cstdint>
#include <optional>

#include "avatar_poser.hpp"
#include "studies/session/events.hpp"
#include "studies/session/session.hpp"

namespace deixis::studies {

/// What a frame report brought about.
enum class Shown : unsigned char {
    nothing,
    onset,  ///< the clip's first frame has been shown
    end     ///< the clip's last pose has been shown
};

class ClipPlayback {
  public:
    /// Both must outlive the playback.
    ClipPlayback(AvatarPoser& poser, const motion::LocalPose& idle) : poser_(poser), idle_(idle) {}

    /// `sound` is null where nothing is heard. Where it is longer than the clip the last pose is held.
    void load(const motion::Clip& clip, const ClipSound* sound);

    /// Begins the pause before the clip: the avatar relaxes, and gets into the clip's first pose at its end.
    void start(double length_s, double now_s);
    [[nodiscard]] double leadInLength_s() const { return length_s_; }

    /// One step of the pause; true when it is over and the clip is to be played.
    bool leadIn(double now_s);

    /// One step of the clip, in the frame of that number. It stands at its start until a frame of it has been
    /// shown: its time counts from there.
    void play(double now_s, std::uint64_t frame);
    [[nodiscard]] bool halfway() const { return halfway_; }
    /// What is heard in the frame played last; without the place of the mouth.
    [[nodiscard]] std::optional<SoundView> sound() const;

    /// A frame was shown at `at`.
    Shown shown(std::uint64_t frame, const Moment& at);
    [[nodiscard]] const Moment& onset() const { return *onset_; }  ///< once it was shown

  private:
    AvatarPoser& poser_;
    const motion::LocalPose& idle_;
    const motion::Clip* clip_ = nullptr;
    const ClipSound* sound_ = nullptr;
    double clip_time_s_ = 0.0;  ///< as played last
    double length_s_ = 0.0;
    double end_s_ = 0.0;
    bool approaching_ = false;  ///< the avatar is on its way to the clip's first pose
    bool halfway_ = false;
    std::optional<std::uint64_t> first_frame_;  ///< the first that presented the clip's start
    std::optional<std::uint64_t> last_frame_;   ///< the first that presented its end
    std::optional<Moment> onset_;
};

}  // namespace deixis::studies
