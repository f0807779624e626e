#include "renderer/passes/head_pass.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace deixis::renderer {
namespace {

const std::string_view head_vertex_glsl = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float own_shade;
layout(location = 0) uniform mat4 stage_from_head;
out vec3 stage_position;
out vec3 stage_normal;
out float light;
flat out float shade;
void main() {
    stage_position = (stage_from_head * vec4(position, 1.0)).xyz;
    stage_normal = mat3(stage_from_head) * normal;
    light = avatarLight(stage_position, stage_normal, 0.0) * ballLight(stage_position);
    shade = own_shade;
    gl_Position = this_view.clip_from_stage * vec4(stage_position, 1.0);
}
)";

const std::string_view head_fragment_glsl = R"(
layout(location = 1) uniform vec3 head_colour;
in vec3 stage_position;
in vec3 stage_normal;
in float light;
flat in float shade;
out vec4 colour;
void main() {
    vec3 n = normalize(stage_normal);
    vec3 to_eye = normalize(this_view.eye.xyz - stage_position);
    colour = finish(lit(mix(vec3(0.015), head_colour, shade), n, to_eye, light, 1.0, 0.06));
}
)";

struct HeadCorner {
    glm::vec3 position, normal;
    float shade;  // 1: the head's colour; 0: black
};

/// A body between a ball (roundness 1) and a box (towards 0), in the head's frame, metres.
struct Body {
    Vec3 centre, half;
    double roundness = 1.0;
    float shade = 1.0F;
};

// From between the eyes: the head lies behind, the headset before them.
constexpr double round = 1.0;
const std::array<Body, 2> bodies{Body{{0.0, -0.015, 0.085}, {0.078, 0.118, 0.098}, round, 1.0F},
                                 Body{{0.0, 0.0, -0.022}, {0.088, 0.050, 0.042}, 0.35, 0.0F}};

constexpr int head_rings = 20;
constexpr int head_segments = 40;

double bent(double value, double exponent) {
    return std::copysign(std::pow(std::abs(value), exponent), value);
}

}  // namespace

HeadPass::HeadPass()
    : program_("head", {frame_glsl, shadow_glsl, head_vertex_glsl},
               {frame_glsl, lighting_glsl, head_fragment_glsl}),
      vertices_(gl::vertexArray()) {
    std::vector<HeadCorner> corners;
    std::vector<std::uint16_t> indices;
    for (const Body& body : bodies)
        for (int ring = 0; ring <= head_rings; ++ring) {
            const double polar = pi * ring / head_rings;
            for (int segment = 0; segment <= head_segments; ++segment) {
                const double azimuth = 2.0 * pi * segment / head_segments;
                const Vec3 unit(std::sin(azimuth), std::cos(polar), std::cos(azimuth));
                const double e = body.roundness;
                const double level = std::pow(std::sin(polar), e);
                const Vec3 p(level * bent(unit.x, e), bent(unit.y, e), level * bent(unit.z, e));
                const double level_n = std::pow(std::sin(polar), 2.0 - e);
                const Vec3 n(level_n * bent(unit.x, 2.0 - e), bent(unit.y, 2.0 - e),
                             level_n * bent(unit.z, 2.0 - e));
                corners.push_back({glm::vec3(body.centre + body.half * p),
                                   glm::vec3(glm::normalize(n / body.half)), body.shade});
                if (ring == head_rings || segment == head_segments) continue;
                const auto here = static_cast<int>(corners.size()) - 1;
                const int below = here + head_segments + 1;
                for (const int index : {here, below, here + 1, here + 1, below, below + 1})
                    indices.push_back(static_cast<std::uint16_t>(index));
            }
        }
    corners_ = gl::fixedBuffer(std::span<const HeadCorner>(corners));
    indices_ = gl::fixedBuffer(std::span<const std::uint16_t>(indices));
    index_count_ = static_cast<GLsizei>(indices.size());
    const GLuint vao = vertices_.name();
    glVertexArrayVertexBuffer(vao, 0, corners_.name(), 0, sizeof(HeadCorner));
    glVertexArrayElementBuffer(vao, indices_.name());
    glVertexArrayAttribFormat(vao, 0, 3, GL_FLOAT, GL_FALSE, offsetof(HeadCorner, position));
    glVertexArrayAttribFormat(vao, 1, 3, GL_FLOAT, GL_FALSE, offsetof(HeadCorner, normal));
    glVertexArrayAttribFormat(vao, 2, 1, GL_FLOAT, GL_FALSE, offsetof(HeadCorner, shade));
    for (GLuint attribute = 0; attribute < 3; ++attribute) {
        glVertexArrayAttribBinding(vao, attribute, 0);
        glEnableVertexArrayAttrib(vao, attribute);
    }
}

void HeadPass::draw(const std::vector<HeadMarker>& heads, Views views) {
    if (heads.empty()) return;
    program_.use(views);
    glBindVertexArray(vertices_.name());
    for (const HeadMarker& head : heads) {
        const glm::mat4 stage_from_head = matrixFromPose(head.stage_from_head);
        glUniformMatrix4fv(0, 1, GL_FALSE, glm::value_ptr(stage_from_head));
        glUniform3fv(1, 1, glm::value_ptr(head.colour));
        glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_SHORT, nullptr);
    }
}

}  // namespace deixis::renderer
