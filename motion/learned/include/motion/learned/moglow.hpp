// Systems that play trained networks. Each is made from its file of weights.
//
// `moglow`: a conditional normalising flow that draws one frame after another (Henter, Alexanderson & Beskow
// 2020), controlled by the target and by whether the figure is to point (Deichler et al. 2023, section
// 2.4.1.1).
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"
#include "motion/networks/flow.hpp"
#include "motion/synthesis/generator.hpp"
#include "motion/synthesis/pose_features.hpp"

namespace deixis::motion {

inline constexpr const char* moglow_architecture = "moglow";

/// What a model is like apart from its numbers. Frames are frames at the model's rate.
struct MoglowShape {
    int steps = 8;  ///< K, of the flow
    int hidden =
        128;  ///< H, of each LSTM layer, and of what all that a frame is conditioned on is reduced to
    int past_frames = 10;  ///< poses before a frame that it is conditioned on
    int look_ahead = 0;    ///< frames after it whose pointing bits are known, too
    double frame_time_s = 0.05;

    /// Numbers that a frame of `features` numbers is conditioned on.
    [[nodiscard]] int conditionSize(int features) const { return past_frames * features + 3 + bits(); }
    [[nodiscard]] int bits() const { return past_frames + 1 + look_ahead; }
};

/// Frames with the figure's control.
struct ControlledFrames {
    Vec3 target{0.0};            ///< metres
    std::vector<bool> pointing;  ///< one a frame: from where the hand leaves rest to where it starts back
    std::vector<std::vector<double>> features;  ///< standardised, one row a frame
};

/// What frame `at` is conditioned on: the poses before it, the oldest first, each `at_ease` where there is
/// none; the target; the pointing bits from the oldest of those poses to the look-ahead, off outside.
[[nodiscard]] std::vector<float> moglowCondition(const ControlledFrames& frames, std::size_t at,
                                                 std::span<const double> at_ease, const MoglowShape& shape);

class Moglow {
  public:
    /// Fails, naming the file, where the weights are of another architecture, of another body's joints or
    /// incomplete.
    [[nodiscard]] static Result<Moglow> of(const NetworkWeights& weights, const PoseFeatures& features);

    [[nodiscard]] const MoglowShape& shape() const { return shape_; }
    /// Draws frames, as many as pointing bits, from a figure at ease. Not standardised: for PoseFeatures.
    [[nodiscard]] std::vector<std::vector<double>> draw(const Vec3& target, std::vector<bool> pointing,
                                                        Random& random) const;
    /// Log-likelihood of each frame given those before, in nats, of the standardised numbers.
    [[nodiscard]] std::vector<double> logLikelihoods(const ControlledFrames& frames) const;
    [[nodiscard]] std::vector<double> standardised(std::span<const double> features) const;

    /// How long it points where nobody says so: means of its training data.
    [[nodiscard]] double raise_s() const { return raise_s_; }
    [[nodiscard]] double hold_s() const { return hold_s_; }

  private:
    [[nodiscard]] VectorXf condition(const ControlledFrames& frames, std::size_t at) const;

    MoglowShape shape_;
    double raise_s_ = 0.0;
    double hold_s_ = 0.0;
    double temperature_ = 1.0;
    VectorXf mean_;
    VectorXf sd_;
    std::vector<double> at_ease_;  ///< standardised
    Linear encoder_;
    ConditionalFlow flow_;
};

/// The system. Its clips begin at ease; rests before and after are played with the pointing bit off, and the
/// phases are found in the clip (detectPhases()), or where nothing is found are those that were asked for.
/// `unsteadiness_m` of a request is not in its control and is left.
[[nodiscard]] Result<std::unique_ptr<Generator>> makeMoglow(const NetworkWeights& weights,
                                                            const Skeleton& avatar);
/// The same from a file.
[[nodiscard]] Result<std::unique_ptr<Generator>> loadMoglow(const std::filesystem::path& weights,
                                                            const Skeleton& avatar);

}  // namespace deixis::motion
