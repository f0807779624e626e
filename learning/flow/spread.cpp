#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/random.hpp"
#include "learning/flow/training.hpp"

namespace deixis::learning {

namespace {

using motion::GestureTrajectories;

constexpr int times = 29;  ///< of a gesture, from its begin to its end
constexpr int draws = 16;  ///< for each place

/// Elbow, wrist and fingertip at each of the times.
std::vector<Vec3> armOf(const GestureTrajectories& trajectories, const std::vector<double>& trajectory) {
    std::vector<Vec3> out;
    for (int i = 0; i < times; ++i) {
        const auto arm = trajectories.arm_m(trajectory, motion::PhaseTrajectory::whole * i / (times - 1));
        out.insert(out.end(), arm.begin(), arm.end());
    }
    return out;
}

/// Sum of squared distances, metres squared.
double squares(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double out = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) out += glm::dot(a[i] - b[i], a[i] - b[i]);
    return out;
}

/// Of gestures for one place, about their own mean.
double variance(const std::vector<std::vector<Vec3>>& arms) {
    std::vector<Vec3> mean(arms.front().size(), Vec3(0.0));
    for (const auto& arm : arms)
        for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += arm[i] / static_cast<double>(arms.size());
    double sum = 0.0;
    for (const auto& arm : arms) sum += squares(arm, mean);
    return sum / static_cast<double>(arms.size() - 1);
}

}  // namespace

Spread flowSpread(const motion::FlowMatching& model, const std::vector<motion::Demonstration>& demonstrations,
                  std::uint64_t seed) {
    const GestureTrajectories& trajectories = model.trajectories();
    const auto errors = model.process().leftOutErrors();
    Random random(seed, "spread");
    double demonstrated = 0.0, drawn = 0.0, unguided = 0.0;
    for (std::size_t i = 0; i < demonstrations.size(); ++i) {
        const auto observation = trajectories.observe(demonstrations[i]);
        std::vector<double> predicted = observation.trajectory;
        for (std::size_t d = 0; d < predicted.size(); ++d)
            predicted[d] -= errors(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(d));
        demonstrated += squares(armOf(trajectories, observation.trajectory), armOf(trajectories, predicted));
        for (const bool guided : {true, false}) {
            std::vector<std::vector<Vec3>> arms;
            for (int draw = 0; draw < draws; ++draw)
                arms.push_back(armOf(trajectories, model.draw(observation.place_m, random, guided)));
            (guided ? drawn : unguided) += variance(arms);
        }
    }
    const double points = 3.0 * times * static_cast<double>(demonstrations.size());
    return {std::sqrt(demonstrated / points), std::sqrt(drawn / points), std::sqrt(unguided / points)};
}

}  // namespace deixis::learning
