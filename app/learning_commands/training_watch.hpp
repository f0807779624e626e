// While something trains: Ctrl-C, and the time that is left.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace deixis::app {

/// While it lives Ctrl-C is noted once; the second time the program ends at once.
class InterruptWatch {
  public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;
    [[nodiscard]] static bool interrupted();
};

/// From the shares that were done since it was first asked.
class TimeLeft {
  public:
    /// "; 1:23 left", or nothing as long as that is a guess.
    [[nodiscard]] std::string text(double done);

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point since_ = Clock::now();
    std::optional<double> first_done_{};
};

}  // namespace deixis::app
