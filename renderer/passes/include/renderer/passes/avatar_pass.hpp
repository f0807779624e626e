// The avatars: one mesh, skinned once per frame for each of them by a compute shader, then drawn into the
// shadow maps and into the picture.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "assets/avatar/avatar.hpp"
#include "renderer/gl/gl.hpp"
#include "renderer/scene/frame.hpp"

namespace deixis::renderer {

class AvatarPass {
  public:
    AvatarPass(const assets::Avatar& avatar, int shadow_resolution);

    /// Moves the vertices to these poses, and tells the block where the shadow maps lie and where the feet
    /// darken the floor. Throws std::invalid_argument if a number of joints is not the skeleton's, or
    /// there are too many avatars.
    void place(const std::vector<std::vector<Pose>>& avatars, FrameBlock& block);
    /// Draws the shadow maps; the block must be bound.
    void drawShadows() const;
    /// Finds how much of the key light reaches each vertex, after drawShadows().
    void light() const;
    void bindShadows() const;
    void draw(Views views);

  private:
    /// What is an avatar's own.
    struct Figure {
        gl::Buffer joints, skinned;
        gl::VertexArray vertices;
        gl::Framebuffer shadow_target;
    };
    void makeParts(const assets::Avatar& avatar);
    void makeFigure(int layer);
    void skin(const std::vector<Pose>& stage_from_joint, const Figure& figure);
    void placeShadow(const std::vector<Pose>& stage_from_joint, std::size_t avatar, FrameBlock& block) const;
    void drawPart(const assets::AvatarPart& part) const;
    void placeFeet(const std::vector<Pose>& stage_from_joint, std::size_t avatar, FrameBlock& block) const;

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
    std::optional<ViewProgram> textured_program_;  // where the avatar has parts that need it
    std::vector<assets::AvatarPart> parts_;
    std::vector<gl::Texture> textures_;  // the avatar's, then a white one
    gl::Buffer bind_vertices_, colours_, uvs_, indices_;
    gl::Texture shadow_maps_, shadow_depths_view_;
    std::array<Figure, max_avatars> figures_;
    std::size_t count_ = 0;  // of figures in this frame
};

}  // namespace deixis::renderer
