// Cutting triangles at points of their edges, without opening the mesh.
#pragma once

#include <functional>
#include <optional>

#include "surface.hpp"

namespace deixis::avatar_maker {

/// Calls `emit` with the triangles that fill `t` when some of its edges have a new vertex; split[i] lies on
/// the edge from t[i] to t[i + 1].
void splitTriangle(const Triangle& t, const std::array<std::optional<std::uint32_t>, 3>& split,
                   const std::function<void(const Triangle&)>& emit);

/// Halves edges longer than `longest(p)` at their middle p, moved onto the figure's surface, in a few rounds.
void refine(Mesh& mesh, const std::function<double(const Vec3&)>& longest);

}  // namespace deixis::avatar_maker
