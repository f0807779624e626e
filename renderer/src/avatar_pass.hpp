// The avatar: skinned once a frame by a compute shader, then drawn into the shadow map and into the picture.
#pragma once

#include <vector>

#include "assets/avatar.hpp"
#include "frame.hpp"
#include "gl.hpp"

namespace deixis::renderer {

class AvatarPass {
  public:
    AvatarPass(const assets::Avatar& avatar, int shadow_resolution);

    /// Moves the vertices to this pose. Throws std::invalid_argument where the number of joints is not the
    /// skeleton's.
    void skin(const std::vector<Pose>& stage_from_joint);
    /// Tells the block where the shadow map lies around this pose.
    void placeShadow(const std::vector<Pose>& stage_from_joint, FrameBlock& block) const;
    /// Tells the block where the feet darken the floor.
    void placeFeet(const std::vector<Pose>& stage_from_joint, FrameBlock& block) const;
    /// Draws the shadow map; the block must be bound.
    void drawShadow() const;
    /// Finds how much of the key light reaches each vertex, after drawShadow().
    void light() const;
    void bindShadow() const;
    void draw(Views views);

  private:
    motion::HumanoidMap humanoid_;
    std::vector<Pose> joint_from_bind_;
    std::vector<double> joint_reach_m_;
    std::vector<float> joint_rows_;  // scratch: 3 rows of 4 a joint
    int vertex_count_ = 0;
    int index_count_ = 0;
    int caster_index_count_ = 0;  // these follow in the same buffer
    int shadow_resolution_ = 0;
    gl::Program skin_program_, light_program_, shadow_program_;
    ViewProgram draw_program_;
    gl::Buffer bind_vertices_, joints_, skinned_, colours_, indices_;
    gl::VertexArray vertices_;
    gl::Texture shadow_map_, shadow_depth_view_;
    gl::Framebuffer shadow_target_;
};

}  // namespace deixis::renderer
