// Gestures to a speech as somebody wants them: by the trained model, by rules or by keyframes, with poses and
// styles at some frames.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/speech_gestures/speech_gestures.hpp"
#include "motion/unit_gestures/unit_gesture.hpp"

namespace deixis::motion {

/// What gestures are made by (Yoon et al. 2021, section 7: AUTO and SGT are by the model, MANUAL by
/// keyframes).
enum class GestureMaker : unsigned char { model, rules, keyframes };
[[nodiscard]] std::string_view gestureMakerName(GestureMaker maker);  ///< "model", "rules", "keyframes"
[[nodiscard]] std::optional<GestureMaker> gestureMakerFromName(std::string_view name);

struct WantedGestures {
    GestureMaker maker = GestureMaker::model;
    std::vector<PoseControl> poses{};
    std::vector<StyleControl> styles{};  ///< one a frame, or none; not with keyframes
    std::optional<KeptMotion> keep{};    ///< one range that is made anew; not with keyframes
    bool exact = false;                  ///< of the model: others meet poses in any case
    double variety = 0.0;                ///< of the model
    std::uint64_t seed = 1;
    bool still = false;  ///< holdStill()
    bool fade = false;   ///< fadeTo() the mean pose, from the last word or pose on
};

struct GestureSpeech {
    std::span<const float> samples{};  ///< mono, speech_rate_hz; of the model alone
    Utterance utterance{};
};

struct GestureParts {
    const GestureLibrary& library;
    const SpeechGestureModel* model = nullptr;  ///< null: there is none

    /// Where a motion begins and ends by itself: the mean pose of the model's training motions; without a
    /// model the body at ease.
    [[nodiscard]] const UpperBodyPose& restPose() const;
};

/// frameCountOf() the speech's duration. Poses must have passed checkPoses(), and none may stand at a frame
/// that is kept. Fails where there is no model for GestureMaker::model, and as SpeechGestureModel::generate()
/// does.
[[nodiscard]] Result<UpperBodyMotion> gesturesTo(const GestureSpeech& speech, const GestureParts& parts,
                                                 const WantedGestures& wanted);

/// The poses that a motion meets to the bit: those of the frames that are kept, and, but where the model is
/// to come near them alone, those that are wanted.
[[nodiscard]] std::vector<PoseControl> metPoses(const WantedGestures& wanted);

}  // namespace deixis::motion
