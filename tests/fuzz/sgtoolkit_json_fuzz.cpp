// Any bytes as the SGToolkit's JSON.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "assets/joints/joint_positions.hpp"
#include "clip_invariants.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    deixis::fuzz::checkClip(deixis::assets::parseSgToolkitJson(text, "fuzz.json"));
    return 0;
}
