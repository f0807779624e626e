#include <algorithm>

#include "speech/sound/sound.hpp"

namespace deixis::speech {

std::vector<Peaks> envelopeOf(const Sound& sound, std::size_t columns) {
    const std::size_t count = sound.samples.size();
    if (count == 0) return {};
    std::vector<Peaks> out(columns);
    for (std::size_t i = 0; i < columns; ++i) {
        const std::size_t first = i * count / columns;
        const std::size_t last = std::max(first + 1, (i + 1) * count / columns);
        const auto [low, high] =
            std::minmax_element(sound.samples.begin() + first, sound.samples.begin() + last);
        out[i] = {*low, *high};
    }
    return out;
}

}  // namespace deixis::speech
