#include "renderer/passes/ball_pass.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/gtc/type_ptr.hpp>

namespace deixis::renderer {
namespace {

const std::string_view ball_vertex_glsl = R"(
layout(location = 0) in vec3 normal;
layout(location = 1) in vec4 place;  // centre, radius
layout(location = 2) in vec3 own_colour;
layout(location = 3) in vec3 own_glow;
out vec3 stage_position;
out vec3 stage_normal;
flat out vec3 albedo;
flat out vec3 glow;
out float light;
void main() {
    stage_position = place.xyz + place.w * normal;
    stage_normal = normal;
    albedo = own_colour;
    glow = own_glow;
    light = avatarLight(stage_position, normal, 0.0) * ballLight(stage_position);
    gl_Position = this_view.clip_from_stage * vec4(stage_position, 1.0);
}
)";

const std::string_view ball_fragment_glsl = R"(
in vec3 stage_position;
in vec3 stage_normal;
flat in vec3 albedo;
flat in vec3 glow;
in float light;
out vec4 colour;
void main() {
    vec3 n = normalize(stage_normal);
    vec3 to_eye = normalize(this_view.eye.xyz - stage_position);
    colour = finish(lit(albedo, n, to_eye, light, 1.0, 0.11) + glow);
}
)";

// One or two flat rings around the ball's centre that always face the eye.
const std::string_view ring_vertex_glsl = R"(
layout(location = 0) uniform vec4 ball;  // centre, radius
layout(location = 1) uniform int rings;
out vec2 across;  // metres from the ring's centre
flat out float pixel;

void main() {
    vec3 centre = (this_view.eye_from_stage * vec4(ball.xyz, 1.0)).xyz;
    vec3 away = normalize(centre);
    vec3 right = normalize(cross(away, vec3(0.0, 1.0, 0.0)));
    pixel = this_view.eye.w * max(-centre.z, 0.05);
    float reach = rings > 1 ? 2.4 : 1.9;  // of the radius
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
    across = corner * (reach * ball.w + 2.0 * pixel);
    gl_Position = this_view.clip_from_eye *
                  vec4(centre + right * across.x + cross(right, away) * across.y, 1.0);
}
)";

const std::string_view ring_fragment_glsl = R"(
layout(location = 0) uniform vec4 ball;
layout(location = 1) uniform int rings;
in vec2 across;
flat in float pixel;
out vec4 colour;
void main() {
    float off = abs(length(across) - 1.55 * ball.w);
    if (rings > 1) off = min(off, abs(length(across) - 2.05 * ball.w));
    float half_width = max(0.10 * ball.w, 0.9 * pixel);
    float solid = 1.0 - smoothstep(half_width - 0.6 * pixel, half_width + 0.6 * pixel, off);
    float fall = clamp(1.0 - off / max(0.35 * ball.w, 2.0 * pixel), 0.0, 1.0);
    float alpha = max(0.95 * solid, 0.35 * fall * fall);
    colour = vec4(vec3(0.90, 1.0, 0.93), 1.0) * alpha;
}
)";

constexpr int rings = 18;
constexpr int segments = 32;

}  // namespace

BallPass::BallPass()
    : program_("ball", {frame_glsl, shadow_glsl, ball_vertex_glsl},
               {frame_glsl, lighting_glsl, ball_fragment_glsl}),
      ring_program_("ring", {ring_vertex_glsl}, {ring_fragment_glsl}),
      vertices_(gl::vertexArray()),
      no_vertices_(gl::vertexArray()) {
    std::vector<glm::vec3> normals;
    std::vector<std::uint16_t> indices;
    for (int ring = 0; ring <= rings; ++ring) {
        const double polar = pi * ring / rings;
        for (int segment = 0; segment <= segments; ++segment) {
            const double azimuth = 2.0 * pi * segment / segments;
            normals.emplace_back(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                 std::sin(polar) * std::cos(azimuth));
            if (ring == rings || segment == segments) continue;
            const int here = ring * (segments + 1) + segment;
            const int below = here + segments + 1;
            for (const int index : {here, below, here + 1, here + 1, below, below + 1})
                indices.push_back(static_cast<std::uint16_t>(index));
        }
    }
    sphere_ = gl::fixedBuffer(std::span<const glm::vec3>(normals));
    indices_ = gl::fixedBuffer(std::span<const std::uint16_t>(indices));
    index_count_ = static_cast<GLsizei>(indices.size());
    const GLuint vao = vertices_.name();
    glVertexArrayVertexBuffer(vao, 0, sphere_.name(), 0, sizeof(glm::vec3));
    glVertexArrayElementBuffer(vao, indices_.name());
    glVertexArrayAttribFormat(vao, 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(vao, 0, 0);
    glVertexArrayAttribFormat(vao, 1, 4, GL_FLOAT, GL_FALSE, offsetof(Instance, place));
    glVertexArrayAttribFormat(vao, 2, 3, GL_FLOAT, GL_FALSE, offsetof(Instance, colour));
    glVertexArrayAttribFormat(vao, 3, 3, GL_FLOAT, GL_FALSE, offsetof(Instance, glow));
    for (GLuint attribute = 1; attribute < 4; ++attribute) glVertexArrayAttribBinding(vao, attribute, 1);
    for (GLuint attribute = 0; attribute < 4; ++attribute) glEnableVertexArrayAttrib(vao, attribute);
    glVertexArrayBindingDivisor(vao, 1, 1);
}

void BallPass::placeShadows(const std::vector<Ball>& balls, FrameBlock& block) {
    const std::size_t count = std::min(balls.size(), block.balls.size());
    for (std::size_t i = 0; i < count; ++i)
        block.balls[i] = glm::vec4(glm::vec3(balls[i].centre), static_cast<float>(balls[i].radius_m));
    block.to_light.w = static_cast<float>(count);
}

void BallPass::place(const std::vector<Ball>& balls) {
    placed_.clear();
    ringed_.clear();
    for (const Ball& ball : balls) {
        const glm::vec4 place(glm::vec3(ball.centre), static_cast<float>(ball.radius_m));
        placed_.push_back({place, ball.colour, ball.glow});
        if (ball.rings > 0) ringed_.push_back({place, ball.rings});
    }
    if (placed_.empty()) return;
    const auto bytes = static_cast<GLsizeiptr>(placed_.size() * sizeof(Instance));
    if (bytes > instance_capacity_) {
        instances_ = gl::dynamicBuffer(bytes);
        instance_capacity_ = bytes;
        glVertexArrayVertexBuffer(vertices_.name(), 1, instances_.name(), 0, sizeof(Instance));
    }
    glNamedBufferSubData(instances_.name(), 0, bytes, placed_.data());
}

void BallPass::draw(Views views) {
    if (placed_.empty()) return;
    program_.use(views);
    glBindVertexArray(vertices_.name());
    glEnable(GL_CULL_FACE);
    glDrawElementsInstanced(GL_TRIANGLES, index_count_, GL_UNSIGNED_SHORT, nullptr,
                            static_cast<GLsizei>(placed_.size()));
    glDisable(GL_CULL_FACE);
}

void BallPass::drawRings(Views views) {
    if (ringed_.empty()) return;
    ring_program_.use(views);
    glBindVertexArray(no_vertices_.name());
    for (const Ringed& ball : ringed_) {
        glUniform4fv(0, 1, glm::value_ptr(ball.place));
        glUniform1i(1, ball.rings);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
}

}  // namespace deixis::renderer
