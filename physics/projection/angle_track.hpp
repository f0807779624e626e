// Numbers that were sampled at a constant rate, and their speeds, at any time between.
#pragma once

#include <cstddef>
#include <vector>

namespace deixis::physics {

/// One vector of numbers for each frame, as many in each; at least one frame. Between frames it follows the
/// cubic Hermite curve whose slopes are central differences, so that speeds are the track's own derivative.
/// Before the first and after the last frame it stands still.
class AngleTrack {
  public:
    AngleTrack(std::vector<std::vector<double>> frames, double frame_time_s);

    /// Both are resized.
    void at(double time_s, std::vector<double>& angles_rad, std::vector<double>& speeds_rad_s) const;

  private:
    [[nodiscard]] double slope(std::size_t frame, std::size_t number) const;

    std::vector<std::vector<double>> frames_;
    double frame_time_s_;
};

}  // namespace deixis::physics
