// What may be wrong with a clip, before a participant sees it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "assets/joints/clip_import.hpp"

namespace deixis::app {

struct ClipProblem {
    bool fatal;  ///< the clip cannot be used; else somebody should look at it
    std::string text;
};

/// All at once: missing bones, limbs without length, jumps, feet below the floor, an unlikely size or
/// mapping, a single frame, and the importer's remarks. `file`: the clip's, beside which a word on its bones
/// would lie; `map`: which joint plays which bone (clip_files.hpp).
[[nodiscard]] std::vector<ClipProblem> clipProblems(const assets::ImportedClip& imported,
                                                    const std::filesystem::path& file,
                                                    const motion::HumanoidMap& map);

}  // namespace deixis::app
