// Trails of movements: ribbons that face the eye, fading towards their start.
#pragma once

#include <vector>

#include "renderer/gl/gl.hpp"
#include "renderer/scene/scene.hpp"
#include "renderer/scene/views.hpp"

namespace deixis::renderer {

class TrailPass {
  public:
    TrailPass();
    /// Tells draw() what to draw.
    void place(const std::vector<Trail>& trails);
    void draw(Views views);

  private:
    struct Vertex {
        glm::vec3 position, along;
        float side;   // -1 or 1
        float alpha;  // 0 at the trail's start, 1 at its end
    };
    struct Strip {
        int first = 0;
        int count = 0;
        glm::vec3 colour{0.0F};
    };
    std::vector<Vertex> placed_;
    std::vector<Strip> strips_;
    ViewProgram program_;
    gl::VertexArray vertices_;
    gl::Buffer points_;
    GLsizeiptr capacity_ = 0;
};

}  // namespace deixis::renderer
