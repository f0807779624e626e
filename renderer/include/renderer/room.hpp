// The room that everything is drawn in.
#pragma once

#include <glm/vec3.hpp>

namespace deixis::renderer {

/// Its corners, metres: a floor of 8 x 9 m around the avatar and the people who look at it.
constexpr glm::vec3 room_low{-4.0F, 0.0F, -3.5F};
constexpr glm::vec3 room_high{4.0F, 3.0F, 5.5F};

}  // namespace deixis::renderer
