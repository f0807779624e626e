#include "aim.hpp"

#include <glm/geometric.hpp>

namespace deixis::studies {

namespace {

constexpr double moved_rad = radiansFromDegrees(1.0);  // more than a click shakes a mouse
constexpr double moved_m = 0.02;

bool moved(const std::optional<Ray>& from, const std::optional<Ray>& to) {
    if (!from || !to) return true;
    return angleBetween(from->direction, to->direction) >= moved_rad ||
           glm::length(to->origin - from->origin) >= moved_m;
}

}  // namespace

Aim OnsetGuard::admit(const Aim& met, const std::optional<Ray>& pointer) {
    if (phase_ == Phase::opening) return {};
    if (phase_ == Phase::opened) {
        rested_on_ = met;
        rested_ = pointer;
        phase_ = met == Aim{} ? Phase::off : Phase::resting;
        return {};
    }
    if (phase_ == Phase::resting) {
        if (met == rested_on_ && !moved(rested_, pointer)) return {};
        phase_ = Phase::off;
    }
    return met;
}

}  // namespace deixis::studies
