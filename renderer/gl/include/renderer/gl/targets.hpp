// The picture being drawn: a multisampled sRGB framebuffer and the resolved picture.
#pragma once

#include "renderer/gl/gl.hpp"

namespace deixis::renderer {

class Targets {
  public:
    /// `samples` is lowered to what the driver has.
    explicit Targets(int samples);

    /// Makes the framebuffer of this size current and clears it; linear colours written are stored as sRGB.
    void begin(int width, int height);
    /// Averages the samples, in linear light.
    void resolve();
    /// Copies the resolved picture's bytes to another framebuffer of the same size, as they are.
    void copyTo(GLuint framebuffer) const;
    /// The resolved picture: 3 bytes a pixel, rows from the bottom.
    void read(void* rgb) const;

  private:
    int samples_;
    int width_ = 0;
    int height_ = 0;
    gl::Renderbuffer colour_, depth_, resolved_colour_;
    gl::Framebuffer drawn_, resolved_;
};

}  // namespace deixis::renderer
