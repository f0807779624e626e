// The passes of a scene: what all its views share is computed once, then each view, or both in one go, is
// drawn into the framebuffer that is bound.
#pragma once

#include <span>

#include "avatar_pass.hpp"
#include "ball_pass.hpp"
#include "beam_pass.hpp"
#include "board_pass.hpp"
#include "room_pass.hpp"

namespace deixis::renderer {

struct Quality;

enum class BoardLook : unsigned char {
    picture,
    hole,  ///< takes away colour and alpha where the board would be seen
};

class ScenePasses {
  public:
    ScenePasses(const assets::Avatar& avatar, const Quality& quality, BoardFonts fonts);

    /// Skins the avatar, draws the shadow map, paints the board, and tells the shaders of one or two views.
    /// Throws std::invalid_argument where Scene::avatar_joints does not fit the avatar.
    void prepare(const Scene& scene, std::span<const ViewBlock> views);
    /// Makes the shaders draw from another single view, with everything else as it is.
    void replaceView(const ViewBlock& view);
    /// What Views::one means from now on: 0 the first view that was given, 1 the second.
    void bindView(std::size_t index) const;
    void bindBothViews() const;
    /// Draws the prepared scene over a cleared framebuffer, sRGB conversion on. Leaves blending and depth
    /// test off.
    void draw(const Scene& scene, Views views, BoardLook board_look);

    [[nodiscard]] BoardPass& board() { return board_; }

  private:
    AvatarPass avatar_;
    RoomPass room_;
    BallPass balls_;
    BeamPass beam_;
    BoardPass board_;
    gl::Buffer frame_buffer_;
};

}  // namespace deixis::renderer
