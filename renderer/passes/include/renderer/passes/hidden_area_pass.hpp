// The part of each eye's picture that is never visible: black and nearer than everything, so that nothing
// is drawn there.
#pragma once

#include "renderer/scene/stereo.hpp"
#include "renderer/scene/views.hpp"

namespace deixis::renderer {

class HiddenAreaPass {
  public:
    HiddenAreaPass();
    /// Throws std::invalid_argument if the indices are not triangles of the corners.
    void set(const std::array<HiddenArea, 2>& areas);
    void draw(Views views);

  private:
    ViewProgram program_;
    gl::VertexArray vertices_;
    gl::Buffer corners_, indices_;
    GLsizei index_count_ = 0;
};

}  // namespace deixis::renderer
