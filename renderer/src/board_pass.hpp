// The board: painted into a texture when its content changes, drawn as a card in the world.
#pragma once

#include <imgui.h>

#include <array>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>

#include "board_text.hpp"
#include "gl.hpp"
#include "renderer/scene.hpp"
#include "views.hpp"

namespace deixis::renderer {

/// Of a rectangle on the board, metres from its lower left corner.
struct BoardCorners {
    glm::dvec2 low{0.0}, high{0.0};
};

class BoardPass {
  public:
    BoardPass(BoardFonts fonts, double pixels_per_metre);

    /// Paints the board where its content is not what was painted last.
    void paint(const Board& board);
    /// What was painted last, in the world.
    void draw(const Board& board, Views views);
    /// What was painted last, its first row the board's foot.
    void copyTo(GLuint texture) const;
    /// The size in pixels of the board's picture, and where it lies on the board.
    [[nodiscard]] std::array<int, 2> size(const Board& board) const;
    [[nodiscard]] BoardCorners corners(const Board& board) const;
    [[nodiscard]] int paints() const { return paints_; }

  private:
    struct ContextDeleter {
        void operator()(ImGuiContext* context) const;
    };
    struct Resolution {
        double pixels_per_metre = 0.0;
        int width = 0;
        int height = 0;
    };
    [[nodiscard]] Resolution resolution(const Board& board) const;
    void makeTexture(const Board& board);
    void uploadFonts();
    void drawLists(const ImDrawData& data);

    BoardFonts fonts_;
    double wanted_pixels_per_metre_;
    std::unique_ptr<ImGuiContext, ContextDeleter> context_;
    std::optional<Board> painted_;
    int paints_ = 0;
    Resolution painted_at_;
    gl::Program text_program_;
    ViewProgram card_program_;
    gl::VertexArray text_vertices_, no_vertices_;
    gl::Texture font_texture_, card_;
    gl::Framebuffer card_target_, copy_target_;
};

}  // namespace deixis::renderer
