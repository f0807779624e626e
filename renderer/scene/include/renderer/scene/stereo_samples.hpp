// The multisampled pictures that both eyes are drawn into: one after the other into one layer, or together
// into two.
#pragma once

#include "renderer/gl/gl.hpp"
#include "renderer/scene/stereo.hpp"
#include "renderer/scene/views.hpp"

namespace deixis::renderer {

class StereoSamples {
  public:
    /// `samples` is lowered to what the driver has.
    explicit StereoSamples(int samples);

    /// Whether the driver draws into both layers in one pass, with these samples.
    [[nodiscard]] bool hasMultiview() const { return has_multiview_; }
    /// Makes the framebuffer current and clears it. With Views::both it takes multiview.
    void begin(int width, int height, Views views);
    /// Averages the samples, in linear light, into `eye`'s layer of the target, and takes one of the depths
    /// of each pixel. With Views::one the samples are those of the eye that was drawn last.
    void resolve(const StereoTarget& target, int eye);
    /// The same into another framebuffer of this size, colour only: the left eye's, where both were drawn or
    /// it was drawn last.
    void resolveLeft(GLuint framebuffer);
    /// Of what was drawn last; 0 before.
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }

  private:
    void make(int width, int height, Views views);
    [[nodiscard]] bool multiviewIsComplete();
    void readLayer(int eye);

    int samples_;
    bool has_multiview_ = false;
    int width_ = 0;
    int height_ = 0;
    Views views_ = Views::one;
    gl::Texture colour_, depth_;
    gl::Framebuffer drawn_;
    gl::Framebuffer read_;  // of one layer: a framebuffer of several views cannot be read
    gl::Framebuffer resolved_;
};

}  // namespace deixis::renderer
