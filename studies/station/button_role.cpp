#include <stdexcept>

#include "studies/station/station.hpp"

namespace deixis::studies {

std::string_view buttonRoleName(ButtonRole role) {
    switch (role) {
        case ButtonRole::go_on:
            return "go_on";
        case ButtonRole::leave:
            return "leave";
        case ButtonRole::play:
            return "play";
        case ButtonRole::option:
            return "option";
        case ButtonRole::other:
            return "other";
    }
    throw std::logic_error("a button with a role that has no name");
}

}  // namespace deixis::studies
