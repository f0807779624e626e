#include "app/operator/mirror_picture.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

namespace deixis::app {

WindowSize fittedSize(WindowSize shown, WindowSize max) {
    const double scale = std::min({1.0, static_cast<double>(max.width) / std::max(1, shown.width),
                                   static_cast<double>(max.height) / std::max(1, shown.height)});
    const auto scaled = [scale](int length) {
        return std::max(1, static_cast<int>(std::lround(scale * length)));
    };
    return {scaled(shown.width), scaled(shown.height)};
}

MirrorPicture::~MirrorPicture() {
    if (copied_ != nullptr) glDeleteSync(static_cast<GLsync>(copied_));
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteTextures(1, &kept_.texture);
}

void MirrorPicture::take(WindowSize shown, WindowSize max) {
    const WindowSize size = fittedSize(shown, max);
    if (kept_.texture == 0 || size.width != kept_.size.width || size.height != kept_.size.height) {
        glDeleteTextures(1, &kept_.texture);
        glCreateTextures(GL_TEXTURE_2D, 1, &kept_.texture);
        glTextureStorage2D(kept_.texture, 1, GL_RGBA8, size.width, size.height);
        glTextureParameteri(kept_.texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTextureParameteri(kept_.texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        kept_.size = size;
        if (framebuffer_ == 0) glCreateFramebuffers(1, &framebuffer_);
        glNamedFramebufferTexture(framebuffer_, GL_COLOR_ATTACHMENT0, kept_.texture, 0);
    }
    glBlitNamedFramebuffer(0, framebuffer_, 0, 0, shown.width, shown.height, 0, 0, size.width, size.height,
                           GL_COLOR_BUFFER_BIT, GL_LINEAR);
    if (copied_ != nullptr) glDeleteSync(static_cast<GLsync>(copied_));
    copied_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush();
}

MirrorTexture MirrorPicture::texture() const {
    if (copied_ != nullptr) glWaitSync(static_cast<GLsync>(copied_), 0, GL_TIMEOUT_IGNORED);
    return kept_;
}

}  // namespace deixis::app
