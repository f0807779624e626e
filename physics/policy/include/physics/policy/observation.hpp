// What a policy sees of the body that it moves. Places and directions are seen from the pelvis, turned about
// the upright axis to where the pelvis faces, as in the humanoid of AMP (Peng et al. 2021; Deichler et al.
// 2023, section 2.2): each link's place, its turn as its hinges' angles, and their speeds.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "physics/body/body.hpp"

namespace deixis::physics {

/// What a body is to do: where to point and with which hand, and how much of the gesture's time has passed, 0
/// to 1; without it the policy does not know the time (the paper's "no run time").
struct PolicyGoal {
    Vec3 target_m{0.0};  ///< in the world
    motion::Side hand = motion::Side::right;
    std::optional<double> phase{};
};

/// Writes a body's state and goal as numbers.
class BodyObserver {
  public:
    explicit BodyObserver(const Figure& figure);

    [[nodiscard]] std::size_t stateSize() const { return state_size_; }
    /// Angles (rad) and speeds (a tenth of rad/s) of the hinges, the places (m) of elbows, hands and head,
    /// and of feet; of a body on its feet also the height of its pelvis, two axes of its turn, and its
    /// velocities. `out` holds stateSize() numbers.
    void writeState(Body& body, std::span<float> out) const;

    [[nodiscard]] static std::size_t goalSize(bool with_phase) { return with_phase ? 9 : 7; }
    /// `state`: what writeState() has written. Two directions to the target, from where the shoulder is while
    /// the body stands upright and from the elbow: they, and not the target's place, decide how an arm
    /// points, and so what is learned from far targets holds for nearer ones. The hand, 1 or -1 (right):
    /// ahead of the body either points, and a policy that did not know which would hesitate. And the phase p
    /// as sin(pi p) and 2p - 1.
    void writeGoal(const RootState& root, std::span<const float> state, const PolicyGoal& goal,
                   std::span<float> out) const;

  private:
    bool free_;
    std::size_t hinges_;
    std::vector<std::size_t> ends_;    ///< segments
    std::array<Vec3, 2> shoulders_m_;  ///< left and right, from the pelvis
    std::size_t state_size_;
};

}  // namespace deixis::physics
