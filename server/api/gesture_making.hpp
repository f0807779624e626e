// Gestures to a speech, with what the request wants of them.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "motion/upper_body/upper_body.hpp"
#include "studio_work.hpp"

namespace deixis::server {

/// Fields of a request: poses at some frames, style, and a motion of which only a range is made anew.
[[nodiscard]] std::vector<ShapeField> controlFields();

struct MadeGestures {
    motion::UpperBodyMotion motion;
    nlohmann::json frames;  ///< as framesJson(), where what was asked for stands as it was asked, to the bit
};

/// Of a body that has the shape of those fields, and `seed`. Refuses controls that do not fit the speech, and
/// those that the system does not take.
[[nodiscard]] tl::expected<MadeGestures, Refusal> gesturesTo(const KeptSpeech& speech,
                                                             const motion::GestureLibrary& library,
                                                             const nlohmann::json& asked);

}  // namespace deixis::server
