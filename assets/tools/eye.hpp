// Eyes: balls with iris and pupil that turn with the eye joints, and lids that stay with the head.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "surface.hpp"

namespace deixis::avatar_maker {

/// A closed mesh about the eye's centre, looking along +z. The colour is that of each triangle, linear RGB.
struct EyePart {
    Mesh mesh;
    std::vector<glm::vec3> colours;
};

[[nodiscard]] EyePart makeEyeball();
/// The left eye's lids; the right eye's are their mirror image.
[[nodiscard]] EyePart makeLids();
/// The same part on the other side of the plane x = 0.
[[nodiscard]] EyePart mirrored(EyePart part);

}  // namespace deixis::avatar_maker
