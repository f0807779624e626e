// Tells when the headset has lost sight of the room for too long to go on.
#pragma once

#include <optional>

#include "studies/station/station.hpp"

namespace deixis::app {

/// A head whose pose is not valid is lost soon: nothing can be shown. Most runtimes rather continue with a
/// guessed position when they see the room no more; then the room stands askew or sticks to the head, and a
/// participant who bears with it for a while is asked too. A headset that never measures its position (one
/// that only turns) has nothing to lose.
class HeadWatch {
  public:
    /// Call every frame. True: the session is to pause. A guessed position is told once, until it was
    /// measured again: who resumed all the same is left in peace.
    [[nodiscard]] bool lost(const studies::TrackedPose& head, double now_s);

  private:
    bool was_tracked_ = false;  ///< since a guess was last told
    std::optional<double> invalid_since_s_;
    std::optional<double> guessed_since_s_;
};

}  // namespace deixis::app
