#include "renderer/passes/hidden_area_pass.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace deixis::renderer {
namespace {

// Both eyes' triangles are drawn for each; the other eye's end outside of what is clipped.
const std::string_view hidden_area_vertex_glsl = R"(
layout(location = 0) in vec2 tangents;
layout(location = 1) in uint side;
void main() {
    gl_Position = this_view.clip_from_eye * vec4(tangents, -1.0, 1.0);
    gl_Position.z = -gl_Position.w;
    if (side != this_view.side) gl_Position = vec4(0.0, 0.0, -2.0, 1.0);
}
)";

const std::string_view hidden_area_fragment_glsl = R"(
out vec4 colour;
void main() { colour = vec4(0.0, 0.0, 0.0, 1.0); }
)";

struct Corner {
    glm::vec2 tangents;
    GLuint side;
};

}  // namespace

HiddenAreaPass::HiddenAreaPass()
    : program_("hidden area", {hidden_area_vertex_glsl}, {hidden_area_fragment_glsl}),
      vertices_(gl::vertexArray()) {
    const GLuint vao = vertices_.name();
    glVertexArrayAttribFormat(vao, 0, 2, GL_FLOAT, GL_FALSE, offsetof(Corner, tangents));
    glVertexArrayAttribIFormat(vao, 1, 1, GL_UNSIGNED_INT, offsetof(Corner, side));
    for (GLuint attribute = 0; attribute < 2; ++attribute) {
        glVertexArrayAttribBinding(vao, attribute, 0);
        glEnableVertexArrayAttrib(vao, attribute);
    }
}

void HiddenAreaPass::set(const std::array<HiddenArea, 2>& areas) {
    std::vector<Corner> corners;
    std::vector<GLuint> indices;
    for (GLuint side = 0; side < areas.size(); ++side) {
        const HiddenArea& area = areas[side];
        const std::size_t corner_count = area.corners.size();
        if (area.indices.size() % 3 != 0 ||
            std::any_of(area.indices.begin(), area.indices.end(),
                        [&](unsigned int index) { return index >= corner_count; }))
            throw std::invalid_argument(
                fmt::format("{} indices are no triangles of {} corners", area.indices.size(), corner_count));
        const auto first = static_cast<GLuint>(corners.size());
        for (const glm::vec2& tangents : area.corners) corners.push_back({tangents, side});
        for (const unsigned int index : area.indices) indices.push_back(first + index);
    }
    corners_ = gl::fixedBuffer(std::span<const Corner>(corners));
    indices_ = gl::fixedBuffer(std::span<const GLuint>(indices));
    index_count_ = static_cast<GLsizei>(indices.size());
    glVertexArrayVertexBuffer(vertices_.name(), 0, corners_.name(), 0, sizeof(Corner));
    glVertexArrayElementBuffer(vertices_.name(), indices_.name());
}

void HiddenAreaPass::draw(Views views) {
    if (index_count_ == 0) return;
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    program_.use(views);
    glBindVertexArray(vertices_.name());
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace deixis::renderer
