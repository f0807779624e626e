// How a simulated participant puts a ball where it believes that the avatar points.
#pragma once

#include <cstdint>
#include <optional>

#include "core/random.hpp"
#include "simulated_hand.hpp"
#include "studies/observers/observer.hpp"
#include "studies/station/station.hpp"

namespace deixis::studies {

/// It reads a line off the arm, with its noise, and has a feeling for how far along it things stand, with a
/// spread: the line says nothing of that. Both spreads are assumptions (docs/simulated-participant.md).
class BallPlacer {
  public:
    BallPlacer(const ObserverModel& model, std::uint64_t seed);

    /// What comes now is another movement.
    void forget();
    /// Plans the drag of the frame's only ball towards the place believed, `at_s`; false where it lies there.
    [[nodiscard]] bool plan(const PresentedFrame& frame, const SeenArm& arm, SimulatedHand& hand,
                            double at_s);
    /// How much farther the ball is to go, once, while it is held.
    [[nodiscard]] double farther_m(const SimulatedHand& hand, const InputFrame& input);

  private:
    ObserverModel model_;
    Random placing_;
    std::optional<Vec3> believed_{};
    double farther_m_ = 0.0;
    int drags_ = 0;
};

}  // namespace deixis::studies
