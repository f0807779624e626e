// Making a system's clips for a list of targets: BVH files and a manifest.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "app/clips/systems.hpp"
#include "assets/tables/manifest.hpp"
#include "assets/tables/target_list.hpp"
#include "core/error.hpp"

namespace deixis::app {

/// One BVH file per target and, last, `manifest.csv`, all of them or none. Files that are there already are
/// replaced only where `force` says so; `durable` as in OutputFolder.
[[nodiscard]] Result<std::vector<assets::ManifestRow>> generateClips(
    const System& system, const std::vector<assets::ListedTarget>& targets, std::uint64_t seed,
    const motion::HoldSettings& settings, const std::filesystem::path& folder, bool force,
    bool durable = true);

}  // namespace deixis::app
