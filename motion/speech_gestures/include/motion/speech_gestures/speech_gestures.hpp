// Speech gestures by the controllable model of Yoon et al. (2021): from a speech's sound and words, and from
// what somebody wants of them: poses at some frames, and style.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "core/utterance.hpp"
#include "motion/gestures/gesture_style.hpp"
#include "motion/speech_gestures/gesture_inputs.hpp"
#include "motion/speech_gestures/gesture_network.hpp"
#include "motion/speech_gestures/pose_control.hpp"

namespace deixis::motion {

/// Wishes for the style at a frame, in standard deviations of the training motions from their mean, clamped
/// to
/// [-3, 3]. 0 is the mean; what is not set is left to the model.
struct StyleControl {
    std::optional<double> speed{};
    std::optional<double> space{};
    std::optional<double> handedness{};
};

/// Frames from `begin` to before `end`.
struct FrameRange {
    int begin = 0;
    int end = 0;
};

/// A motion of which only some frames are to be made anew.
struct KeptMotion {
    UpperBodyMotion motion;           ///< as long as the one asked for
    std::vector<FrameRange> changed;  ///< all other frames come back to the bit
};

struct SpeechGestureRequest {
    std::span<const float> samples{};  ///< of the sound, mono, 16 kHz
    Utterance utterance{};             ///< its words
    double duration_s = 0.0;           ///< above 0; the motion has frameCountOf() of it
    std::vector<PoseControl> poses{};
    std::vector<StyleControl> styles{};  ///< one a frame, or none at all; they count on posed frames, too
    std::optional<KeptMotion> keep{};
    /// Poses are met to the bit, by meetPoses(). False: as near as the model comes to them.
    bool exact = false;
    /// The model itself draws nothing: the same request gives the same motion. With `variety` above 0 each
    /// element of style that is not set is drawn from a normal distribution with this standard deviation (1:
    /// as different as the training motions are), anew every two seconds and in between along a line. `seed`
    /// counts for that alone.
    double variety = 0.0;
    std::uint64_t seed = 0;
};

class SpeechGestureModel {
  public:
    /// Fails, naming the file, where the weights are of another architecture or incomplete.
    [[nodiscard]] static Result<SpeechGestureModel> read(const NetworkWeights& weights);
    [[nodiscard]] static Result<SpeechGestureModel> load(const std::filesystem::path& file);

    /// Long speeches are made by windows of 60 frames that overlap by 30. The frames in which a window
    /// overlaps the one before are pose controls for it, and there the motion passes from the one to the
    /// other along a minimum-jerk course. A pose that only the later window sees frees the last second before
    /// it. Fails, naming what, where controls are of frames that there are not, of wrong lengths or not
    /// finite; and where there are any for weights that were trained without controls.
    [[nodiscard]] Result<UpperBodyMotion> generate(const SpeechGestureRequest& request) const;

    [[nodiscard]] const UpperBodyPose& meanPose() const { return mean_pose_; }  ///< of the training motions
    /// Of the training motions' windows: what style controls are relative to.
    [[nodiscard]] const StyleNorm& styleNorm() const { return style_norm_; }
    [[nodiscard]] bool takesControls() const { return network_.shape().controls; }
    [[nodiscard]] const WordVectors& words() const { return words_; }
    /// Whether it was trained on gestures that nobody made.
    [[nodiscard]] bool synthetic() const { return synthetic_; }

  private:
    GestureNetwork network_;
    WordVectors words_;
    UpperBodyPose mean_pose_;
    VectorXf mean_;  ///< its 27 numbers
    StyleNorm style_norm_;
    bool synthetic_ = true;
};

/// The settings and arrays that SpeechGestureModel::read() takes beside the network's.
void appendPosture(const UpperBodyPose& mean_pose, const StyleNorm& norm, NetworkWeights& weights);

}  // namespace deixis::motion
