#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/files.hpp"
#include "speech/sound/wav.hpp"

namespace deixis::speech {

namespace {

void append(std::string& out, std::uint32_t number, unsigned bytes) {
    for (unsigned i = 0; i < bytes; ++i) out += static_cast<char>(number >> (8U * i) & 0xFFU);
}

}  // namespace

std::string wavBytes(const Sound& sound) {
    const auto size = static_cast<std::uint32_t>(2 * sound.samples.size());
    const auto rate = static_cast<std::uint32_t>(sound.rate_hz);
    std::string out = "RIFF";
    append(out, 36 + size, 4);
    out += "WAVEfmt ";
    append(out, 16, 4);
    append(out, 1, 2);  // PCM
    append(out, 1, 2);  // one channel
    append(out, rate, 4);
    append(out, 2 * rate, 4);
    append(out, 2, 2);
    append(out, 16, 2);
    out += "data";
    append(out, size, 4);
    for (const float sample : sound.samples) {
        const double level = std::clamp(std::round(static_cast<double>(sample) * 32768.0), -32768.0, 32767.0);
        append(out, static_cast<std::uint16_t>(static_cast<std::int16_t>(level)), 2);
    }
    return out;
}

Result<void> writeWav(const std::filesystem::path& path, const Sound& sound) {
    return writeFile(path, wavBytes(sound));
}

}  // namespace deixis::speech
