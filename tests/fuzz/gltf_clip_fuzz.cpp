// Any bytes as a glTF file: a clip that keeps its promises, or an error. A small clip is written and read
// again.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "assets/gltf/gltf_clip.hpp"

using namespace deixis;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto file = assets::parseGltfClip(bytes, "fuzz.glb");
    if (!file) {
        if (file.error().text().empty()) std::abort();
        return 0;
    }
    const motion::Clip& clip = file->clip;
    if (clip.frames.empty() || clip.skeleton.joints.empty()) std::abort();
    if (clip.frames.size() * clip.skeleton.joints.size() > 2000) return 0;
    // writeGlb throws where the clip breaks its invariants.
    const auto again = assets::parseGltfClip(assets::writeGlb(clip), "again.glb");
    if (!again || again->clip.skeleton.size() < clip.skeleton.size()) std::abort();
    return 0;
}
