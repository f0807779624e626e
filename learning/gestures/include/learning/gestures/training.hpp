// Training of the controllable speech gestures of Yoon et al. (2021), section 5 and appendix A.2: controls
// simulated from the motions themselves, the losses of equation 7, and the scores by which weights are
// chosen.
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/error.hpp"
#include "learning/gesture_scores/gesture_takes.hpp"
#include "learning/gesture_scores/gesture_training.hpp"
#include "learning/training/training.hpp"
#include "motion/speech_gestures/speech_gestures.hpp"

namespace deixis::learning {

/// The paper's where it states them; sizes are cut to what two cores train on two hours of speech in an hour.
struct GestureSettings {
    motion::GestureShape shape{.sound_channels = 8,
                               .sound_size = 32,
                               .word_size = 100,
                               .word_channels = 64,
                               .word_levels = 4,
                               .text_size = 32,
                               .hidden = 160,
                               .layers = 2,
                               .controls = true};
    int discriminator_hidden = 64;
    int discriminator_layers = 2;  ///< the paper's 4
    int stride = 20;  ///< frames from one window to the next; each epoch moves each by less than that
    int epochs = 40;  ///< the paper: 80
    int batch = 128;  ///< windows an update
    double learning_rate = 5e-4;
    /// From this share of the training on the rate falls along a line to a twentieth. Not in the paper: it
    /// takes the place of larger networks and more epochs.
    double decay_from = 0.4;
    double beta = 0.5;  ///< Adam's first; not stated
    double huber_weight = 500.0;
    double huber_limit = 0.1;  ///< difference of directions from which the loss grows linearly; not stated
    double gan_weight = 5.0;
    /// How much more posed frames count in the Huber loss than others. Not in the paper, likewise.
    double pose_weight = 3.0;
    int gan_after = 10;  ///< epochs without the adversarial loss
    /// The paper's is 0.05, over all frames, beside a Huber loss whose limit it does not state; with ours
    /// that is some ten times larger, and the style would be lost beside it. Ours is over what is controlled:
    /// what nobody asked for cannot be known, and would be drawn to its median, a motion that is hardly one.
    double style_weight = 2.0;
    /// With this probability, each for itself, a window has pose controls and style controls.
    double control_share = 0.5;
    /// Windows that pass through some poses of another one, which are their pose controls, as users' poses
    /// are not what the speech suggests. Not in the paper: where poses always fit the speech, a model need
    /// not look at them.
    double foreign_share = 0.2;
    double dropout = 0.1;            ///< between the GRU's layers; not stated
    int autoencoder_updates = 1500;  ///< of what FGD looks at motions with
    int validate_every = 1;          ///< epochs
    std::uint64_t seed = 1;
    int threads = 2;
};

/// Trains, and writes the best weights to `file` whenever there are better ones, in float16: those with the
/// lowest score (GestureScores::score()). Beside it stands FILE.training, written at each validation and when
/// it is stopped, from which a training of the same settings and takes goes on; it is removed after the last
/// epoch. With `shape.controls` false it is the paper's baseline. Fails without takes, where a take has no
/// frame or no sound, where FILE.training is of another training, and where the training diverges: the last
/// good weights are kept.
[[nodiscard]] Result<GestureOutcome> trainGestures(const GestureTakes& takes, const GestureSettings& settings,
                                                   const Provenance& provenance,
                                                   const std::filesystem::path& file,
                                                   const GestureCallbacks& callbacks);

}  // namespace deixis::learning
