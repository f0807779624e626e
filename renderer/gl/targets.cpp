#include "renderer/gl/targets.hpp"

#include <algorithm>

namespace deixis::renderer {
namespace {

int supportedBufferSamples(int wanted) {
    GLint max = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &max);
    return std::clamp(wanted, 1, std::max(1, static_cast<int>(max)));
}

}  // namespace

Targets::Targets(int samples) : samples_(supportedBufferSamples(samples)) {}

void Targets::begin(int width, int height) {
    if (width != width_ || height != height_) {
        width_ = width;
        height_ = height;
        colour_ = gl::renderbuffer(GL_SRGB8_ALPHA8, width, height, samples_);
        depth_ = gl::renderbuffer(GL_DEPTH_COMPONENT24, width, height, samples_);
        drawn_ = gl::framebuffer();
        glNamedFramebufferRenderbuffer(drawn_.name(), GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_.name());
        glNamedFramebufferRenderbuffer(drawn_.name(), GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
        gl::requireComplete(drawn_, "picture");
        resolved_colour_ = gl::renderbuffer(GL_SRGB8_ALPHA8, width, height, 1);
        resolved_ = gl::framebuffer();
        glNamedFramebufferRenderbuffer(resolved_.name(), GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                       resolved_colour_.name());
        gl::requireComplete(resolved_, "resolved picture");
    }
    gl::beginPicture(drawn_, width, height);
}

void Targets::resolve() {
    glEnable(GL_FRAMEBUFFER_SRGB);
    glBlitNamedFramebuffer(drawn_.name(), resolved_.name(), 0, 0, width_, height_, 0, 0, width_, height_,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glDisable(GL_FRAMEBUFFER_SRGB);
}

void Targets::copyTo(GLuint framebuffer) const {
    gl::copyPicture(resolved_, framebuffer, width_, height_);
}

void Targets::read(void* rgb) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, rgb);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
}

}  // namespace deixis::renderer
