// The routes of version 1 of the studio: speech, gestures to it, and the library of unit gestures.
// docs/studio.md says how they are used, and /v1/openapi.json what each takes and answers.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "motion/skeleton/skeleton.hpp"
#include "motion/speech_gestures/speech_gestures.hpp"
#include "motion/unit_gestures/unit_gesture.hpp"
#include "server/http/route.hpp"
#include "server/kept/kept_folder.hpp"
#include "speech/voice/voices.hpp"

namespace deixis::server {

/// Another avatar than Deixis's own: in the T pose, its bones with VRM names, without rest rotations.
struct DrawnAvatar {
    motion::Skeleton skeleton;
    motion::HumanoidMap humanoid;
};

/// A session of a study that the page takes part in.
struct StudySession {
    std::string participant;
    std::string study;     ///< its name
    std::string language;  ///< that its texts are in
    std::vector<Route> routes;
};

/// What the routes work with.
struct StudioParts {
    std::string version;  ///< of the program
    std::string commit;
    motion::GestureLibrary library;
    std::optional<motion::SpeechGestureModel> model{};  ///< none: gestures are by rules
    speech::Voices voices{};
    /// Speeches are kept in memory; above this the one that was used least recently is forgotten.
    std::size_t kept_speech_bytes = std::size_t{256} << 20U;
    std::optional<DrawnAvatar> avatar{};  ///< none: Deixis's own is drawn
    /// Where motions, rules and projects are kept; none: they are not.
    std::optional<KeptFolder> folder{};
    std::optional<StudySession> session{};
};

/// They may be called from several threads, and keep what they need.
[[nodiscard]] std::vector<Route> studioRoutes(StudioParts parts);

}  // namespace deixis::server
