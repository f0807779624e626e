// The passes of a scene: what all its views share is computed once, then each view, or both in one go, is
// drawn into the framebuffer that is bound.
#pragma once

#include <span>

#include "renderer/boards/board_pass.hpp"
#include "renderer/passes/avatar_pass.hpp"
#include "renderer/passes/ball_pass.hpp"
#include "renderer/passes/beam_pass.hpp"
#include "renderer/passes/head_pass.hpp"
#include "renderer/passes/room_pass.hpp"
#include "renderer/passes/trail_pass.hpp"

namespace deixis::renderer {

struct Quality;

/// How the first of the scene's boards is drawn.
enum class BoardLook : unsigned char {
    picture,
    hole,  ///< takes away colour and alpha where the board would be seen
};

class ScenePasses {
  public:
    ScenePasses(const assets::Avatar& avatar, const Quality& quality, BoardFonts fonts);

    /// Skins the avatars, draws the shadow maps, paints the boards, and tells the shaders of one or two
    /// views. Throws std::invalid_argument where Scene::avatars do not fit the avatar, or are too many.
    void prepare(const Scene& scene, std::span<const ViewBlock> views);
    /// Makes the shaders draw from another single view, with everything else as it is.
    void replaceView(const ViewBlock& view);
    /// What Views::one means from now on: 0 the first view that was given, 1 the second.
    void bindView(std::size_t index) const;
    void bindBothViews() const;
    /// Draws the prepared scene over a cleared framebuffer, sRGB conversion on. Leaves blending and depth
    /// test off.
    void draw(const Scene& scene, Views views, BoardLook first_board);

    [[nodiscard]] BoardPass& boards() { return boards_; }

  private:
    AvatarPass avatar_;
    RoomPass room_;
    BallPass balls_;
    HeadPass heads_;
    BeamPass beam_;
    TrailPass trails_;
    BoardPass boards_;
    gl::Buffer frame_buffer_;
};

}  // namespace deixis::renderer
