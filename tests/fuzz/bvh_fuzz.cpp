// Any bytes as a clip file called .bvh: whatever kind their content tells, mostly BVH.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "assets/joints/clip_import.hpp"
#include "clip_invariants.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    deixis::fuzz::checkClip(deixis::assets::importClipBytes(text, "fuzz.bvh"));
    return 0;
}
