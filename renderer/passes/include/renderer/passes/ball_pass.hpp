// Matte balls, drawn as instances of one sphere, and the rings around some of them.
#pragma once

#include <vector>

#include "renderer/gl/gl.hpp"
#include "renderer/scene/frame.hpp"
#include "renderer/scene/scene.hpp"

namespace deixis::renderer {

class BallPass {
  public:
    BallPass();
    /// Tells the block which balls cast shadows.
    static void placeShadows(const std::vector<Ball>& balls, FrameBlock& block);
    /// Tells draw() what to draw.
    void place(const std::vector<Ball>& balls);
    void draw(Views views);
    /// To be drawn over what stands in the room, blending on.
    void drawRings(Views views);

  private:
    struct Instance {
        glm::vec4 place;  // centre, radius
        glm::vec3 colour, glow;
    };
    struct Ringed {
        glm::vec4 place;
        int rings;
    };
    std::vector<Instance> placed_;
    std::vector<Ringed> ringed_;
    ViewProgram program_, ring_program_;
    gl::Buffer sphere_, indices_, instances_;
    GLsizeiptr instance_capacity_ = 0;
    GLsizei index_count_ = 0;
    gl::VertexArray vertices_, no_vertices_;
};

}  // namespace deixis::renderer
