// WAV files <-> sounds (Microsoft & IBM 1991, Multimedia Programming Interface and Data Specifications 1.0;
// WAVE_FORMAT_EXTENSIBLE: Microsoft's documentation of WAVEFORMATEXTENSIBLE).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "speech/sound/sound.hpp"

namespace deixis::speech {

/// Read are whole numbers of 8, 16, 24 and 32 bits and floating point of 32 and 64, of any number of
/// channels, whose mean is taken. Chunks that are not known are passed over. The size in the file's first
/// line is not looked at: its chunks have their own; a sound whose data has no known size (programs that
/// write into a pipe leave 0 or the highest number) goes on to the end. Floating point that goes beyond
/// -1 to 1 by less than 12 dB is made softer as a whole.
/// Errors: another format; chunks missing, contradicting each other or cut off; no samples; samples that are
/// no numbers or far too loud; rates and durations beyond those of Sound.
[[nodiscard]] Result<Sound> readWav(const std::filesystem::path& path);
/// The same from memory. `name` stands for the file in errors.
[[nodiscard]] Result<Sound> readWavBytes(std::string_view bytes, const std::string& name);

/// A WAV file of one channel, 16 bits. What was read from such a file comes out with the same samples.
[[nodiscard]] std::string wavBytes(const Sound& sound);
/// writeFile() of it: never half a file. Errors: as there.
[[nodiscard]] Result<void> writeWav(const std::filesystem::path& path, const Sound& sound);

}  // namespace deixis::speech
