// From the figure's distance field to a closed triangle mesh.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/pose.hpp"

namespace deixis::avatar_maker {

using Triangle = std::array<std::uint32_t, 3>;  ///< counter-clockwise seen from outside

struct Mesh {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
};

/// The figure's surface, closed, with cells of 8 mm on trunk and limbs, 2.4 mm on the head and 2.2 mm
/// on the hands.
[[nodiscard]] Mesh extractSurface();

/// The nearest place on the figure's surface, by a few steps along the gradient.
[[nodiscard]] Vec3 ontoSurface(const Vec3& p);
/// Unit outward direction of the surface near `p`.
[[nodiscard]] Vec3 surfaceNormal(const Vec3& p);
/// The same of a field other than the figure's distance.
[[nodiscard]] Vec3 fieldNormal(const std::function<double(const Vec3&)>& field, const Vec3& p);

/// Collapses edges, cheapest first (quadric error: Garland & Heckbert 1997), until at most
/// `triangle_target` triangles are left or nothing can be collapsed; the mesh stays closed. Head and hands
/// keep finer detail than the rest.
void simplify(Mesh& mesh, std::size_t triangle_target);

/// True where every edge is shared by exactly two triangles that run through it in opposite directions.
[[nodiscard]] bool isClosed(const std::vector<Triangle>& triangles);

}  // namespace deixis::avatar_maker
