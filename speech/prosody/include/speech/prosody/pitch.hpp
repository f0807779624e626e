// The melody of a voice, and how loud it is, a hundred times a second.
#pragma once

#include <vector>

#include "speech/sound/sound.hpp"

namespace deixis::speech {

inline constexpr int prosody_frames_per_s = 100;
inline constexpr double lowest_pitch_hz = 60.0;
inline constexpr double highest_pitch_hz = 500.0;

/// Frame i is at i / 100 s; there are as many as begin within the sound.
[[nodiscard]] std::size_t prosodyFramesOf(const Sound& sound);

/// In Hz; 0 where there is none: silence, breath, noise, unvoiced sounds. By the normalised difference
/// function of YIN (de Cheveigné & Kawahara 2002, steps 2, 3 and 5) over 25 ms; of each frame's minima, and
/// of no pitch, those are taken that together cost least, where leaps cost (as Boersma 1993 chooses among
/// autocorrelation's peaks), so that a frame does not fall into another octave than its neighbours.
[[nodiscard]] std::vector<double> pitchOf(const Sound& sound);

inline constexpr double silence_db = -100.0;

/// In dB, 0 for a mean square of 1 (a full sine has -3.01); silence_db at the least. Over 25 ms, Hann's
/// window.
[[nodiscard]] std::vector<double> loudnessOf(const Sound& sound);

}  // namespace deixis::speech
