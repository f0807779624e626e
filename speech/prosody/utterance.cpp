#include "speech/prosody/utterance.hpp"

#include <fmt/format.h>

#include <utility>

#include "speech/prosody/accents.hpp"
#include "speech/prosody/pitch.hpp"

namespace deixis::speech {

SpokenText recordedSound(Sound sound) {
    SpokenText out;
    out.utterance.duration_s = durationOf(sound);
    out.pitch = pitchOf(sound);
    out.loudness = loudnessOf(sound);
    out.sound = std::move(sound);
    return out;
}

Result<SpokenText> recordedText(Aligner& aligner, Sound sound, std::string_view text,
                                const std::string& where) {
    auto alignment = aligner.align(sound, text, where);
    if (!alignment) return tl::unexpected(alignment.error());
    SpokenText out = recordedSound(std::move(sound));
    out.utterance.words = std::move(alignment->words);
    out.utterance.accents = accentsOf(alignment->syllables, out.pitch, out.loudness);
    return out;
}

Result<SpokenText> spokenText(const Voices& voices, Aligner* aligner, std::string_view text,
                              std::string_view voice, const SpeakOptions& options) {
    auto speech = voices.speak(text, voice, options);
    if (!speech) return tl::unexpected(speech.error());
    const VoiceProgram* const program = voices.program(voice);
    if (program != nullptr && isEnglish(program->language) && !program->tells_words) {
        const std::string where = fmt::format("voice \"{}\"", program->name);
        if (aligner == nullptr)
            return fail(where, "the words in its sound cannot be found without PocketSphinx's model",
                        "Install Debian's package pocketsphinx-en-us");
        return recordedText(*aligner, std::move(speech->sound), text, where);
    }
    SpokenText out = recordedSound(std::move(speech->sound));
    out.utterance.words = std::move(speech->utterance.words);
    out.utterance.accents = accentsOf(speech->syllables, out.pitch, out.loudness);
    return out;
}

}  // namespace deixis::speech
