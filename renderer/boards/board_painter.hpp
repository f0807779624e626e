// What the board looks like: its card, texts, buttons and progress bar as a list of shapes.
#pragma once

#include <imgui.h>

#include <set>
#include <string>

#include "renderer/boards/board_text.hpp"
#include "renderer/scene/scene.hpp"

namespace deixis::renderer {

/// Pixels left free around the card in its texture, so that its edge is filtered.
constexpr int card_margin_px = 4;

/// The fonts that a board needs, its texts shrunk to fit their boxes, and all its characters. Measures with
/// the fonts at their full sizes, which it requires of `fonts` first (true where the atlas was built again).
bool requireBoardFonts(const Board& board, double pixels_per_metre, BoardFonts& fonts);

/// Adds the board's shapes; requireBoardFonts must have been called with the same board.
void paintBoard(const Board& board, double pixels_per_metre, const BoardFonts& fonts, ImDrawList& list);

}  // namespace deixis::renderer
