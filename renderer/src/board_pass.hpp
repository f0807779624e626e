// The board: painted into a texture when its content changes, drawn as a card in the world.
#pragma once

#include <imgui.h>

#include <memory>
#include <optional>

#include "board_text.hpp"
#include "gl.hpp"
#include "renderer/scene.hpp"

namespace deixis::renderer {

class BoardPass {
  public:
    BoardPass(BoardFonts fonts, double pixels_per_metre);

    /// Paints the board where its content is not what was painted last.
    void paint(const Board& board);
    void draw(const Board& board) const;
    [[nodiscard]] int paints() const { return paints_; }

  private:
    struct ContextDeleter {
        void operator()(ImGuiContext* context) const;
    };
    void makeTexture(const Board& board);
    void uploadFonts();
    void drawLists(const ImDrawData& data);

    BoardFonts fonts_;
    double wanted_pixels_per_metre_;
    double pixels_per_metre_ = 0.0;
    std::unique_ptr<ImGuiContext, ContextDeleter> context_;
    std::optional<Board> painted_;
    int paints_ = 0;
    int width_ = 0;
    int height_ = 0;
    gl::Program text_program_, card_program_;
    gl::VertexArray text_vertices_, no_vertices_;
    gl::Texture font_texture_, card_;
    gl::Framebuffer card_target_;
};

}  // namespace deixis::renderer
