// Clips of manifests, read and measured one by one on all cores; each thread holds at most one clip.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "app/program/progress_line.hpp"
#include "assets/tables/manifest.hpp"
#include "core/error.hpp"
#include "motion/pointing/accuracy.hpp"
#include "results/evaluation/evaluation.hpp"

namespace deixis::app {

struct ClipToMeasure {
    std::filesystem::path file;
    assets::ManifestRow row;  ///< with a target
};

struct MeasuredClips {
    std::vector<results::MeasuredClip> clips;  ///< in the order given
    std::string motion_digest;                 ///< SHA-256 over elbow and hand positions, to the micrometre
};

/// Measures all clips on `threads` threads (at least 1); the result does not depend on their number. Every
/// clip that cannot be measured is told, in order; each error names its file.
[[nodiscard]] tl::expected<MeasuredClips, std::vector<Error>> measureClips(
    const std::vector<ClipToMeasure>& clips, const motion::AccuracyRule& rule, unsigned threads,
    const Progress& progress);

}  // namespace deixis::app
