// What the commands that change clips write: clip files in the format that their name asks for, and
// complete folders, never half of one.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "assets/tables/manifest.hpp"
#include "core/error.hpp"
#include "core/staging.hpp"
#include "motion/skeleton/clip.hpp"

namespace deixis::app {

/// Whether the name ends as one of the formats in which clips are written.
[[nodiscard]] bool isClipFile(const std::filesystem::path& file);

/// The clip as the contents of a file of that name. Fails on an ending that no format has, and on a skeleton
/// that the format cannot hold.
[[nodiscard]] Result<std::string> clipBytes(const motion::Clip& clip, const std::filesystem::path& file);

/// The clip as a file, over one that exists.
[[nodiscard]] Result<void> writeClip(const motion::Clip& clip, const std::filesystem::path& file);

/// A clip file's name without the endings of its format: "a/T1.bvh.gz" -> "T1".
[[nodiscard]] std::string clipStem(const std::filesystem::path& file);

/// A folder of clips and manifests in the making. The files lie in a hidden folder inside it until `finish`
/// moves them all to their places, manifests last; whatever ends the work before leaves none of them.
class OutputFolder {
  public:
    /// `force`: files that are there already are replaced. `durable`: what finish() has moved is on the disk,
    /// which clips that can be made again need not wait for.
    OutputFolder(std::filesystem::path folder, bool force, bool durable = true);

    /// Before any work: fails if one of these exists already, and `force` was not given.
    [[nodiscard]] Result<void> expect(const std::vector<std::filesystem::path>& names) const;
    /// Before any work: where each of a manifest's clips goes in this folder, as BVH: as beside its manifest,
    /// never outside, with a number where a name is taken. Fails as `expect` does, with the new manifest, and
    /// if this is the clips' own folder.
    [[nodiscard]] Result<std::vector<std::filesystem::path>> expectClipsOf(
        const assets::Manifest& manifest) const;
    /// `name` is relative to the folder. Fails if it exists already, and `force` was not given.
    [[nodiscard]] Result<void> add(const std::filesystem::path& name, std::string_view bytes);
    [[nodiscard]] Result<void> finish();

  private:
    std::filesystem::path folder_;
    bool force_;
    bool durable_;
    std::optional<Staging> staging_{};  ///< made for the first file
    std::set<std::filesystem::path> names_;
};

}  // namespace deixis::app
