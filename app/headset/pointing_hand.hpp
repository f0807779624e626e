// Which hand carries the ray, and which presses count: plain logic.
#pragma once

#include <array>
#include <optional>

#include "studies/station/station.hpp"

namespace deixis::app {

/// What one hand's button does in a frame.
struct HandButton {
    bool active = false;              ///< a device is bound and awake
    bool pressed = false;             ///< down now
    bool changed = false;             ///< since the last frame
    std::optional<double> changed_s;  ///< when, on the station's clock, where the device tells
};

/// The hand used last carries the ray. A press of the other hand's button takes the ray over and selects
/// nothing; presses of both in one frame select nothing either: nobody can tell which was meant. A button
/// that is down when its device wakes, or when the program gets its input back, has to be let go first.
class PointingHand {
  public:
    struct Press {
        bool select = false;
        bool held = false;  ///< the button that selected is still down, and its hand has the ray
        std::optional<double> time_s;
    };
    /// By studies::Hand.
    Press update(const std::array<HandButton, 2>& buttons);
    /// The hand that carries the ray: right at first; where its device sleeps, the other if that is awake.
    [[nodiscard]] studies::Hand hand() const { return hand_; }

  private:
    studies::Hand hand_ = studies::Hand::right;
    studies::Hand used_last_ = studies::Hand::right;
    std::array<bool, 2> was_active_{};  ///< in the frame before, by studies::Hand
    std::optional<studies::Hand> holding_;
};

}  // namespace deixis::app
