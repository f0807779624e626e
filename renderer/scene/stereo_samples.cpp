#include "renderer/scene/stereo_samples.hpp"

#include <algorithm>
#include <array>

namespace deixis::renderer {
namespace {

int supportedTextureSamples(int wanted) {
    std::array<GLint, 2> max{1, 1};
    glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &max[0]);
    glGetIntegerv(GL_MAX_DEPTH_TEXTURE_SAMPLES, &max[1]);
    return std::clamp(wanted, 1, std::max(1, std::min<int>(max[0], max[1])));
}

void attach(const gl::Framebuffer& framebuffer, GLenum attachment, GLuint texture, int layer) {
    glNamedFramebufferTextureLayer(framebuffer.name(), attachment, texture, 0, layer);
}

}  // namespace

StereoSamples::StereoSamples(int samples)
    : samples_(supportedTextureSamples(samples)), read_(gl::framebuffer()), resolved_(gl::framebuffer()) {
    has_multiview_ = epoxy_has_gl_extension("GL_OVR_multiview2") && multiviewIsComplete();
}

// Not every driver that has multiview has it with several samples.
bool StereoSamples::multiviewIsComplete() {
    constexpr int side = 16;
    make(side, side, Views::both);
    const bool complete =
        gl::noErrors() &&
        glCheckNamedFramebufferStatus(drawn_.name(), GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    width_ = height_ = 0;
    return complete;
}

void StereoSamples::make(int width, int height, Views views) {
    const int layers = views == Views::both ? 2 : 1;
    width_ = width;
    height_ = height;
    views_ = views;
    colour_ = gl::sampledLayers(GL_SRGB8_ALPHA8, width, height, layers, samples_);
    depth_ = gl::sampledLayers(GL_DEPTH_COMPONENT32F, width, height, layers, samples_);
    drawn_ = gl::framebuffer();
    if (views == Views::both) {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, drawn_.name());
        glFramebufferTextureMultiviewOVR(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, colour_.name(), 0, 0, 2);
        glFramebufferTextureMultiviewOVR(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depth_.name(), 0, 0, 2);
    } else {
        attach(drawn_, GL_COLOR_ATTACHMENT0, colour_.name(), 0);
        attach(drawn_, GL_DEPTH_ATTACHMENT, depth_.name(), 0);
    }
}

void StereoSamples::begin(int width, int height, Views views) {
    if (width != width_ || height != height_ || views != views_) {
        make(width, height, views);
        gl::requireComplete(drawn_, "eyes' samples");
    }
    gl::beginPicture(drawn_, width, height);
}

void StereoSamples::readLayer(int eye) {
    const int layer = views_ == Views::both ? eye : 0;
    attach(read_, GL_COLOR_ATTACHMENT0, colour_.name(), layer);
    attach(read_, GL_DEPTH_ATTACHMENT, depth_.name(), layer);
}

void StereoSamples::resolve(const StereoTarget& target, int eye) {
    readLayer(eye);
    // Attached again in each frame: a swapchain has several textures, and a deleted one's name comes again.
    const auto side = static_cast<std::size_t>(eye);
    glNamedFramebufferTexture(resolved_.name(), GL_COLOR_ATTACHMENT0, target.colour[side], 0);
    glNamedFramebufferTexture(resolved_.name(), GL_DEPTH_ATTACHMENT, target.depth[side], 0);
    GLbitfield parts = GL_COLOR_BUFFER_BIT;
    if (target.depth[side] != 0U) parts |= GL_DEPTH_BUFFER_BIT;
    glEnable(GL_FRAMEBUFFER_SRGB);
    glBlitNamedFramebuffer(read_.name(), resolved_.name(), 0, 0, width_, height_, 0, 0, width_, height_,
                           parts, GL_NEAREST);
    glDisable(GL_FRAMEBUFFER_SRGB);
}

void StereoSamples::resolveLeft(GLuint framebuffer) {
    readLayer(0);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glBlitNamedFramebuffer(read_.name(), framebuffer, 0, 0, width_, height_, 0, 0, width_, height_,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glDisable(GL_FRAMEBUFFER_SRGB);
}

}  // namespace deixis::renderer
