// Any bytes as a WAV file: refused, or a sound within its limits.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "speech/sound/wav.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    namespace speech = deixis::speech;
    const auto sound = speech::readWavBytes({reinterpret_cast<const char*>(data), size}, "fuzz.wav");
    if (!sound) return 0;
    if (sound->rate_hz < speech::min_rate_hz || sound->rate_hz > speech::max_rate_hz) std::abort();
    if (sound->samples.empty() || durationOf(*sound) > speech::max_sound_s) std::abort();
    for (const float sample : sound->samples)
        if (!(std::abs(sample) <= 1.0F)) std::abort();
    // Written as 16 bits, the same sound is read again.
    if (speech::readWavBytes(speech::wavBytes(*sound), "fuzz.wav")->samples.size() != sound->samples.size())
        std::abort();
    return 0;
}
