// A position as the tables of targets have it; private to them.
#pragma once

#include <fmt/format.h>

#include <string>

#include "core/pose.hpp"

namespace deixis::studies {

/// "0.1000,1.2000,2.0000", metres.
[[nodiscard]] inline std::string positionText(const Vec3& position) {
    return fmt::format("{:.4f},{:.4f},{:.4f}", position.x, position.y, position.z);
}

}  // namespace deixis::studies
