// The fonts of the board, at the pixel sizes and with the characters that it needs.
#pragma once

#include <imgui.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace deixis::renderer {

struct FontKey {
    bool bold = false;
    int pixels = 0;  ///< height of a line
    friend auto operator<=>(const FontKey&, const FontKey&) = default;
};

class BoardFonts {
  public:
    /// Reads the font files; fails where one is missing.
    [[nodiscard]] static Result<BoardFonts> load();

    /// Makes the atlas hold these fonts with these characters (UTF-8); true where it was built anew, so that
    /// its texture must be made again.
    bool require(const std::set<FontKey>& keys, std::string_view characters);
    [[nodiscard]] ImFont* font(const FontKey& key) const { return fonts_.at(key); }
    [[nodiscard]] ImFontAtlas& atlas() { return *atlas_; }

  private:
    std::string regular_, bold_;  // the files' bytes
    std::unique_ptr<ImFontAtlas> atlas_ = std::make_unique<ImFontAtlas>();
    std::map<FontKey, ImFont*> fonts_;
    std::set<ImWchar> characters_;
};

/// One line of a wrapped text.
struct TextLine {
    const char* begin = nullptr;
    const char* end = nullptr;
    float width = 0.0F;
};

/// Breaks text at spaces and line feeds to lines no wider than `width` pixels (0: only at line feeds).
[[nodiscard]] std::vector<TextLine> wrapText(const ImFont& font, float pixels, std::string_view text,
                                             float width);

}  // namespace deixis::renderer
