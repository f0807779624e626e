#include "renderer/passes/room_pass.hpp"

#include <fmt/format.h>

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "renderer/scene/frame.hpp"

namespace deixis::renderer {
namespace {

const std::string_view room_vertex_glsl = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
out vec3 stage_position;
flat out vec3 stage_normal;
void main() {
    stage_position = position;
    stage_normal = normal;
    gl_Position = this_view.clip_from_stage * vec4(position, 1.0);
}
)";

const std::string_view floor_fragment_glsl = R"(
in vec3 stage_position;
out vec4 colour;

// How much of the pixel a grid of lines covers: the lines' box filtered over the pixel's footprint, so that
// far away they fade into their mean instead of shimmering.
float grid(vec2 p, float spacing, float width, vec2 footprint) {
    vec2 w = max(footprint, 1e-4);
    vec2 drawn = max(vec2(width), w);
    vec2 d = abs(fract(p / spacing - 0.5) - 0.5) * spacing;
    vec2 cover = clamp((drawn * 0.5 + w * 0.5 - d) / w, 0.0, 1.0) * (width / drawn);
    vec2 mean = vec2(width / spacing);
    cover = mix(cover, mean, smoothstep(0.25, 0.6, w / spacing));
    return cover.x + cover.y - cover.x * cover.y;
}

// Squares of one metre, alternately a little lighter, filtered the same way.
float squares(vec2 p, vec2 footprint) {
    vec2 w = max(footprint, 1e-4);
    vec2 wave = clamp((0.5 - abs(2.0 * fract(p * 0.5 + 0.25) - 1.0)) / w, -1.0, 1.0);
    return wave.x * wave.y * (1.0 - smoothstep(0.5, 1.0, max(w.x, w.y)));
}

// The part of the sky that the feet cover: a sphere's at the nearest point of each sole's middle line.
float footOcclusion(vec3 p) {
    float open = 1.0;
    for (int i = 0; i < 2 * int(shadow.z); ++i) {
        vec3 a = feet[2 * i].xyz;
        vec3 ab = feet[2 * i + 1].xyz - a;
        float r = feet[2 * i].w;
        vec3 to = a + ab * clamp(dot(p - a, ab) / max(dot(ab, ab), 1e-6), 0.0, 1.0) - p;
        float d2 = max(dot(to, to), 1e-6);
        float height = max(to.y, 0.0);
        open *= 1.0 - clamp(r * r * (height + 0.35 * r) / (d2 * sqrt(d2) + r * r * r * 0.6), 0.0, 0.85);
    }
    return open;
}

void main() {
    vec3 p = stage_position;
    vec2 footprint = fwidth(p.xz);
    vec3 albedo = vec3(0.405, 0.375, 0.340) * (1.0 + 0.030 * squares(p.xz, footprint));
    float lines = max(0.50 * grid(p.xz, 1.0, 0.012, footprint), 0.22 * grid(p.xz, 0.5, 0.006, footprint));
    albedo *= 1.0 - lines;
    vec2 wall = min(p.xz - room_low.xz, room_high.xz - p.xz);
    float open = 1.0 - 0.30 * exp(-wall.x * 2.2) - 0.30 * exp(-wall.y * 2.2);
    open *= footOcclusion(p);
    float light = avatarLight(p, vec3(0.0, 1.0, 0.0), pixelNoise()) * ballLight(p) * mix(open, 1.0, 0.5);
    // The key light is a lamp over the middle of the room: it falls off softly towards the walls.
    float r2 = dot(p.xz - vec2(0.0, 0.8), p.xz - vec2(0.0, 0.8));
    light *= 1.0 / (1.0 + 0.018 * r2);
    colour = finish(lit(albedo, vec3(0.0, 1.0, 0.0), vec3(0.0, 1.0, 0.0), light, open, 0.0));
}
)";

