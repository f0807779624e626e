// The room: floor, walls and ceiling, their patterns computed in the shaders.
#pragma once

#include "renderer/gl/gl.hpp"
#include "renderer/scene/views.hpp"

namespace deixis::renderer {

class RoomPass {
  public:
    RoomPass();
    void draw(Views views);

  private:
    ViewProgram floor_program_, wall_program_;
    gl::Buffer corners_;
    gl::VertexArray vertices_;
};

}  // namespace deixis::renderer
