#include "renderer/scene/frame.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace deixis::renderer {

Vec3 directionToLight() {
    return glm::normalize(Vec3(0.06, 1.0, 0.165));
}

glm::mat4 matrixFromPose(const Pose& pose) {
    glm::mat4 matrix(glm::mat4_cast(pose.orientation));
    matrix[3] = glm::vec4(glm::vec3(pose.position), 1.0F);
    return matrix;
}

static_assert(max_avatars == 2 && foot_count == 4 && max_shadow_balls == 64, "as the shader has it");

const std::string_view frame_glsl = R"(
layout(std140, binding = 0) uniform Frame {
    mat4 shadow_from_stage[2];
    vec4 to_light;
    vec4 shadow;
    vec4 shadow_box[2];
    vec4 feet[8];
    vec4 balls[64];
};
)";

const std::string_view shadow_glsl = R"(
layout(binding = 0) uniform sampler2DArrayShadow shadow_maps;
layout(binding = 1) uniform sampler2DArray shadow_depths;

// How much of the key light, a disc of 1.7 degrees radius, the balls leave at point p: for each the part of
// the disc that a sphere covers, exact where the disc is wholly covered or free and smooth between.
float ballLight(vec3 p) {
    float light = 1.0;
    for (int i = 0; i < int(to_light.w); ++i) {
        vec3 to_ball = balls[i].xyz - p;
        float along = dot(to_ball, to_light.xyz);
        float across = length(to_ball - along * to_light.xyz);
        float r = balls[i].w;
        float disc = 0.03 * max(along, 0.0) + 1e-4;
        float cover = min(1.0, r * r / (disc * disc));
        float shade = cover * (1.0 - smoothstep(abs(r - disc), r + disc, across));
        light *= 1.0 - shade * step(r * 0.5, along);
    }
    return light;
}

// How much of the key light one avatar leaves at point p with normal n. The wider the gap to what shades, the
// softer. Outside the avatar's extent the loops end at once, which processors without branches profit from.
float lightPast(int avatar, vec3 p, vec3 n, float noise) {
    vec3 q = (shadow_from_stage[avatar] * vec4(p + n * 0.006, 1.0)).xyz;
    const float widest = 0.03;
    float margin = widest * shadow.x;
    bool inside = all(greaterThan(q.xy, shadow_box[avatar].xy - margin)) &&
                  all(lessThan(q.xy, shadow_box[avatar].zw + margin));
    float layer = float(avatar);
    vec2 spiral = vec2(1.0, 0.0);
    const mat2 golden = mat2(-0.737369, 0.675490, -0.675490, -0.737369);
    float gap = 0.0;
    float found = 0.0;
    int searches = inside ? 4 : 0;
    for (int i = 0; i < searches; ++i) {
        vec2 at = q.xy + spiral * (margin * sqrt((float(i) + 0.5) / 4.0));
        float d = textureLod(shadow_depths, vec3(at, layer), 0.0).r;
        float g = (q.z - d) * shadow.y;
        if (g > 0.0) {
            gap += g;
            found += 1.0;
        }
        spiral = golden * spiral;
    }
    gap = found > 0.0 ? gap / found : 1.0;
    float radius = clamp(0.03 * gap, 0.004, widest) * shadow.x;
    float turn = 6.2831853 * noise;
    spiral = vec2(cos(turn), sin(turn));
    const int taps = 10;
    int used = inside ? taps : 0;
    float light = inside ? 0.0 : float(taps);
    for (int i = 0; i < used; ++i) {
        vec2 at = q.xy + spiral * (radius * sqrt((float(i) + 0.5) / float(taps)));
        light += texture(shadow_maps, vec4(at, layer, q.z));
        spiral = golden * spiral;
    }
    return light / float(taps);
}

float avatarLight(vec3 p, vec3 n, float noise) {
    float light = 1.0;
    for (int i = 0; i < int(shadow.z); ++i) light *= lightPast(i, p, n, noise);
    return light;
}
)";

const std::string_view lighting_glsl = R"(
// A different number for each pixel, without the clumps of white noise (interleaved gradient noise).
float pixelNoise() {
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
}

const vec3 key_colour = vec3(1.00, 0.965, 0.91);
const vec3 sky_colour = vec3(0.46, 0.475, 0.50);
const vec3 ground_colour = vec3(0.27, 0.245, 0.22);

vec3 ambient(vec3 n) { return mix(ground_colour, sky_colour, n.y * 0.5 + 0.5); }

// A matte surface: key light (light: what shadows leave of it), a weak fill from the front, ambient light
// (open: what its surroundings leave of it), and a soft highlight.
vec3 lit(vec3 albedo, vec3 n, vec3 to_eye, float light, float open, float gloss) {
    float key = clamp((dot(n, to_light.xyz) + 0.15) / 1.15, 0.0, 1.0) * light;
    float fill = 0.5 + 0.5 * dot(n, vec3(-0.25, 0.30, 0.92));
    vec3 diffuse = key_colour * (0.72 * key) + open * (ambient(n) + vec3(0.24, 0.235, 0.23) * fill * fill);
    float facing = max(dot(n, normalize(to_light.xyz + to_eye)), 0.0);
    float lobe = facing * facing;
    lobe *= lobe;
    lobe *= lobe;
    lobe *= lobe;
    return albedo * diffuse + gloss * lobe * key * key_colour;
}

// What the eye gets of linear light: as it is up to 0.7, above that bent towards 1; with noise of half a step
// of the 8-bit sRGB that it becomes, against banding.
vec4 finish(vec3 light) {
    vec3 over = max(light - 0.7, 0.0);
    vec3 colour = min(light, 0.7) + 0.3 * over / (over + 0.3);
    colour += (pixelNoise() - 0.5) * (2.0 / 255.0) * sqrt(colour);
    return vec4(colour, 1.0);
}
)";

}  // namespace deixis::renderer
