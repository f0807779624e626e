// How wide a text on a board is, and where its lines break. Boards are laid out in a study, drawn by a
// station and simulated without either, and must be the same everywhere: the advance widths of the fonts that
// boards are drawn with (Open Sans, and Nanum Barun Gothic for what it lacks) stand in a table. A line that
// is laid out is drawn as it is.
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
