// Colours: triangles cut along the borders between materials, so that each has one colour and borders are
// sharp.
#pragma once

#include <vector>

#include "figure.hpp"
#include "surface.hpp"

namespace deixis::avatar_maker {

struct PaintedMesh {
    Mesh mesh;                        ///< still closed
    std::vector<Material> materials;  ///< of each triangle
};

[[nodiscard]] PaintedMesh paint(Mesh mesh);

}  // namespace deixis::avatar_maker
