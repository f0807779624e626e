// A lab's own voice: any program that reads a text and writes a WAV file.
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "speech/sound/sound.hpp"
#include "speech/voice/speech.hpp"

namespace deixis::speech {

struct VoiceProgram {
    std::string name;
    /// The program, found as a shell finds it, and its arguments; there is no shell. It reads the text
    /// (UTF-8) from its standard input until that ends, writes a WAV file to its standard output and ends
    /// with 0.
    std::vector<std::string> command;
    std::chrono::milliseconds timeout{60'000};
    /// As in BCP 47: "en", "de", "pt-br". In other languages than English words are not looked for in the
    /// sound.
    std::string language{"en"};
    /// Before the WAV file it writes a line "START END WORD" for each word, with times in seconds, and an
    /// empty line.
    bool tells_words = false;
};

/// "en", and its kinds such as "en-gb".
[[nodiscard]] bool isEnglish(std::string_view language);

/// The text in the program's words. It is given nothing but its three standard streams, and is stopped, with
/// what it has started, when its time is over. Any number may run at the same time.
/// Errors, naming the voice: a program that cannot be started, ends otherwise than with 0 (with the last line
/// that it wrote to its standard error), takes longer than `timeout`, or writes no sound that readWavBytes()
/// takes; those of checkText().
[[nodiscard]] Result<Sound> speakByProgram(const VoiceProgram& program, std::string_view text);

/// The same with the words that a program tells, which must lie in order and within the sound. Each word is
/// taken for one stressed syllable, so that what stands out in the sound can be found. A program that tells
/// none gives the sound's duration only.
[[nodiscard]] Result<Speech> speechByProgram(const VoiceProgram& program, std::string_view text);

/// What such a program wrote. `where` stands before errors.
[[nodiscard]] Result<Speech> readToldSpeech(std::string_view bytes, const std::string& where);

}  // namespace deixis::speech
