// A trained policy: from what it sees to the targets of the body's actuators. A network of fully connected
// layers with rectified units between them, in Eigen.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "motion/networks/layers.hpp"

namespace deixis::physics {

class Policy {
  public:
    /// Reads the arrays NAME.input_mean and .input_sd, NAME.layer0, NAME.layer1, ... and NAME.output_mean and
    /// .output_sd. `hidden`: numbers of units between the layers. Fails, naming the file and the array, where
    /// one is missing or of another shape.
    [[nodiscard]] static Result<Policy> read(const motion::NetworkWeights& weights, const std::string& name,
                                             int inputs, std::span<const int> hidden, int outputs);

    [[nodiscard]] std::size_t inputs() const { return static_cast<std::size_t>(input_mean_.size()); }
    /// `seen`: what BodyObserver and writeGoal() write. One target for each hinge, radians.
    void act(std::span<const float> seen, std::span<double> targets_rad) const;

  private:
    motion::VectorXf input_mean_;
    motion::VectorXf input_sd_;
    std::vector<motion::Linear> layers_;
    motion::VectorXf output_mean_;
    motion::VectorXf output_sd_;
};

/// Standardised inputs are cut off at so many standard deviations.
constexpr float largest_input = 5.0F;

}  // namespace deixis::physics
