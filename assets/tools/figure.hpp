// The avatar's figure: where its surface is and what each place is made of. T pose, metres, +y up, facing +z.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "core/pose.hpp"

namespace deixis::avatar_maker {

enum class Material : unsigned char { skin, lips, mouth, hair, sweater, trim, trousers, shoes, soles };

/// Signed distance to the figure without its eyeballs; negative inside.
[[nodiscard]] double figureDistance(const Vec3& p);
/// Signed distance to what is made of one material alone, with the eyes closed: for shading, since the rims
/// of the eyes' openings lie hidden behind the lids.
[[nodiscard]] double materialDistance(const Vec3& p, Material material);
/// What the surface nearest to `p` is made of.
[[nodiscard]] Material figureMaterial(const Vec3& p);
/// Linear RGB.
[[nodiscard]] glm::vec3 materialColour(Material material);

constexpr double eyeball_radius_m = 0.0165;

}  // namespace deixis::avatar_maker
