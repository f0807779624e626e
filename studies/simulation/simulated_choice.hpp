// How a simulated participant finds the ball that was pointed at.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "studies/observers/observer.hpp"
#include "studies/station/station.hpp"

namespace deixis::studies {

struct BallChoice {
    std::size_t place = 0;
    /// By how much more the next best ball was missed; 0 where it was chosen at random or another was nearer,
    /// infinite where there was no other.
    double margin_rad = 0.0;
};

class BallChooser {
  public:
    BallChooser(const ObserverModel& model, std::uint64_t seed);

    /// There must be at least one ball.
    [[nodiscard]] BallChoice choose(const SeenArm& arm, const std::vector<BallView>& balls);

  private:
    [[nodiscard]] BallChoice byTwoCues(const SeenArm& arm, const std::vector<Vec3>& balls);
    [[nodiscard]] BallChoice byOneLine(const Ray& line, const std::vector<Vec3>& balls);

    ObserverModel model_;
    Random choices_;
};

}  // namespace deixis::studies
