// The boards: each painted into a texture when its content changes, drawn as a card in the world.
#pragma once

#include <imgui.h>

#include <array>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "renderer/boards/board_text.hpp"
#include "renderer/gl/gl.hpp"
#include "renderer/scene/scene.hpp"
#include "renderer/scene/views.hpp"

namespace deixis::renderer {

/// Of a rectangle on the board, metres from its lower left corner.
struct BoardCorners {
    glm::dvec2 low{0.0}, high{0.0};
};

class BoardPass {
  public:
    BoardPass(BoardFonts fonts, double pixels_per_metre);

    /// Paints those of the boards whose content is not painted already. They can be drawn and copied until
    /// the next call.
    void paint(std::span<const Board> boards);
    /// A painted board in the world.
    void draw(const Board& board, Views views);
    /// A painted board's picture, its first row the board's foot.
    void copyTo(const Board& board, GLuint texture) const;
    /// The size in pixels of the board's picture, and where it lies on the board.
    [[nodiscard]] std::array<int, 2> size(const Board& board) const;
    [[nodiscard]] BoardCorners corners(const Board& board) const;
    [[nodiscard]] int paints() const { return paints_; }
    [[nodiscard]] const std::string& missingCharacters() const { return fonts_.missingCharacters(); }

  private:
    struct ContextDeleter {
        void operator()(ImGuiContext* context) const;
    };
    struct Resolution {
        double pixels_per_metre = 0.0;
        int width = 0;
        int height = 0;
    };
    /// A board's picture.
    struct Card {
        Board content;
        Resolution at;
        gl::Texture picture;
        gl::Framebuffer target;
        unsigned last_paint = 0;  // the number of the call of paint() that asked for it last
    };
    [[nodiscard]] Resolution resolution(const Board& board) const;
    [[nodiscard]] std::size_t find(const Board& board) const;  // number of cards if there is none
    [[nodiscard]] const Card& painted(const Board& board) const;
    Card& freeCard(const Resolution& wanted);
    void paint(const Board& board, Card& card);
    void makeTexture(const Resolution& wanted, Card& card);
    void uploadFonts();
    void drawLists(const ImDrawData& data, const Card& card);

    BoardFonts fonts_;
    double wanted_pixels_per_metre_;
    std::unique_ptr<ImGuiContext, ContextDeleter> context_;
    std::vector<Card> cards_;
    unsigned calls_ = 0;  // of paint()
    int paints_ = 0;
    gl::Program text_program_;
    ViewProgram card_program_;
    gl::VertexArray text_vertices_, no_vertices_;
    gl::Texture font_texture_;
    gl::Framebuffer copy_target_;
};

}  // namespace deixis::renderer