const std::string_view wall_fragment_glsl = R"(
in vec3 stage_position;
flat in vec3 stage_normal;
out vec4 colour;
void main() {
    vec3 p = stage_position;
    vec3 low = p - room_low;
    vec3 high = room_high - p;
    vec3 near = min(low, high);
    // Corners are a little darker; the face itself (distance 0 along its normal) does not count.
    vec3 corner = 0.16 * exp(-near * 2.0) * (1.0 - abs(stage_normal));
    float open = 1.0 - corner.x - corner.y - corner.z;
    float height = low.y / (room_high.y - room_low.y);
    vec3 wall = mix(vec3(0.440, 0.408, 0.368), vec3(0.540, 0.512, 0.472), smoothstep(0.0, 0.9, height));
    float px = max(fwidth(p.y), 1e-4);
    float board = 1.0 - smoothstep(0.090 - 0.5 * px, 0.090 + 0.5 * px, p.y);
    float groove = 1.0 - smoothstep(0.003 + 0.2 * px, 0.004 + 0.8 * px, abs(p.y - 0.092));
    wall = mix(wall, vec3(0.62, 0.60, 0.565), board);
    wall *= 1.0 - 0.28 * groove * min(1.0, 0.008 / px);
    vec3 ceiling = vec3(0.60, 0.585, 0.555);
    vec3 c = abs(stage_normal.y) > 0.5 ? ceiling : wall;
    colour = finish(c * open);
}
)";

std::string roomSizeGlsl() {
    const auto constant = [](const char* name, const Vec3& v) {
        return fmt::format("const vec3 {} = vec3({:.3f}, {:.3f}, {:.3f});\n", name, v.x, v.y, v.z);
    };
    return constant("room_low", room_low) + constant("room_high", room_high);
}

struct RoomCorner {
    glm::vec3 position, normal;
};

// Two triangles a face, floor first, seen from within.
std::vector<RoomCorner> roomCorners() {
    std::vector<RoomCorner> corners;
    const auto face = [&](int axis, bool high) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        glm::vec3 normal(0.0F);
        normal[axis] = high ? -1.0F : 1.0F;
        const auto corner = [&](bool u_high, bool v_high) {
            Vec3 p;
            p[axis] = high ? room_high[axis] : room_low[axis];
            p[u] = u_high ? room_high[u] : room_low[u];
            p[v] = v_high ? room_high[v] : room_low[v];
            corners.push_back({glm::vec3(p), normal});
        };
        corner(false, false);
        corner(true, false);
        corner(true, true);
        corner(false, false);
        corner(true, true);
        corner(false, true);
    };
    face(1, false);
    face(1, true);
    for (const int axis : {0, 2}) {
        face(axis, false);
        face(axis, true);
    }
    return corners;
}

constexpr GLsizei face_vertices = 6;

}  // namespace

RoomPass::RoomPass()
    : floor_program_("floor", {room_vertex_glsl},
                     {frame_glsl, shadow_glsl, lighting_glsl, roomSizeGlsl(), floor_fragment_glsl}),
      wall_program_("wall", {room_vertex_glsl},
                    {frame_glsl, lighting_glsl, roomSizeGlsl(), wall_fragment_glsl}),
      vertices_(gl::vertexArray()) {
    const std::vector<RoomCorner> corners = roomCorners();
    corners_ = gl::fixedBuffer(std::span<const RoomCorner>(corners));
    const GLuint vao = vertices_.name();
    glVertexArrayVertexBuffer(vao, 0, corners_.name(), 0, sizeof(RoomCorner));
    glVertexArrayAttribFormat(vao, 0, 3, GL_FLOAT, GL_FALSE, offsetof(RoomCorner, position));
    glVertexArrayAttribFormat(vao, 1, 3, GL_FLOAT, GL_FALSE, offsetof(RoomCorner, normal));
    for (GLuint attribute = 0; attribute < 2; ++attribute) {
        glVertexArrayAttribBinding(vao, attribute, 0);
        glEnableVertexArrayAttrib(vao, attribute);
    }
}

void RoomPass::draw(Views views) {
    glBindVertexArray(vertices_.name());
    floor_program_.use(views);
    glDrawArrays(GL_TRIANGLES, 0, face_vertices);
    wall_program_.use(views);
    glDrawArrays(GL_TRIANGLES, face_vertices, 5 * face_vertices);
}

}  // namespace deixis::renderer
