// Any bytes as a table of words or as a TextGrid: refused, or words in order of time.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "learning/corpus/transcript.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    const auto words = data[0] % 2 == 0 ? deixis::learning::parseWordTable(bytes, "fuzz.csv")
                                        : deixis::learning::parseTextGrid(bytes, "fuzz.TextGrid");
    if (!words) return 0;
    for (const auto& word : *words)
        if (word.text.empty() || !std::isfinite(word.start_s) || !std::isfinite(word.end_s) ||
            word.start_s < 0.0 || word.end_s < word.start_s)
            std::abort();
    for (std::size_t i = 1; i < words->size(); ++i)
        if ((*words)[i].start_s < (*words)[i - 1].start_s) std::abort();
    return 0;
}
