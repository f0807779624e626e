// Any bytes as a studio's project: refused, or what it wants fits a motion of any length or is refused, too.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "assets/projects/studio_project.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const auto project = deixis::assets::parseStudioProject(bytes, "fuzz.json");
    if (!project) return 0;
    for (const std::size_t frames : {std::size_t{1}, std::size_t{40}, std::size_t{4000}})
        static_cast<void>(deixis::assets::wantedOf(*project, frames));
    const auto again =
        deixis::assets::parseStudioProject(deixis::assets::withoutControls(bytes), "fuzz.json");
    if (!again) std::abort();
    return 0;
}
