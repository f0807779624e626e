// English voices of flite (Black & Lenzo 2001, "Flite: a small fast run-time synthesis engine"), in this
// process.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "speech/voice/speech.hpp"
#include "speech/voice/written_words.hpp"

namespace deixis::speech {

/// Of 16 kHz: "slt" (a woman, US; statistical, as the next ones), "rms" (a man, US), "awb" (a man, Scottish)
/// and "kal16" (a man, US; diphones, like a machine, and 30 times as fast). The first is the one to begin
/// with.
[[nodiscard]] const std::vector<std::string>& fliteVoices();

struct SpeakOptions {
    double rate = 1.0;  ///< 0.5 to 2: how fast against the voice's own rate
};

/// The text in a voice's words. A written word that is spoken as several ("250") lasts from the first to the
/// last of them. The same text, voice and rate give the same samples: flite's noise comes from rand(), which
/// is set and put back here, so that only another thread that calls rand() meanwhile could change it. flite
/// has data of its own that its calls share: one text is spoken at a time, others wait. Errors, naming
/// `where`: those of writtenWords(); another voice or rate; a speech that is longer than max_sound_s.
[[nodiscard]] Result<Speech> speakByFlite(std::string_view text, std::string_view voice,
                                          const SpeakOptions& options = {},
                                          const std::string& where = "text");

/// One syllable of a word as flite would say it: phones as in CMU's dictionary ("AH", "NG"), without stress.
struct PronouncedSyllable {
    std::vector<std::string> phones;
    bool stressed = false;
};

/// One spoken word: "hundred" of "250".
struct PronouncedWord {
    std::string text;  ///< small letters
    std::vector<PronouncedSyllable> syllables;
};

/// The spoken words of each written word, by flite's rules for numbers and abbreviations, its dictionary and
/// its letter-to-sound rules; none for what it does not say. Likewise one at a time.
[[nodiscard]] std::vector<std::vector<PronouncedWord>> pronunciationOf(const std::vector<WrittenWord>& words);

}  // namespace deixis::speech
