// Heads of participants seen from outside: a plain head that wears a headset.
#pragma once

#include <vector>

#include "renderer/gl/gl.hpp"
#include "renderer/scene/frame.hpp"
#include "renderer/scene/scene.hpp"

namespace deixis::renderer {

class HeadPass {
  public:
    HeadPass();
    void draw(const std::vector<HeadMarker>& heads, Views views);

  private:
    ViewProgram program_;
    gl::Buffer corners_, indices_;
    GLsizei index_count_ = 0;
    gl::VertexArray vertices_;
};

}  // namespace deixis::renderer
