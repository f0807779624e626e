// How a simulated participant finds the ball that was pointed at.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/random.hpp"
#include "simulated_observer.hpp"
#include "studies/station.hpp"

namespace deixis::studies {

struct BallChoice {
    std::size_t place = 0;
    /// By how much nearer the ray the best ball was than the next; 0 where it was chosen at random, infinite
    /// where there was no other.
    double margin_rad = 0.0;
};

/// Unit length, across a direction of unit length and across each other: a ray is disturbed about them.
struct AcrossRay {
    Vec3 right{};
    Vec3 above{};
};
[[nodiscard]] AcrossRay acrossRay(const Vec3& direction);

class BallChooser {
  public:
    /// `noise_rad`: SD of the angle by which the ray is disturbed about each of two axes.
    BallChooser(double noise_rad, double lapse_rate, std::uint64_t seed);

    /// There must be at least one ball.
    [[nodiscard]] BallChoice choose(const SeenGesture& seen, const std::vector<BallView>& balls);

  private:
    double noise_rad_;
    double lapse_rate_;
    Random choices_;
};

}  // namespace deixis::studies
