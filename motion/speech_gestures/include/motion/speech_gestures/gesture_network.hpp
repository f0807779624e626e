// The network of controllable speech gestures (Yoon et al. 2021, section 4), for a window of frames. The
// sound by four convolutions, the words by dilated convolutions over time, and the controls go frame by frame
// into a bidirectional GRU, whose states become directions.
//
// Where the paper says nothing, this is ours: batch normalisation (folded here) and leaky rectified units
// after the first three convolutions of the sound; of the words each level sees as much of the future as of
// the past, and adds what it finds to what it got.
#pragma once

#include <vector>

#include "motion/networks/sequence_layers.hpp"
#include "motion/upper_body/upper_body.hpp"

namespace deixis::motion {

inline constexpr const char* speech_gestures_architecture = "speech-gestures";

/// Frames of a window, and by how many two neighbours overlap (appendix A.1).
constexpr int gesture_window = 60;
constexpr int gesture_overlap = 30;

constexpr float sound_slope = 0.3F;   ///< of the sound's leaky rectified units
constexpr float output_slope = 0.2F;  ///< of the one between the GRU and the directions
constexpr int word_kernel = 3;  ///< taps of each level of the words' convolutions; level i is dilated by 2^i

/// Rows of a frame's controls: a pose relative to the mean pose and its mask; three elements of style and a
/// mask for each. What is not set is 0.
constexpr int control_pose = 0;
constexpr int control_pose_mask = 27;
constexpr int control_style = 28;
constexpr int control_style_mask = 31;
constexpr int control_numbers = 34;

/// Sizes of the network: in the weights' header under these names. The paper's: 16, 32, 300, 4, 32, 300, 4.
struct GestureShape {
    int sound_channels =
        16;  ///< of the sound's first convolution; the next ones have twice and four times as many
    int sound_size = 32;      ///< numbers of a frame's sound
    int word_size = 100;      ///< numbers of a word's vector
    int word_channels = 300;  ///< of the words' convolutions
    int word_levels = 4;      ///< of them
    int text_size = 32;       ///< numbers of a frame's words
    int hidden = 300;         ///< of each GRU
    int layers = 4;           ///< of GRUs
    bool controls = true;     ///< false: the baseline without controls

    [[nodiscard]] int inputs() const { return sound_size + text_size + (controls ? control_numbers : 0); }
    [[nodiscard]] std::array<int, 5> soundChannels() const {
        return {1, sound_channels, 2 * sound_channels, 4 * sound_channels, sound_size};
    }
    bool operator==(const GestureShape&) const = default;
};
void appendShape(const GestureShape& shape, NetworkWeights& weights);
[[nodiscard]] Result<GestureShape> readShape(const NetworkWeights& weights);

class GestureNetwork {
  public:
    [[nodiscard]] static Result<GestureNetwork> read(const NetworkWeights& weights,
                                                     const GestureShape& shape);

    [[nodiscard]] const GestureShape& shape() const { return shape_; }
    /// A column for each frame of what heardAround() gives.
    [[nodiscard]] MatrixXf encodeSound(const std::vector<float>& heard_around) const;
    /// A column of 27 numbers for each frame: the pose relative to the mean pose. `sound` is from
    /// encodeSound(), `words` from wordFrames(); `controls` has control_numbers rows, or none where the shape
    /// has none.
    [[nodiscard]] MatrixXf forward(const MatrixXf& sound, const MatrixXf& words,
                                   const MatrixXf& controls) const;

  private:
    [[nodiscard]] MatrixXf encodeWords(const MatrixXf& words) const;

    GestureShape shape_;
    std::vector<Convolution> sound_;
    Linear word_entry_;
    std::vector<Convolution> words_;
    Linear text_;
    BidirectionalGru gru_;
    Linear middle_;
    Linear output_;
};

}  // namespace deixis::motion
