// Bodies that try out a policy, many at once: each plays one demonstration's time from somewhere within it
// (reference-state initialisation) towards a target near the demonstration's.
#pragma once

#include <vector>

#include "core/random.hpp"
#include "reference_motions.hpp"

namespace deixis::learning {

class Environments {
  public:
    /// `references` stay where they are, and are not empty.
    Environments(const physics::Body& body, const std::vector<ReferenceMotion>& references,
                 const AmpSettings& settings, std::uint64_t seed);

    /// All begin anew.
    void restart(std::uint64_t seed);
    [[nodiscard]] std::size_t count() const { return bodies_.size(); }
    /// Numbers of the body's state, and with the goal behind them.
    [[nodiscard]] std::size_t stateSize() const { return observer_.stateSize(); }
    [[nodiscard]] std::size_t seenSize() const;

    /// What the policy sees now, count() rows.
    void see(std::span<float> out);
    /// A body's last states as the observer has them, the present one last: as many as the discriminator sees
    /// beside the next. Before the begin they are the demonstration's.
    [[nodiscard]] std::span<const float> past(std::size_t body) const { return plays_[body].past; }

    struct Step {
        double task_reward = 0.0;   ///< in [0, 0.632]
        double task_at_best = 0.0;  ///< what it would have been without an error
        double power_w = 0.0;  ///< of all hinges' actuators at the end of the step, each without its sign
        double phase = 0.0;    ///< of the state before the step
        bool ended = false;    ///< time is over, or the body has fallen
        bool fallen = false;
    };
    /// One control of one body; `after`: what the policy sees then, before a new begin where it has ended.
    [[nodiscard]] Step step(std::size_t body, std::span<const double> targets_rad, std::span<float> after);

  private:
    struct Play {
        const ReferenceMotion* reference = nullptr;
        std::size_t control = 0;
        std::vector<Vec3> balls_m;  ///< the target first
        std::vector<float> past;
    };
    void begin(std::size_t body);
    void seeOne(std::size_t body, std::span<float> out);
    [[nodiscard]] double power_w(const physics::Body& body, std::span<const double> targets_rad) const;
    [[nodiscard]] double reward(const physics::Body& body, const Play& play);

    const std::vector<ReferenceMotion>& references_;
    const AmpSettings& settings_;
    physics::BodyObserver observer_;
    std::vector<physics::Body> bodies_;
    std::vector<Play> plays_;
    Random random_;
    motion::LocalPose pose_;
};

}  // namespace deixis::learning
