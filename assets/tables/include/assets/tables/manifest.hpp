// A manifest: the clips of one or more systems, and the target for which each was made. CSV, documented in
// docs/manifest.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"
#include "motion/skeleton/gesture_phases.hpp"

namespace deixis::assets {

/// Of what a target's coordinates are: the clip's, or the figure's as it stands in the clip's first frame
/// (motion/pointing/placement.hpp).
enum class TargetFrame : unsigned char { clip, figure };

/// What was done to clips that are as a simulated body moved (docs/learning.md).
inline constexpr std::string_view physics_projected = "physics-projected";
/// Of clips that a system has made which was learned from demonstrations that nobody made.
inline constexpr std::string_view learned_from_synthetic = "learned-from-synthetic";
/// Of clips that were made by rules or formulas.
inline constexpr std::string_view made_by_rules = "synthetic";

/// One clip. Gestures that point at nothing have no target, and none of the phases.
struct ManifestRow {
    std::string clip;  ///< file, relative to the manifest
    std::string system;
    std::string target_id;
    std::optional<Vec3> target{};  ///< metres
    TargetFrame target_frame = TargetFrame::clip;
    std::optional<motion::GesturePhases> phases{};
    double fps = 30.0;
    std::uint64_t seed = 0;
    /// Where the clip was retargeted: the error of its pointing ray as recorded, and on the avatar; degrees.
    std::optional<double> source_error_deg{};
    std::optional<double> avatar_error_deg{};
    std::string author{};        ///< who made it, where people do; empty: not known
    std::optional<int> trial{};  ///< which of the author's trials it came from, from 1
    std::string processing{};    ///< what was done to the clip, such as physics_projected; empty: nothing
    std::string sound{};         ///< WAV file of what is said, relative to the manifest; empty: nothing is
    std::size_t line = 0;        ///< of the file on which the row begins; 0: it comes from no file
};

struct Manifest {
    std::filesystem::path file;
    std::vector<ManifestRow> rows;
};

/// Reads and checks a manifest: header, numbers, frames in order. Columns may stand in any order; those that
/// a manifest does not know are skipped. Errors name file, line and column. Whether the clips are there
/// is not looked at.
[[nodiscard]] Result<Manifest> readManifest(const std::filesystem::path& path);
/// The same with every problem: of a broken row its first, of a broken header that alone.
[[nodiscard]] tl::expected<Manifest, std::vector<Error>> checkManifest(const std::filesystem::path& path);
/// The first problem alone, from text; `name` stands for the file in errors and in the result.
[[nodiscard]] Result<Manifest> parseManifest(std::string_view text, const std::filesystem::path& name);
/// Header and rows, with those of the optional columns that a row has a value in; every number with as many
/// digits as bring the same number back.
[[nodiscard]] std::string manifestCsv(const std::vector<ManifestRow>& rows);

}  // namespace deixis::assets
