// Eyeballs: spheres with iris and pupil that turn with the eye joints.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "surface.hpp"

namespace deixis::avatar_maker {

struct Eyeball {
    Mesh mesh;                       ///< closed; centred at the origin, looking along +z
    std::vector<glm::vec3> colours;  ///< of each triangle, linear RGB
};

[[nodiscard]] Eyeball makeEyeball();

}  // namespace deixis::avatar_maker
