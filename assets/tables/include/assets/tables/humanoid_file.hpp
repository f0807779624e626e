// A user's file that says which joint is which humanoid bone, and how tall an avatar is: TOML beside a
// clip or an avatar, documented in docs/clip-format.md and docs/avatar.md.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/humanoid/mapping.hpp"

namespace deixis::assets {

/// NAME.humanoid.toml for NAME.bvh, NAME.bvh.gz, NAME.glb or any other clip or avatar.
[[nodiscard]] std::filesystem::path humanoidFileOf(const std::filesystem::path& clip);

/// How tall an avatar may be said to be, metres.
constexpr double min_height_m = 0.3, max_height_m = 3.0;

/// What such a file says.
struct HumanoidWords {
    struct Word {
        motion::Bone bone;
        std::string joint;  ///< its name; empty: the bone has none
        int line;
    };
    std::string file;
    std::vector<Word> words{};
    std::optional<double> height_m{};  ///< of an avatar
    std::string text{};                ///< the whole file
};
/// Errors name file, line, what was found and what was expected: unknown bones, values of another kind, a
/// joint named for two bones, a height that no figure has. `name` stands for the file.
[[nodiscard]] Result<HumanoidWords> parseHumanoidText(std::string_view text, const std::string& name);
/// What the file beside a clip or an avatar says; none if there is no such file.
[[nodiscard]] Result<std::optional<HumanoidWords>> humanoidWordsBeside(const std::filesystem::path& clip);

/// Bones that are named play the joints that are named, whatever was found. Fails on joints that the skeleton
/// lacks.
[[nodiscard]] Result<void> applyHumanoidWords(const HumanoidWords& said, const motion::Skeleton& skeleton,
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
