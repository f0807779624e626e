#include "built_in_clips.hpp"

#include <fmt/format.h>

#include <string>

#include "app/clips/generation.hpp"
#include "app/clips/systems.hpp"
#include "app/program/version.hpp"
#include "core/hash.hpp"
#include "made_folder.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

Result<void> makeClips(const studies::SystemSource& system, std::uint64_t seed,
                       const std::vector<assets::ListedTarget>& targets, const assets::Avatar& maker,
                       const motion::HoldSettings& settings, const fs::path& folder) {
    const auto made_by = makeSystem(system.generator, "", maker.skeleton);
    if (!made_by) return tl::unexpected(made_by.error());
    const auto rows = generateClips(*made_by, targets, seed, settings, folder, true, false);
    if (!rows) return tl::unexpected(rows.error());
    return {};
}

}  // namespace

Result<fs::path> builtInManifest(const studies::SystemSource& system, std::uint64_t seed,
                                 const std::vector<assets::ListedTarget>& targets,
                                 const assets::Avatar& maker, const fs::path& folder) {
    const auto source = systemSource(system.generator);
    if (!source) return tl::unexpected(source.error());
    const motion::HoldSettings settings{system.hold_s, system.unsteadiness_m};
    // Another version of the program may make other clips.
    std::string made_from = fmt::format("{}\n{}\n{}\n{}\n{}\n", programVersion(), system.generator, seed,
                                        *source, maker.content_hash);
    if (settings.hold_s) made_from += fmt::format("hold {}\n", *settings.hold_s);
    if (settings.unsteadiness_m) made_from += fmt::format("unsteadiness {}\n", *settings.unsteadiness_m);
    for (const auto& [id, target] : targets)
        made_from += fmt::format("{} {} {} {}\n", id, target.x, target.y, target.z);
    const std::string key = sha256Hex(made_from);
    const fs::path clips = folder / fmt::format("{}-{}", system.generator, key.substr(0, 12));
    return madeOnce(clips, [&](const fs::path& making) {
        return makeClips(system, seed, targets, maker, settings, making);
    });
}

}  // namespace deixis::app
