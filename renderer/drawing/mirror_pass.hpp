// What the left eye saw, for a window: its picture cut to the window's shape, the first board put into its
// hole.
#pragma once

#include "renderer/scene/stereo_samples.hpp"
#include "scene_passes.hpp"

namespace deixis::renderer {

class MirrorPass {
  public:
    MirrorPass();
    /// Draws into `framebuffer` of this size; black where `samples` hold nothing yet.
    void draw(StereoSamples& samples, ScenePasses& passes, const Scene& scene, const Eye& left, int width,
              int height, GLuint framebuffer);

  private:
    void makeEyePicture(int width, int height);
    void makeMirror(int width, int height);

    gl::Program program_;
    gl::VertexArray no_vertices_;
    int eye_width_ = 0;
    int eye_height_ = 0;
    int width_ = 0;
    int height_ = 0;
    gl::Texture eye_;
    gl::Renderbuffer mirror_;
    gl::Framebuffer eye_target_, mirror_target_;
};

}  // namespace deixis::renderer
