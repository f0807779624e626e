#include "renderer/passes/trail_pass.hpp"

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace deixis::renderer {
namespace {

const std::string_view vertex_glsl = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 along;
layout(location = 2) in vec2 side_alpha;
out float across;  // metres from the middle line
out float fade;
out float pixel;   // size of a pixel here, metres

void main() {
    vec3 p = (this_view.eye_from_stage * vec4(position, 1.0)).xyz;
    vec3 direction = mat3(this_view.eye_from_stage) * along;
    vec3 side = cross(direction, normalize(p));
    side /= max(length(side), 1e-4);
    pixel = this_view.eye.w * max(-p.z, 0.05);
    across = side_alpha.x * max(0.012, 2.0 * pixel);
    fade = side_alpha.y;
    gl_Position = this_view.clip_from_eye * vec4(p + side * across, 1.0);
}
)";

const std::string_view fragment_glsl = R"(
layout(location = 0) uniform vec3 trail_colour;
in float across;
in float fade;
in float pixel;
out vec4 colour;
void main() {
    float d = abs(across);
    float radius = max(0.0028, 0.8 * pixel);
    float solid = 1.0 - smoothstep(radius - 0.6 * pixel, radius + 0.6 * pixel, d);
    float fall = clamp(1.0 - d / max(0.012, 2.0 * pixel), 0.0, 1.0);
    colour = vec4(trail_colour, 1.0) * (max(0.9 * solid, 0.25 * fall * fall) * fade);
}
)";

}  // namespace

TrailPass::TrailPass() : program_("trail", {vertex_glsl}, {fragment_glsl}), vertices_(gl::vertexArray()) {
    const GLuint vao = vertices_.name();
    glVertexArrayAttribFormat(vao, 0, 3, GL_FLOAT, GL_FALSE, offsetof(Vertex, position));
    glVertexArrayAttribFormat(vao, 1, 3, GL_FLOAT, GL_FALSE, offsetof(Vertex, along));
    glVertexArrayAttribFormat(vao, 2, 2, GL_FLOAT, GL_FALSE, offsetof(Vertex, side));
    for (GLuint attribute = 0; attribute < 3; ++attribute) {
        glVertexArrayAttribBinding(vao, attribute, 0);
        glEnableVertexArrayAttrib(vao, attribute);
    }
}

void TrailPass::place(const std::vector<Trail>& trails) {
    placed_.clear();
    strips_.clear();
    for (const Trail& trail : trails) {
        const std::size_t count = trail.points.size();
        if (count < 2) continue;
        strips_.push_back({static_cast<int>(placed_.size()), static_cast<int>(2 * count), trail.colour});
        for (std::size_t i = 0; i < count; ++i) {
            const Vec3 along = trail.points[std::min(i + 1, count - 1)] - trail.points[i > 0 ? i - 1 : 0];
            const double length_m = glm::length(along);
            const glm::vec3 direction(length_m > 0.0 ? along / length_m : Vec3(0.0));
            const float alpha = static_cast<float>(i) / static_cast<float>(count - 1);
            for (const float side : {-1.0F, 1.0F})
                placed_.push_back({glm::vec3(trail.points[i]), direction, side, alpha});
        }
    }
    if (placed_.empty()) return;
    const auto bytes = static_cast<GLsizeiptr>(placed_.size() * sizeof(Vertex));
    if (bytes > capacity_) {
        points_ = gl::dynamicBuffer(bytes);
        capacity_ = bytes;
        glVertexArrayVertexBuffer(vertices_.name(), 0, points_.name(), 0, sizeof(Vertex));
    }
    glNamedBufferSubData(points_.name(), 0, bytes, placed_.data());
}

void TrailPass::draw(Views views) {
    if (strips_.empty()) return;
    program_.use(views);
    glBindVertexArray(vertices_.name());
    for (const Strip& strip : strips_) {
        glUniform3fv(0, 1, glm::value_ptr(strip.colour));
        glDrawArrays(GL_TRIANGLE_STRIP, strip.first, strip.count);
    }
}

}  // namespace deixis::renderer
