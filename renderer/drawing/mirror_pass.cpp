#include "mirror_pass.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace deixis::renderer {
namespace {

const std::string_view mirror_vertex_glsl = R"(
layout(location = 0) uniform vec2 shown;  // the part of the eye's picture, across and up
out vec2 uv;
void main() {
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    uv = (corner - 0.5) * shown + 0.5;
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
)";

const std::string_view mirror_fragment_glsl = R"(
layout(binding = 0) uniform sampler2D eye_picture;
in vec2 uv;
out vec4 colour;
void main() { colour = texture(eye_picture, uv); }
)";

}  // namespace

MirrorPass::MirrorPass()
    : program_(gl::drawProgram("mirror", {mirror_vertex_glsl}, {mirror_fragment_glsl})),
      no_vertices_(gl::vertexArray()) {}

void MirrorPass::makeEyePicture(int width, int height) {
    if (width == eye_width_ && height == eye_height_) return;
    eye_width_ = width;
    eye_height_ = height;
    const int levels = 1 + static_cast<int>(std::log2(std::max(width, height)));
    eye_ = gl::texture2d(GL_SRGB8_ALPHA8, width, height, levels);
    glTextureParameteri(eye_.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTextureParameteri(eye_.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    eye_target_ = gl::framebuffer();
    glNamedFramebufferTexture(eye_target_.name(), GL_COLOR_ATTACHMENT0, eye_.name(), 0);
    gl::requireComplete(eye_target_, "left eye's picture");
}

void MirrorPass::makeMirror(int width, int height) {
    if (width == width_ && height == height_) return;
    width_ = width;
    height_ = height;
    mirror_ = gl::renderbuffer(GL_SRGB8_ALPHA8, width, height, 1);
    mirror_target_ = gl::framebuffer();
    glNamedFramebufferRenderbuffer(mirror_target_.name(), GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                   mirror_.name());
    gl::requireComplete(mirror_target_, "mirror");
}

void MirrorPass::draw(StereoSamples& samples, ScenePasses& passes, const Scene& scene, const Eye& left,
                      int width, int height, GLuint framebuffer) {
    gl::resetDrawingState();
    glDisable(GL_FRAMEBUFFER_SRGB);
    if (samples.width() == 0) {
        gl::bindForeign(framebuffer, width, height);
        const std::array<GLfloat, 4> black{0.0F, 0.0F, 0.0F, 1.0F};
        glClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, black.data());
        return;
    }
    makeEyePicture(samples.width(), samples.height());
    samples.resolveLeft(eye_target_.name());
    glGenerateTextureMipmap(eye_.name());

    makeMirror(width, height);
    const glm::dvec2 ratio(static_cast<double>(width) / eye_width_,
                           static_cast<double>(height) / eye_height_);
    const glm::dvec2 shown = ratio / std::max(ratio.x, ratio.y);
    glBindFramebuffer(GL_FRAMEBUFFER, mirror_target_.name());
    glViewport(0, 0, width, height);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glUseProgram(program_.name());
    glUniform2f(0, static_cast<float>(shown.x), static_cast<float>(shown.y));
    glBindTextureUnit(0, eye_.name());
    glBindVertexArray(no_vertices_.name());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    if (!scene.boards.empty()) {
        passes.boards().paint(scene.boards);
        glBindFramebuffer(GL_FRAMEBUFFER, mirror_target_.name());
        glViewport(0, 0, width, height);
        glEnable(GL_FRAMEBUFFER_SRGB);
        ViewBlock view = viewBlock(left, 0, scene.camera.near_m, scene.camera.far_m, eye_height_);
        view.clip_from_stage =
            glm::scale(glm::mat4(1.0F), glm::vec3(1.0 / shown.x, 1.0 / shown.y, 1.0)) * view.clip_from_stage;
        passes.replaceView(view);
        // Under what is there: only where the picture lets something through.
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE_MINUS_DST_ALPHA, GL_ONE);
        passes.boards().draw(scene.boards.front(), Views::one);
        glDisable(GL_BLEND);
    }
    gl::copyPicture(mirror_target_, framebuffer, width, height);
}

}  // namespace deixis::renderer
