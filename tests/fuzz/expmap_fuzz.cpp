// Any bytes as rows of exponential maps.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "assets/joints/expmap_rows.hpp"
#include "clip_invariants.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    deixis::fuzz::checkClip(deixis::assets::parseExpmapRows(text, "fuzz.txt"));
    return 0;
}
