// A lab's own voice: any program that reads a text and writes a WAV file.
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "speech/sound/sound.hpp"

namespace deixis::speech {

struct VoiceProgram {
    std::string name;
    /// The program, found as a shell finds it, and its arguments; there is no shell. It reads the text
    /// (UTF-8) from its standard input until that ends, writes a WAV file to its standard output and ends
    /// with 0.
    std::vector<std::string> command;
    std::chrono::milliseconds timeout{60'000};
    bool english = true;  ///< else its words are not looked for in its sound
};

/// The text in the program's words. It is given nothing but its three standard streams, and is stopped, with
/// what it has started, when its time is over. Any number may run at the same time.
/// Errors, naming the voice: a program that cannot be started, ends otherwise than with 0 (with the last line
/// that it wrote to its standard error), takes longer than `timeout`, or writes no sound that readWavBytes()
/// takes; those of checkText().
[[nodiscard]] Result<Sound> speakByProgram(const VoiceProgram& program, std::string_view text);

}  // namespace deixis::speech
