// Voices of other languages by a helper program, which stands beside this one and is talked to by pipes
// alone.
#pragma once

#include <filesystem>
#include <vector>

#include "core/error.hpp"
#include "speech/voice/voice_program.hpp"

namespace deixis::speech {

/// One voice "espeak-LANGUAGE" for each language but English that the helper tells. It is called with --list,
/// and writes a line "LANGUAGE NAME" for each; or with --language LANGUAGE, and is then a program that tells
/// words. Errors: it cannot be started, fails, or tells none.
[[nodiscard]] Result<std::vector<VoiceProgram>> voicesOfHelper(const std::filesystem::path& helper);

}  // namespace deixis::speech
