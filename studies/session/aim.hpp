// What the participant's ray meets, and whether it was aimed there.
#pragma once

#include <optional>

#include "core/pose.hpp"

namespace deixis::studies {

/// What a ray meets first: the id of a button, a slider or a field (0: none), or the place of a ball (-1:
/// none).
struct Aim {
    int button = 0;
    int slider = 0;
    int field = 0;
    int ball = -1;
    bool operator==(const Aim&) const = default;
};

/// What the ray happens to rest on when a board or the choice among balls opens was not aimed at: it is not
/// met until the ray has been off it, or has moved. Where the ray rests is known from the first input after
/// the frame that opened it, when the viewer and the view have been moved for it, too.
class OnsetGuard {
  public:
    void open() { phase_ = Phase::opening; }
    /// Lets the ray meet at once what it rests on.
    void release() { phase_ = Phase::off; }
    void beginFrame() {
        if (phase_ == Phase::opening) phase_ = Phase::opened;
    }
    /// Of what the ray meets, what counts as met.
    [[nodiscard]] Aim admit(const Aim& met, const std::optional<Ray>& pointer);

  private:
    enum class Phase : unsigned char {
        off,
        opening,  ///< in this frame
        opened,   ///< in the one before
        resting   ///< the ray has stayed where it was
    };
    Phase phase_ = Phase::off;
    Aim rested_on_{};
    std::optional<Ray> rested_{};
};

}  // namespace deixis::studies
