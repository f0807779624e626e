// A person's word on which joint plays which humanoid bone: a TOML file beside a clip, documented in
// docs/clip-format.md.
#pragma once

#include <filesystem>
#include <string>

#include "core/error.hpp"
#include "motion/humanoid_mapping.hpp"

namespace deixis::assets {

/// NAME.humanoid.toml for NAME.bvh, NAME.bvh.gz or any other clip.
[[nodiscard]] std::filesystem::path humanoidFileOf(const std::filesystem::path& clip);

/// Applies a file's words: bones it names play the joints it names ("" for none), whatever was found. Errors
/// name file, line, what was found and what was expected: unknown bones and joints, and a joint named for two
/// bones.
[[nodiscard]] Result<void> applyHumanoidFile(const std::filesystem::path& file,
                                             const motion::Skeleton& skeleton,
                                             motion::HumanoidMapping& mapping);
/// The same from text; `name` stands for the file in errors.
[[nodiscard]] Result<void> applyHumanoidText(std::string_view text, const std::string& name,
                                             const motion::Skeleton& skeleton,
                                             motion::HumanoidMapping& mapping);

/// The mapping of a clip's skeleton, with what the file beside the clip says, where there is one. `given`: as
/// for mapHumanoid.
[[nodiscard]] Result<motion::HumanoidMapping> mapClip(const std::filesystem::path& clip,
                                                      const motion::Skeleton& skeleton,
                                                      const motion::HumanoidMap* given = nullptr);

/// A whole mapping as such a file: every bone on a line of its own, "" where none was found.
[[nodiscard]] std::string humanoidToml(const motion::HumanoidMapping& mapping,
                                       const motion::Skeleton& skeleton);

}  // namespace deixis::assets
