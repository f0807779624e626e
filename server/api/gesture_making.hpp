// Gestures to a speech, with what the request wants of them.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "motion/authoring/authored_gestures.hpp"
#include "studio_work.hpp"

namespace deixis::server {

/// Fields of a request: poses at some frames, style, a motion of which only a range is made anew, and how the
/// motion is finished.
[[nodiscard]] std::vector<ShapeField> controlFields();

/// How hands look where a motion becomes the avatar's.
[[nodiscard]] ShapeField relaxedFingersField();

struct MadeGestures {
    motion::UpperBodyMotion motion;
    nlohmann::json frames;  ///< as framesJson(), where what was asked for stands as it was asked, to the bit
};

/// Of a body that has the shape of those fields, and `seed`. Refuses controls that do not fit the speech, and
/// those that the system does not take.
[[nodiscard]] tl::expected<MadeGestures, Refusal> gesturesTo(const KeptSpeech& speech,
                                                             const StudioParts& parts,
                                                             const nlohmann::json& asked);

/// What gestures can be made by, and which of the fields that not all take it takes. The first is taken where
/// none is named: the trained model, where there is one.
struct GestureSystem {
    std::string name;
    bool synthetic = true;  ///< by rules, or by what was trained on them
    std::vector<std::string> takes;
};
[[nodiscard]] std::vector<GestureSystem> gestureSystems(const StudioParts& parts);

[[nodiscard]] motion::GestureParts gestureParts(const StudioParts& parts);
/// Where a motion begins and ends by itself.
[[nodiscard]] motion::UpperBodyPose restPose(const StudioParts& parts);

}  // namespace deixis::server
