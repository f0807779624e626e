// A model of speech gestures in numbers, as the studio uses it: whole speeches, at run time's precision (Yoon
// et al. 2021, section 5.3 and table 1).
#pragma once

#include <functional>
#include <vector>

#include "learning/gesture_scores/gesture_takes.hpp"
#include "learning/gesture_scores/motion_encoder.hpp"
#include "learning/gesture_scores/scores.hpp"
#include "motion/speech_gestures/speech_gestures.hpp"

namespace deixis::learning {

struct GestureEvaluation {
    GestureScores scores;
    /// Between directions that were asked for and those that came, mean over the posed frames and bones.
    double posed_off_deg = 0.0;
    /// The same with the option exact, the largest one.
    double exact_off_deg = 0.0;
    int parts = 0;  ///< of 30 frames, that were looked at
};

/// Each take is generated as a whole, without controls, with poses and with styles, and its motion looked at
/// in parts of 30 frames; what is left at its end is not looked at. Posed are the frames 10 to 14 of each
/// part, by the take's own poses; styles are those of the take's motion at each frame, relative to the
/// model's mean and standard deviation. FGD is by `encoder`. A model without controls is scored without.
/// Fails where a take cannot be generated or is too short, and with fewer than two parts.
[[nodiscard]] Result<GestureEvaluation> evaluateGestures(
    const motion::SpeechGestureModel& model, const MotionEncoder& encoder,
    const std::vector<GestureTake>& takes,
    const std::function<void(std::size_t done, std::size_t count)>& progress = {});

/// The same of a motion that is always the model's mean pose.
[[nodiscard]] Result<GestureEvaluation> evaluateMeanPose(const motion::SpeechGestureModel& model,
                                                         const MotionEncoder& encoder,
                                                         const std::vector<GestureTake>& takes);

/// Controls of a take's own motion, as evaluateGestures() gives them.
[[nodiscard]] std::vector<motion::PoseControl> evaluationPoses(const motion::UpperBodyMotion& motion);
[[nodiscard]] Result<std::vector<motion::StyleControl>> evaluationStyles(
    const motion::UpperBodyMotion& motion, const motion::StyleNorm& norm);

}  // namespace deixis::learning
