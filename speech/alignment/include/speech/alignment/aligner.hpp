// Forced alignment: when each word of a known English text is heard in a recording of it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/utterance.hpp"
#include "speech/sound/sound.hpp"
#include "speech/voice/speech.hpp"

namespace deixis::speech {

/// Times to 10 ms.
struct Alignment {
    std::vector<SpokenWord> words;    ///< as written, without those that are not spoken
    std::vector<Syllable> syllables;  ///< in order; by flite's pronunciation of the words
};

/// By PocketSphinx's acoustic model of US English (Huggins-Daines et al. 2006) and CMU's dictionary; words
/// that it lacks are pronounced as flite does. Silence may lie between any two words. First the words are
/// aligned, then their phones.
class Aligner {
  public:
    /// Where Debian's package pocketsphinx-en-us has the model.
    [[nodiscard]] static std::filesystem::path usualModel();

    /// The model's folder has en-us/mdef and cmudict-en-us.dict. Takes some 0.2 s and 60 MB; one is enough
    /// for a program, whose threads may share it: one sound is aligned at a time. What PocketSphinx logs is
    /// silenced. Errors: files that are not there or cannot be read.
    [[nodiscard]] static Result<Aligner> load(const std::filesystem::path& model = usualModel());

    Aligner(Aligner&&) noexcept;
    Aligner& operator=(Aligner&&) noexcept;
    ~Aligner();

    /// The sound has the text's words, in their order, and no others. Takes a thirtieth to a tenth of the
    /// sound's duration. Errors, naming `where`: those of writtenWords(); a sound that is too short for the
    /// text; one in which the text's words are not found, or are found where something else is heard:
    /// silence, noise, other words.
    [[nodiscard]] Result<Alignment> align(const Sound& sound, std::string_view text,
                                          const std::string& where = "recording");

  private:
    struct State;
    explicit Aligner(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace deixis::speech
