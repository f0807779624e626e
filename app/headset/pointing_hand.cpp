#include "pointing_hand.hpp"

namespace deixis::app {

namespace {

std::size_t index(studies::Hand hand) {
    return static_cast<std::size_t>(hand);
}

studies::Hand other(studies::Hand hand) {
    return hand == studies::Hand::left ? studies::Hand::right : studies::Hand::left;
}

}  // namespace

PointingHand::Press PointingHand::update(const std::array<HandButton, 2>& buttons) {
    std::array<bool, 2> went_down{};
    for (std::size_t hand = 0; hand < buttons.size(); ++hand) {
        const HandButton& button = buttons[hand];
        went_down[hand] = button.active && was_active_[hand] && button.pressed && button.changed;
        was_active_[hand] = button.active;
    }

    // Whose ray the person saw when pressing.
    const studies::Hand carrier = hand_;
    const bool both = went_down[0] && went_down[1];
    Press press;
    if (!both && went_down[index(carrier)]) {
        press.select = true;
        press.time_s = buttons[index(carrier)].changed_s;
        used_last_ = carrier;
        holding_ = carrier;
    } else if (!both && went_down[index(other(carrier))]) {
        used_last_ = other(carrier);
    }

    const bool asleep = !buttons[index(used_last_)].active && buttons[index(other(used_last_))].active;
    hand_ = asleep ? other(used_last_) : used_last_;
    const HandButton& carried_by = buttons[index(hand_)];
    if (holding_ != hand_ || !carried_by.active || !carried_by.pressed) holding_.reset();
    press.held = holding_.has_value();
    return press;
}

}  // namespace deixis::app
