// The pointing beam: a ribbon that always faces the eye, with soft edges, and a dot at its end.
#pragma once

#include "renderer/gl/gl.hpp"
#include "renderer/scene/scene.hpp"
#include "renderer/scene/views.hpp"

namespace deixis::renderer {

class BeamPass {
  public:
    BeamPass();
    void draw(const Beam& beam, Views views);

  private:
    ViewProgram program_;
    gl::VertexArray no_vertices_;
};

}  // namespace deixis::renderer
