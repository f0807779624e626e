// The shader programs of AvatarPass.
#pragma once

#include <string_view>

namespace deixis::renderer {

inline constexpr std::string_view skin_glsl = R"(
layout(local_size_x = 64) in;
// Packed, since software GL reads buffers word by word: 10 words a vertex. Joints are 16 bits each, weights
// 16-bit fractions, heaviest first.
struct Bind { float position[3]; float normal[3]; uint joints[2]; uint weights[2]; };
struct Skinned { vec4 position; vec4 normal; };
layout(std430, binding = 0) readonly buffer BindVertices { Bind bind_vertices[]; };
layout(std430, binding = 2) writeonly buffer SkinnedVertices { Skinned skinned_vertices[]; };
layout(std140, binding = 1) uniform Joints { vec4 rows[1020]; };  // of stage_from_bind, 3 a joint
layout(location = 0) uniform uint count;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) return;
    uvec2 joints = uvec2(bind_vertices[i].joints[0], bind_vertices[i].joints[1]);
    vec4 weights = vec4(unpackUnorm2x16(bind_vertices[i].weights[0]), unpackUnorm2x16(bind_vertices[i].weights[1]));
    vec4 x = vec4(0.0), y = vec4(0.0), z = vec4(0.0);
    for (int k = 0; k < 4 && weights.x > 0.0; ++k) {
        uint row = (joints.x & 0xFFFFu) * 3u;
        x += weights.x * rows[row];
        y += weights.x * rows[row + 1u];
        z += weights.x * rows[row + 2u];
        weights = vec4(weights.yzw, 0.0);
        joints = uvec2((joints.x >> 16) | (joints.y << 16), joints.y >> 16);
    }
    vec4 p = vec4(bind_vertices[i].position[0], bind_vertices[i].position[1], bind_vertices[i].position[2], 1.0);
    vec3 n = vec3(bind_vertices[i].normal[0], bind_vertices[i].normal[1], bind_vertices[i].normal[2]);
    skinned_vertices[i].position = vec4(dot(x, p), dot(y, p), dot(z, p), 1.0);
    skinned_vertices[i].normal = vec4(normalize(vec3(dot(x.xyz, n), dot(y.xyz, n), dot(z.xyz, n))), 1.0);
}
)";

// The key light that reaches each vertex. Vertices lie about a centimetre apart, no wider than the shadows'
// edges are soft, and there are far fewer of them than of pixels times samples.
inline constexpr std::string_view light_glsl = R"(
layout(local_size_x = 64) in;
struct Skinned { vec4 position; vec4 normal; };
layout(std430, binding = 2) buffer SkinnedVertices { Skinned skinned_vertices[]; };
layout(location = 0) uniform uint count;

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) return;
    vec3 p = skinned_vertices[i].position.xyz;
    vec3 n = skinned_vertices[i].normal.xyz;
    skinned_vertices[i].normal.w = avatarLight(p, n, 0.0) * ballLight(p);
}
)";

inline constexpr std::string_view shadow_vertex_glsl = R"(
layout(location = 0) in vec3 position;
layout(location = 0) uniform int avatar;
void main() { gl_Position = vec4((shadow_from_stage[avatar] * vec4(position, 1.0)).xyz * 2.0 - 1.0, 1.0); }
)";

inline constexpr std::string_view shadow_fragment_glsl = "void main() {}\n";

inline constexpr std::string_view draw_vertex_glsl = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;  // w: key light
layout(location = 2) in vec3 colour;
out vec3 stage_position;
out vec4 stage_normal;
out vec3 albedo;
void main() {
    stage_position = position;
    stage_normal = normal;
    albedo = colour;
    gl_Position = this_view.clip_from_stage * vec4(position, 1.0);
}
)";

inline constexpr std::string_view draw_fragment_glsl = R"(
in vec3 stage_position;
in vec4 stage_normal;
out vec4 colour;
void main() {
    SURFACE
    vec3 n = side * normalize(stage_normal.xyz);
    vec3 to_eye = normalize(this_view.eye.xyz - stage_position);
    float light = stage_normal.w;
    // The floor is near the feet and takes light from what faces it.
    float open = mix(0.72, 1.0, smoothstep(-0.9, 0.4, n.y + 0.5 * stage_position.y));
    vec3 c = lit(albedo, n, to_eye, light, open, 0.035);
    float rim = 1.0 - max(dot(n, to_eye), 0.0);
    c += albedo * ambient(n) * (0.35 * rim * rim * rim);
    colour = finish(c);
}
)";

// As above, for parts with a texture, with holes or with two sides.
inline constexpr std::string_view textured_vertex_glsl = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;  // w: key light
layout(location = 2) in vec3 colour;
layout(location = 3) in vec2 uv;
out vec3 stage_position;
out vec4 stage_normal;
out vec3 albedo_factor;
out vec2 texture_place;
void main() {
    stage_position = position;
    stage_normal = normal;
    albedo_factor = colour;
    texture_place = uv;
    gl_Position = this_view.clip_from_stage * vec4(position, 1.0);
}
)";

inline constexpr std::string_view textured_surface_glsl = R"(
layout(binding = 2) uniform sampler2D base_colour;
layout(location = 0) uniform float alpha_cutoff;
in vec3 albedo_factor;
in vec2 texture_place;
#define SURFACE \
    vec4 texel = texture(base_colour, texture_place); \
    if (texel.a < alpha_cutoff) discard; \
    vec3 albedo = albedo_factor * texel.rgb; \
    float side = gl_FrontFacing ? 1.0 : -1.0;
)";

inline constexpr std::string_view plain_surface_glsl = R"(
in vec3 albedo;
#define SURFACE const float side = 1.0;
)";

}  // namespace deixis::renderer
