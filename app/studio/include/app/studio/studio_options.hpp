// What both commands of the studio take, beside how it is reached.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/program/parser.hpp"
#include "core/error.hpp"
#include "motion/speech_gestures/speech_gestures.hpp"
#include "server/api/studio_api.hpp"
#include "server/kept/kept_folder.hpp"
#include "speech/voice/voices.hpp"

namespace deixis::app {

struct StudioOptions {
    std::string folder;               ///< empty: the usual one
    std::vector<std::string> voices;  ///< NAME=PROGRAM or NAME:LANGUAGE=PROGRAM
    std::string avatar;               ///< a glTF or VRM file; empty: Deixis's own
    std::string gestures;             ///< weights of the model; empty: those that ship, where they do
};

/// `options` outlives the parsing.
void addStudioOptions(Parser command, StudioOptions& options);

/// $XDG_DATA_HOME/deixis/studio, or ~/.local/share/deixis/studio (XDG Base Directory Specification 0.8); none
/// where the environment tells neither.
[[nodiscard]] std::optional<std::filesystem::path> usualFolder();

/// The folder that was named, which is made; else the usual one, which is made when something is kept. Where
/// that cannot be used nothing is kept, and standard error says so.
[[nodiscard]] Result<std::optional<server::KeptFolder>> openFolder(const StudioOptions& options);

/// flite's, those that were named, and those of the helper beside this program, where it is. Errors: a voice
/// that is not written as above, a program that cannot be found, a name twice.
[[nodiscard]] Result<speech::Voices> studioVoices(const StudioOptions& options);

/// The avatar that was named, as it is drawn and as the page loads it; none: Deixis's own. Errors name the
/// file: what loadAvatar() says, and a file of more than largest_avatar_bytes.
struct StudioAvatar {
    server::DrawnAvatar drawn;
    std::string glb;
};
inline constexpr std::size_t largest_avatar_bytes = std::size_t{64} << 20U;
[[nodiscard]] Result<std::optional<StudioAvatar>> studioAvatar(const StudioOptions& options);

/// Those weights; none where none were named and none ship. Errors name the file.
[[nodiscard]] Result<std::optional<motion::SpeechGestureModel>> gestureModel(const StudioOptions& options);

}  // namespace deixis::app
