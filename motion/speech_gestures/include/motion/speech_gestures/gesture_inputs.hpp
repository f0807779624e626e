// What the gesture model sees of a speech, the same in training and at run time: its sound, and vectors of
// its words.
#pragma once

#include <Eigen/Core>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/utterance.hpp"
#include "motion/networks/weights_file.hpp"

namespace deixis::motion {

constexpr int speech_rate_hz = 16000;  ///< of the samples that are given

// The sound's encoder: four convolutions without padding, whose strides make one vector a frame: 5 x 6 x 6 x
// 6 = 1080. A frame of 1/15 s has 1066 2/3 samples at 16 kHz, so that the encoder hears the sound at 16.2
// kHz: each frame then has its own vector wherever a window begins.
constexpr int sound_kernel = 15;
constexpr std::array<int, 4> sound_strides{5, 6, 6, 6};
constexpr int sound_samples_per_frame = 1080;
constexpr int sound_samples_heard = 3025;  ///< by a frame's vector, half of them before the frame's time

/// At 16.2 kHz, by cubic interpolation (no alias: the rate rises), and as loud as every other speech: the
/// root mean square of the parts in which there is sound is 1. Silence stays silence.
[[nodiscard]] std::vector<float> heardSound(std::span<const float> samples_16khz);
/// What the encoder needs for the frames `first` to `first + count - 1` of a heard sound; zeros outside of
/// it.
[[nodiscard]] std::vector<float> heardAround(std::span<const float> heard, int first, int count);

/// Vectors of common words.
class WordVectors {
  public:
    WordVectors() = default;
    /// A column for each word; the first of equal words counts. Throws where there are not as many columns as
    /// words.
    WordVectors(std::vector<std::string> words, Eigen::MatrixXf vectors);

    /// Numbers of a vector.
    [[nodiscard]] int size() const { return static_cast<int>(vectors_.rows()); }
    [[nodiscard]] int count() const { return static_cast<int>(words_.size()); }
    /// Case does not matter, nor punctuation around or in the word; of "it's" the part before the apostrophe
    /// is taken where the whole is not known. Zeros for an unknown word.
    [[nodiscard]] Eigen::VectorXf vectorOf(std::string_view word) const;
    [[nodiscard]] bool knows(std::string_view word) const;

    /// As the settings "words" and the array "word_vectors" (count x size).
    void append(NetworkWeights& weights) const;
    [[nodiscard]] static Result<WordVectors> read(const NetworkWeights& weights);

  private:
    [[nodiscard]] std::map<std::string, int, std::less<>>::const_iterator find(std::string_view word) const;

    std::vector<std::string> words_;
    std::map<std::string, int, std::less<>> places_;
    Eigen::MatrixXf vectors_;
};

/// A column for each of `frames`: a word's vector at the frame in which it starts, or the next one that has
/// no word yet; zeros elsewhere.
[[nodiscard]] Eigen::MatrixXf wordFrames(const Utterance& utterance, const WordVectors& vectors, int frames);

}  // namespace deixis::motion
