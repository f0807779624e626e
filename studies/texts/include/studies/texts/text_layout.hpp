// How wide a text on a board is, and where its lines break. Boards are laid out in a study, drawn by a
// station and simulated without either, and must be the same everywhere: a table has the advance widths of
// the boards' fonts (Open Sans, and Nanum Barun Gothic for characters that it lacks). Lines are drawn
// exactly as they are laid out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace deixis::studies {

/// On one line of this height.
[[nodiscard]] double textWidth(std::string_view text, double size_m, bool bold = false);

/// The lines of a text, at least one a paragraph, none wider than the width: broken at spaces, and a word
/// that is wider than a line between any two characters.
[[nodiscard]] std::vector<std::string> wrapText(std::string_view text, double size_m, double width_m,
                                                bool bold = false);

/// Of its longest word.
[[nodiscard]] double widestWord(std::string_view text, double size_m, bool bold = false);

}  // namespace deixis::studies
