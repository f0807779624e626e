// Voices: who can speak a text here, and how it sounds. flite's English ones and a lab's own programs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "speech/voice/flite_voice.hpp"
#include "speech/voice/speech.hpp"
#include "speech/voice/voice_program.hpp"

namespace deixis::speech {

/// Const calls may come from several threads.
class Voices {
  public:
    /// Errors: a program without a name or command, or with the name of another voice.
    [[nodiscard]] static Result<Voices> with(std::vector<VoiceProgram> programs);
    /// flite's alone.
    Voices() = default;

    /// fliteVoices(), then the programs' in their order. The first is the one to begin with.
    [[nodiscard]] std::vector<std::string> names() const;

    /// Of a voice: "en" of flite's.
    [[nodiscard]] std::string language(std::string_view name) const;

    /// The program of this name; null for flite's voices and unknown names.
    [[nodiscard]] const VoiceProgram* program(std::string_view name) const;

    /// By a program, the utterance has what speechByProgram() says, and the rate must be 1: a program takes
    /// no options. Errors: an unknown voice; those of speakByFlite() and speakByProgram().
    [[nodiscard]] Result<Speech> speak(std::string_view text, std::string_view name,
                                       const SpeakOptions& options = {}) const;

  private:
    std::vector<VoiceProgram> programs_;
};

}  // namespace deixis::speech
