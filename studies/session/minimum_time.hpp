// How long a page must be looked at before it can be left; private to studies.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace deixis::studies {

class MinimumTime {
  public:
    explicit MinimumTime(double minimum_s) : minimum_s_(minimum_s) {}
    void start(double now_s) {
        if (!since_s_) since_s_ = now_s;
    }
    /// Whole seconds left, rounded up; 0: the page can be left.
    [[nodiscard]] int left(double now_s) const {
        return std::max(0, static_cast<int>(std::ceil(minimum_s_ - (now_s - *since_s_) - 1e-9)));
    }

  private:
    double minimum_s_;
    std::optional<double> since_s_{};
};

}  // namespace deixis::studies
