#include "angle_track.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace deixis::physics {

AngleTrack::AngleTrack(std::vector<std::vector<double>> frames, double frame_time_s)
    : frames_(std::move(frames)), frame_time_s_(frame_time_s) {}

/// Per frame.
double AngleTrack::slope(std::size_t frame, std::size_t number) const {
    const std::size_t before = frame == 0 ? 0 : frame - 1;
    const std::size_t after = std::min(frame + 1, frames_.size() - 1);
    if (after == before) return 0.0;
    return (frames_[after][number] - frames_[before][number]) / static_cast<double>(after - before);
}

void AngleTrack::at(double time_s, std::vector<double>& angles_rad, std::vector<double>& speeds_rad_s) const {
    const std::size_t numbers = frames_.front().size();
    angles_rad.resize(numbers);
    speeds_rad_s.resize(numbers);
    const double last = static_cast<double>(frames_.size() - 1);
    const double place = std::clamp(time_s / frame_time_s_, 0.0, last);
    const bool still = time_s < 0.0 || time_s / frame_time_s_ > last;
    const auto frame = static_cast<std::size_t>(std::min(std::floor(place), std::max(0.0, last - 1.0)));
    const std::size_t next = std::min(frame + 1, frames_.size() - 1);
    const double t = place - static_cast<double>(frame);
    for (std::size_t i = 0; i < numbers; ++i) {
        const double from = frames_[frame][i], to = frames_[next][i];
        const double leaving = slope(frame, i), arriving = slope(next, i);
        const double cubic = 2.0 * (from - to) + leaving + arriving;
        const double square = 3.0 * (to - from) - 2.0 * leaving - arriving;
        angles_rad[i] = from + t * (leaving + t * (square + t * cubic));
        const double speed = leaving + t * (2.0 * square + t * 3.0 * cubic);
        speeds_rad_s[i] = still ? 0.0 : speed / frame_time_s_;
    }
}

}  // namespace deixis::physics
