#include "sound_drift.hpp"

#include <fmt/core.h>

#include <cmath>

namespace deixis::app {

void SoundDrift::add(double ahead_s) {
    if (count_++ == 0) first_s_ = ahead_s;
    if (std::abs(ahead_s) > std::abs(farthest_s_)) farthest_s_ = ahead_s;
}

std::string SoundDrift::text(const std::string& id) const {
    if (count_ == 0) return {};
    return fmt::format("{}: {:.0f} ms {} at its start, {:.0f} ms at most", id, std::abs(1000.0 * first_s_),
                       first_s_ < 0.0 ? "late" : "ahead", std::abs(1000.0 * farthest_s_));
}

}  // namespace deixis::app
