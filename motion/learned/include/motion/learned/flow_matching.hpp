// The system `flow`: conditional flow matching (Lipman, Chen, Ben-Hamu, Nickel & Le 2023) over whole
// trajectories of gestures. What a Gaussian process says of a target is the middle; a network draws what
// gestures differ in from it, as weights of a few directions in which the demonstrations do.
#pragma once

#include <memory>
#include <optional>

#include "core/random.hpp"
#include "motion/networks/layers.hpp"
#include "motion/networks/weights_file.hpp"
#include "motion/synthesis/gesture_trajectories.hpp"

namespace deixis::motion {

inline constexpr const char* flow_architecture = "flow";

/// What a model is like apart from its numbers.
struct FlowMatchingShape {
    int directions = 40;
    int hidden = 128;  ///< units of each of the two hidden layers
    int steps = 32;    ///< Euler steps from noise to a draw
    /// SD of the noise that a draw begins with: with 1, steps and a smooth network lose some of the spread.
    double noise = 1.0;

    /// Numbers that the network sees: the weights so far, the time from 0 to 1, what is seen of the target.
    [[nodiscard]] int inputs() const { return directions + 1 + 3; }
};

class FlowMatching {
  public:
    /// Fails, naming the file, where the weights are of another architecture, of another body's joints or
    /// incomplete.
    [[nodiscard]] static Result<FlowMatching> of(const NetworkWeights& weights,
                                                 GestureTrajectories trajectories);

    [[nodiscard]] const GestureTrajectories& trajectories() const { return trajectories_; }
    [[nodiscard]] const GaussianProcess& process() const { return *process_; }
    /// A trajectory for a target on the right hand's side. `guided`: in the second half of the steps what is
    /// predicted is moved, as little as the directions' own spread allows, to where the line from the eyes
    /// through the fingertip meets the target, by the body's kinematics and a line search.
    [[nodiscard]] std::vector<double> draw(const Vec3& target_m, Random& random, bool guided) const;
    /// The middle of what is drawn without guidance, were the directions' weights 0.
    [[nodiscard]] std::vector<double> middle(const Vec3& target_m) const;

  private:
    explicit FlowMatching(GestureTrajectories trajectories) : trajectories_(std::move(trajectories)) {}
    [[nodiscard]] VectorXf predicted(const VectorXf& weights, double time, const VectorXf& seen) const;
    [[nodiscard]] std::vector<double> trajectoryOf(const std::vector<double>& middle,
                                                   const VectorXf& weights) const;
    [[nodiscard]] VectorXf aimed(VectorXf weights, const std::vector<double>& middle,
                                 const Vec3& target_m) const;

    GestureTrajectories trajectories_;
    FlowMatchingShape shape_;
    std::optional<GaussianProcess> process_;
    MatrixXf directions_;  ///< a column each: what a weight of 1 adds to a trajectory
    Linear first_, second_, last_;
};

/// The system. `seed` draws another gesture for the same target.
[[nodiscard]] Result<std::unique_ptr<Generator>> makeFlow(const NetworkWeights& weights,
                                                          const Skeleton& avatar);

}  // namespace deixis::motion
