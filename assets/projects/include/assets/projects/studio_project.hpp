// Projects of the studio, as its page saves them (web/src/model/project.ts): what somebody authored for a
// speech.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "core/utterance.hpp"
#include "motion/upper_body/upper_body.hpp"

namespace deixis::assets {

inline constexpr int studio_project_version = 2;

struct StudioProject {
    std::string name;
    std::string text;     ///< what is said
    Utterance utterance;  ///< its words, without accents
    std::string wav;      ///< the sound, a file's bytes
    motion::UpperBodyMotion motion;
    std::string system;     ///< what made the gestures: "model", "rules" or "keyframes"
    bool synthetic = true;  ///< by rules, or by what learned from them
    int pose_controls = 0;  ///< in use
    int style_controls = 0;
    bool relaxed_fingers = true;
};

/// Errors name the file and the key: what is no project, of a newer version, or has no speech or no motion
/// yet.
[[nodiscard]] Result<StudioProject> readStudioProject(const std::filesystem::path& file);
/// The same from memory; `name` stands for the file.
[[nodiscard]] Result<StudioProject> parseStudioProject(std::string_view bytes, const std::string& name);

}  // namespace deixis::assets
