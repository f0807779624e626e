// Demonstrations as the frames that a model learns.
#pragma once

#include <vector>

#include "learning/moglow/training.hpp"

namespace deixis::learning {

/// Mean and standard deviation of each number over the demonstrations' frames; the deviation at least 0.01
/// rad, below which a number is hardly more than noise.
struct FeatureScale {
    std::vector<double> mean;
    std::vector<double> sd;

    [[nodiscard]] std::vector<double> standardised(const std::vector<double>& features) const;
};
[[nodiscard]] FeatureScale scaleOf(const std::vector<motion::Demonstration>& demonstrations,
                                   const motion::PoseFeatures& features);

/// A demonstration at the model's rate, with rest added before and after.
[[nodiscard]] motion::ControlledFrames framesOf(const motion::Demonstration& demonstration,
                                                const motion::PoseFeatures& features,
                                                const FeatureScale& scale, const MoglowSettings& settings);

/// Mean seconds of a phase over demonstrations.
[[nodiscard]] double meanRaise_s(const std::vector<motion::Demonstration>& demonstrations);
[[nodiscard]] double meanHold_s(const std::vector<motion::Demonstration>& demonstrations);

}  // namespace deixis::learning
