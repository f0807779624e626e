// What the actuators of a body are told when a policy moves it.
#pragma once

#include <span>
#include <utility>
#include <vector>

namespace deixis::physics {

/// An exponential mean over controls: of what they were told before, a share stays. Without it, what a policy
/// asks for changes by leaps, 30 times a second, and movements tremble.
class SmoothedTargets {
  public:
    /// `kept`: in [0, 1).
    explicit SmoothedTargets(double kept) : kept_(kept) {}

    /// `last_rad`: what they were told last; empty: nothing, and what is asked for first is what they are
    /// told.
    void begin(std::vector<double> last_rad) { last_rad_ = std::move(last_rad); }
    /// What they are told, valid until the next call.
    std::span<const double> next(std::span<const double> asked_rad) {
        if (last_rad_.empty()) last_rad_.assign(asked_rad.begin(), asked_rad.end());
        for (std::size_t i = 0; i < last_rad_.size(); ++i)
            last_rad_[i] = kept_ * last_rad_[i] + (1.0 - kept_) * asked_rad[i];
        return last_rad_;
    }

  private:
    double kept_;
    std::vector<double> last_rad_{};
};

}  // namespace deixis::physics
