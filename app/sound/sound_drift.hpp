// How far a sound was from the movement that it belongs to.
#pragma once

#include <string>

namespace deixis::app {

class SoundDrift {
  public:
    /// By how much the sound is ahead now; negative: it is late. Seconds.
    void add(double ahead_s);
    /// "speech.wav: 3 ms late at its start, 12 ms at most"; empty where nothing was measured.
    [[nodiscard]] std::string text(const std::string& id) const;

  private:
    int count_ = 0;
    double first_s_ = 0.0;
    double farthest_s_ = 0.0;
};

}  // namespace deixis::app
