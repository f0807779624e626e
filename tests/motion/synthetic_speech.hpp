// Speeches without sound: words with times and accents, as a speaker's might be.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "core/utterance.hpp"

namespace deixis::tests {

/// Sentences of about 3 words a second with short pauses; six of ten content words have an accent. A twelfth
/// of the words have a rule.
inline Utterance syntheticSpeech(std::uint64_t seed, double duration_s) {
    constexpr std::array<const char*, 14> plain{"the", "a",   "of",  "and",   "we",  "it",  "is",
                                                "to",  "for", "but", "think", "was", "our", "with"};
    constexpr std::array<const char*, 20> content{"policy",   "morning", "student", "coffee",  "music",
                                                  "weather",  "problem", "doctor",  "garden",  "engine",
                                                  "solution", "kitchen", "lesson",  "market",  "village",
                                                  "reason",   "market",  "winter",  "teacher", "bridge"};
    constexpr std::array<const char*, 5> ruled{"big", "future", "rising", "idea", "round"};
    Random random(seed, "synthetic speech");
    Utterance out;
    out.duration_s = duration_s;
    double t = 0.3;
    while (t < duration_s - 3.0) {
        const int words = 5 + static_cast<int>(random.below(8));
        for (int i = 0; i < words; ++i) {
            const double draw = random.uniform();
            const bool is_plain = draw < 0.38;
            const char* text = is_plain      ? plain[random.below(plain.size())]
                               : draw < 0.92 ? content[random.below(content.size())]
                                             : ruled[random.below(ruled.size())];
            const double length_s = is_plain ? random.uniform(0.10, 0.22) : random.uniform(0.28, 0.55);
            out.words.push_back({text, t, t + length_s});
            if (!is_plain && random.uniform() < 0.8) {
                const double syllable_s = random.uniform(0.13, 0.24);
                const double begin_s = t + random.uniform(0.0, length_s - syllable_s);
                out.accents.push_back({begin_s, begin_s + syllable_s, random.uniform(0.05, 1.0),
                                       static_cast<int>(out.words.size()) - 1});
            }
            t += length_s;
        }
        t += random.uniform(0.25, 0.6);
    }
    return out;
}

}  // namespace deixis::tests
