// Accents: which syllables of a speech stand out.
#pragma once

#include <vector>

#include "core/utterance.hpp"
#include "speech/sound/sound.hpp"
#include "speech/voice/speech.hpp"

namespace deixis::speech {

/// Stressed syllables that are higher, louder or longer than what is within a second around them. How far one
/// stands out is the sum of how many times 2 semitones its highest pitch, 4 dB its loudest frame and half an
/// octave its duration (before a pause, less its usual lengthening of 1.4) are above the medians there, each
/// at least 0 and at most 2, pitch counted twice; an accent has 1 or more (2 in a weak word), and no
/// neighbour within 0.15 s that has more. Its strength is 1 - exp(-sum / 3). That pitch, loudness and
/// duration tell accents, and pitch most of all: Terken & Hermes 2000, "The perception of prosodic
/// prominence"; the weights and limits are ours. `pitch` and `loudness` are of that sound (pitch.hpp);
/// syllables in order.
[[nodiscard]] std::vector<Accent> accentsOf(const std::vector<Syllable>& syllables,
                                            const std::vector<double>& pitch,
                                            const std::vector<double>& loudness);

}  // namespace deixis::speech
