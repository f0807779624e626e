// A speech with all that gestures are made from: the sound, its words, its accents and its melody.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/utterance.hpp"
#include "speech/alignment/aligner.hpp"
#include "speech/sound/sound.hpp"
#include "speech/voice/voices.hpp"

namespace deixis::speech {

struct SpokenText {
    Sound sound;
    Utterance utterance;        ///< no words and accents where the voice does not tell them and its language
                                ///< is not English
    std::vector<double> pitch;  ///< as pitchOf()
    std::vector<double> loudness;  ///< as loudnessOf()
};

/// The text in a voice's words. `aligner` finds the words of voices that are programs; null where it could
/// not be loaded, which is then an error for those. Errors: those of Voices::speak() and Aligner::align().
[[nodiscard]] Result<SpokenText> spokenText(const Voices& voices, Aligner* aligner, std::string_view text,
                                            std::string_view voice, const SpeakOptions& options = {});

/// A recording and the English text that is said in it. Errors: those of Aligner::align().
[[nodiscard]] Result<SpokenText> recordedText(Aligner& aligner, Sound sound, std::string_view text,
                                              const std::string& where = "recording");

/// A recording without a text, of any language: its duration and melody. For models that work from sound
/// alone.
[[nodiscard]] SpokenText recordedSound(Sound sound);

}  // namespace deixis::speech
