#include "eyeball.hpp"

#include <cmath>

#include "figure.hpp"

namespace deixis::avatar_maker {

namespace {

using glm::vec3;

// Rings from the front to the back by their angle off the gaze; the colour is that of the band before the
// ring.
struct Ring {
    double angle_deg;
    vec3 colour;
};
const vec3 pupil(0.004F, 0.004F, 0.005F), iris(0.110F, 0.048F, 0.018F), iris_rim(0.030F, 0.013F, 0.006F),
    white(0.800F, 0.790F, 0.760F);
const Ring rings[] = {
    {7, pupil},  {14, pupil}, {22, iris},  {28, iris},   {32, iris_rim}, {44, white},
    {58, white}, {74, white}, {95, white}, {120, white}, {150, white},
};
constexpr int segments = 28;

}  // namespace

Eyeball makeEyeball() {
    Eyeball eye;
    const auto add = [&](const Triangle& t, const vec3& colour) {
        eye.mesh.triangles.push_back(t);
        eye.colours.push_back(colour);
    };
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
        add({0, vertex(0, s), vertex(0, s + 1)}, rings[0].colour);
        for (std::size_t r = 0; r < last; ++r) {
            add({vertex(r, s), vertex(r + 1, s), vertex(r + 1, s + 1)}, rings[r + 1].colour);
            add({vertex(r, s), vertex(r + 1, s + 1), vertex(r, s + 1)}, rings[r + 1].colour);
        }
        add({back, vertex(last, s + 1), vertex(last, s)}, white);
    }
    return eye;
}

}  // namespace deixis::avatar_maker
