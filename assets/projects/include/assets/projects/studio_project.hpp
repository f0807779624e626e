// Projects of the studio, as its page saves them (web/src/model/project.ts): what somebody authored for a
// speech.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/utterance.hpp"
#include "motion/authoring/authored_gestures.hpp"
#include "motion/upper_body/upper_body.hpp"

namespace deixis::assets {

inline constexpr int studio_project_version = 2;

/// Poses from a frame on.
struct ProjectPoses {
    int start = 0;
    int length = 1;                           ///< frames; `base` is shown at this length
    std::vector<motion::UpperBodyPose> base;  ///< at least one
};

/// Style of some frames. A curve's points are a share of them, 0 to 1, and a value, joined by straight lines;
/// one point is a constant; none leaves the style free.
struct ProjectStyle {
    struct Point {
        double at = 0.0;
        double value = 0.0;
    };
    int start = 0;
    int length = 1;
    std::array<std::vector<Point>, 3> curves;  ///< speed, space, handedness
};

struct StudioProject {
    std::string name;
    std::string author;              ///< a pseudonym; empty: not told
    std::string text;                ///< what is said
    std::string voice;               ///< of a speech that is not made yet; empty: the first one
    Utterance utterance;             ///< the words of a speech that is there
    std::string wav;                 ///< its sound, a file's bytes; empty: it has to be spoken by `voice`
    motion::UpperBodyMotion motion;  ///< without frames: it has to be made, by `system` of what is below
    std::string system;              ///< what made the gestures, or is to: "model", "rules" or "keyframes"
    bool synthetic = true;           ///< a motion that is there: by rules, or by what learned from them
    int pose_controls = 0;           ///< in use
    int style_controls = 0;
    bool relaxed_fingers = true;

    // What a motion is made of; not read where there is one.
    std::vector<ProjectPoses> poses;  ///< those in use
    std::vector<ProjectStyle> styles;
    std::uint64_t seed = 1;
    bool exact = false;
    double variety = 0.0;
    bool still = false;
    bool fade = false;
};

/// Errors name the file and the key: what is no project, of a newer version, or has neither a speech nor a
/// text that a voice can speak.
[[nodiscard]] Result<StudioProject> readStudioProject(const std::filesystem::path& file);
/// The same from memory; `name` stands for the file.
[[nodiscard]] Result<StudioProject> parseStudioProject(std::string_view bytes, const std::string& name);

/// What the studio would be asked for. Fails, naming the control, where one does not fit into that many
/// frames.
[[nodiscard]] Result<motion::WantedGestures> wantedOf(const StudioProject& project, std::size_t frames);

/// A project's file without its poses, styles and motion: what an author begins with. The bytes are a
/// project's.
[[nodiscard]] std::string withoutControls(std::string_view bytes);

}  // namespace deixis::assets
