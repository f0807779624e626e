#include "renderer/passes/beam_pass.hpp"

#include <glm/gtc/type_ptr.hpp>

namespace deixis::renderer {
namespace {

// Vertices 0..3: the ribbon; 4..7: the dot. Everything in the eye's frame.
const std::string_view beam_vertex_glsl = R"(
layout(location = 0) uniform vec3 origin;
layout(location = 1) uniform vec3 end;
out vec2 across;          // metres from the middle line or the dot's centre
flat out float core;      // radius of the solid part, metres
flat out float is_dot;
out float along;          // metres from the origin
out float pixel;          // size of a pixel here, metres
const float halo = 0.016;
const float dot_halo = 0.024;

void main() {
    vec3 a = (this_view.eye_from_stage * vec4(origin, 1.0)).xyz;
    vec3 b = (this_view.eye_from_stage * vec4(end, 1.0)).xyz;
    vec3 direction = normalize(b - a);
    float length_m = distance(a, b);
    float start = 0.0;
    // What lies behind the eye is cut off: a ribbon that passes the eye has no side to turn to it.
    const float nearest = -0.06;
    if (a.z > nearest && b.z < nearest) {
        start = (a.z - nearest) / (a.z - b.z) * length_m;
        a += direction * start;
    }
    vec2 corner = vec2(float(gl_VertexID & 1), float((gl_VertexID >> 1) & 1)) * 2.0 - 1.0;
    is_dot = gl_VertexID >= 4 ? 1.0 : 0.0;
    vec3 p;
    if (gl_VertexID < 4) {
        p = corner.x < 0.0 ? a : b;
        pixel = this_view.eye.w * max(-p.z, 0.05);
        core = 0.0032;
        vec3 side = cross(direction, normalize(p));
        side /= max(length(side), 1e-4);
        float half_width = max(halo, 2.0 * pixel);
        p += side * corner.y * half_width;
        across = vec2(corner.y * half_width, 0.0);
        along = corner.x < 0.0 ? start : length_m;
    } else {
        pixel = this_view.eye.w * max(-b.z, 0.05);
        core = max(0.009, 2.0 * pixel);
        float half_width = max(dot_halo, core + 2.0 * pixel);
        p = b - normalize(b) * 0.012;  // before the surface that it lies on
        p += vec3(corner * half_width, 0.0);
        across = corner * half_width;
        along = length_m;
    }
    gl_Position = this_view.clip_from_eye * vec4(p, 1.0);
}
)";

const std::string_view beam_fragment_glsl = R"(
in vec2 across;
flat in float core;
flat in float is_dot;
in float along;
in float pixel;
layout(location = 2) uniform vec3 beam_colour;
out vec4 colour;
void main() {
    float d = length(across);
    float radius = max(core, 0.8 * pixel);
    float solid = 1.0 - smoothstep(radius - 0.6 * pixel, radius + 0.6 * pixel, d);
    float reach = is_dot > 0.5 ? 0.024 : 0.016;
    float fall = clamp(1.0 - d / max(reach, 2.0 * pixel), 0.0, 1.0);
    float glow = 0.30 * fall * fall;
    float alpha = max(solid * 0.96, glow) * smoothstep(0.0, 0.15, along + 0.02);
    vec3 hot = mix(beam_colour, vec3(1.0, 0.45, 0.35), 0.22 * solid * clamp(1.0 - d / radius, 0.0, 1.0));
    colour = vec4(hot, 1.0) * alpha;
}
)";

}  // namespace

BeamPass::BeamPass()
    : program_("beam", {beam_vertex_glsl}, {beam_fragment_glsl}), no_vertices_(gl::vertexArray()) {}

void BeamPass::draw(const Beam& beam, Views views) {
    if (!(beam.length_m > 1e-3)) return;
    const glm::vec3 origin(beam.ray.origin);
    const glm::vec3 end(beam.ray.origin + beam.ray.direction * beam.length_m);
    program_.use(views);
    glUniform3fv(0, 1, glm::value_ptr(origin));
    glUniform3fv(1, 1, glm::value_ptr(end));
    glUniform3fv(2, 1, glm::value_ptr(beam.colour));
    glBindVertexArray(no_vertices_.name());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glDrawArrays(GL_TRIANGLE_STRIP, 4, 4);
}

}  // namespace deixis::renderer
