// A lab's own demonstrations: a manifest's clips on the avatar.
#pragma once

#include <filesystem>
#include <string>

#include "assets/avatar/avatar.hpp"
#include "assets/tables/manifest.hpp"
#include "core/error.hpp"
#include "learning/training/training.hpp"

namespace deixis::app {

/// An error that says nothing of a file, as one of that file.
[[nodiscard]] Error inFile(Error error, const std::string& file);

/// A manifest of at least one clip, each with a target.
[[nodiscard]] Result<assets::Manifest> readDemonstrations(const std::string& file);

/// The row's clip on the avatar; the row then is of that.
[[nodiscard]] Result<motion::Clip> demonstrationClip(const std::filesystem::path& file,
                                                     const assets::Avatar& avatar, assets::ManifestRow& row);

/// What a training knows: of a manifest, or without one of the synthetic demonstrations. With `mirrored` also
/// their mirror images. Phases that a row does not name are found in its clip.
[[nodiscard]] Result<learning::DemonstrationSets> demonstrationSets(const std::string& manifest,
                                                                    const assets::Avatar& avatar,
                                                                    bool mirrored);

/// This program, for what it trains.
[[nodiscard]] learning::Provenance programProvenance();

}  // namespace deixis::app
