#include "eye.hpp"

#include <cmath>
#include <utility>

#include "figure.hpp"
#include "shapes.hpp"

namespace deixis::avatar_maker {

namespace {

using glm::vec3;

const vec3 pupil(0.004F, 0.004F, 0.005F), iris(0.110F, 0.048F, 0.018F), iris_rim(0.030F, 0.013F, 0.006F),
    white(0.800F, 0.790F, 0.760F);

void add(EyePart& part, const Triangle& triangle, const vec3& colour) {
    part.mesh.triangles.push_back(triangle);
    part.colours.push_back(colour);
}

}  // namespace

EyePart makeEyeball() {
    // Rings from the front to the back by their angle off the gaze; the colour is that of the band before the
    // ring.
    struct Ring {
        double angle_deg;
        vec3 colour;
    };
    static const Ring rings[] = {
        {7, pupil},  {13.5, pupil}, {20, iris},  {27, iris},   {31.5, iris_rim}, {42, white},
        {54, white}, {68, white},   {90, white}, {120, white}, {150, white},
    };
    constexpr int segments = 28;
    EyePart eye;
    const auto vertex = [&](std::size_t ring, int segment) {
        return static_cast<std::uint32_t>(1 + ring * segments + static_cast<std::size_t>(segment % segments));
    };
    eye.mesh.positions.emplace_back(0.0, 0.0, eyeball_radius_m);
    for (const Ring& ring : rings)
        for (int s = 0; s < segments; ++s) {
            const double around = 2.0 * pi * s / segments;
            const double off = radiansFromDegrees(ring.angle_deg);
            eye.mesh.positions.push_back(eyeball_radius_m * Vec3(std::cos(around) * std::sin(off),
                                                                 std::sin(around) * std::sin(off),
                                                                 std::cos(off)));
        }
    const auto back = static_cast<std::uint32_t>(eye.mesh.positions.size());
    eye.mesh.positions.emplace_back(0.0, 0.0, -eyeball_radius_m);
    const std::size_t last = std::size(rings) - 1;
    for (int s = 0; s < segments; ++s) {
        add(eye, {0, vertex(0, s), vertex(0, s + 1)}, rings[0].colour);
        for (std::size_t r = 0; r < last; ++r) {
            add(eye, {vertex(r, s), vertex(r + 1, s), vertex(r + 1, s + 1)}, rings[r + 1].colour);
            add(eye, {vertex(r, s), vertex(r + 1, s + 1), vertex(r, s + 1)}, rings[r + 1].colour);
        }
        add(eye, {back, vertex(last, s + 1), vertex(last, s)}, white);
    }
    return eye;
}

EyePart makeLids() {
    // A shell around the ball with an almond opening, closed to a ring through the ball's inside. Each loop
    // lies a share of the way from the opening's border to the shell's outer edge, which dips under the skin.
    struct Loop {
        double share, radius;
    };
    constexpr double inside = eyeball_radius_m - 0.0010, outside = eyeball_radius_m + 0.0018;
    static const Loop loops[] = {
        {0.00, inside},  {0.00, outside},          {0.06, outside + 0.0003}, {0.14, outside + 0.0002},
        {0.45, outside}, {0.80, outside - 0.0001}, {1.00, outside - 0.0012}, {1.00, inside},
    };
    constexpr std::size_t count = std::size(loops);
    constexpr int segments = 40;
    const vec3 skin = materialColour(Material::skin);
    const vec3 lash = materialColour(Material::hair);
    EyePart lids;
    for (const Loop& loop : loops)
        for (int s = 0; s < segments; ++s) {
            const double around = 2.0 * pi * s / segments;
            const double c = std::cos(around), n = std::sin(around);
            // Towards the corners the opening narrows; the outer corner lies a little higher.
            const double x = 0.0153 * c;
            const double y = (n > 0.0 ? 0.0096 : 0.0076) * n * (1.0 - 0.22 * c * c) + 0.06 * x;
            const double radius = std::sqrt(x * x + y * y);
            const double border = std::asin(radius / outside);
            const double angle = border * (1.0 + 0.55 * loop.share);
            lids.mesh.positions.push_back(loop.radius * Vec3(x / radius * std::sin(angle),
                                                             y / radius * std::sin(angle), std::cos(angle)));
        }
    const auto vertex = [&](std::size_t loop, int segment) {
        return static_cast<std::uint32_t>(loop % count * segments +
                                          static_cast<std::size_t>(segment % segments));
    };
    for (std::size_t loop = 0; loop < count; ++loop)
        for (int s = 0; s < segments; ++s) {
            const bool upper = s < segments / 2;
            const bool rim = loop == 0 || loop == 1 || (loop == 2 && upper);
            const vec3 colour = rim ? (upper ? lash : 0.55F * skin) : skin;
            add(lids, {vertex(loop, s), vertex(loop + 1, s), vertex(loop + 1, s + 1)}, colour);
            add(lids, {vertex(loop, s), vertex(loop + 1, s + 1), vertex(loop, s + 1)}, colour);
        }
    return lids;
}

EyePart mirrored(EyePart part) {
    for (Vec3& p : part.mesh.positions) p.x = -p.x;
    for (Triangle& t : part.mesh.triangles) std::swap(t[1], t[2]);
    return part;
}

}  // namespace deixis::avatar_maker
