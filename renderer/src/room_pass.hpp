// The room: floor, walls and ceiling, their patterns computed in the shaders.
#pragma once

#include "gl.hpp"

namespace deixis::renderer {

class RoomPass {
  public:
    RoomPass();
    void draw() const;

  private:
    gl::Program floor_program_, wall_program_;
    gl::Buffer corners_;
    gl::VertexArray vertices_;
};

}  // namespace deixis::renderer
