// The fonts of a board, at the pixel sizes and with the characters that it needs.
#pragma once

#include <imgui.h>

#include <array>
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
    /// Reads the font files; fails if one is missing.
    [[nodiscard]] static Result<BoardFonts> load();

    /// Makes the atlas hold these fonts with these characters (UTF-8); true if it was built again, so that
    /// its texture must be made again.
    bool require(const std::set<FontKey>& keys, std::string_view characters);
    [[nodiscard]] ImFont* font(const FontKey& key) const { return fonts_.at(key); }
    [[nodiscard]] ImFontAtlas& atlas() { return *atlas_; }
    /// Of all that was required: what no font has, UTF-8 in the order of the characters' numbers.
    [[nodiscard]] const std::string& missingCharacters() const { return missing_; }

  private:
    void build(const std::set<FontKey>& keys);
    void noteMissing();

    std::array<std::string, 2> files_, hangul_files_;  // bytes of the faces: regular, bold
    std::unique_ptr<ImFontAtlas> atlas_ = std::make_unique<ImFontAtlas>();
    std::map<FontKey, ImFont*> fonts_;
    std::set<ImWchar> characters_;
    std::string missing_;
};

/// One line of a wrapped text.
struct TextLine {
    const char* begin = nullptr;
    const char* end = nullptr;
    float width = 0.0F;
    bool cut = false;  ///< it ends within a word
};

/// Behind the character (UTF-8) that begins at `at`.
[[nodiscard]] const char* afterCharacter(const char* at, const char* end);
[[nodiscard]] float textWidth(const ImFont& font, float pixels, const char* begin, const char* end);

/// Breaks text at spaces and line feeds to lines no wider than `width` pixels (0: only at line feeds); a word
/// that is wider than a whole line is cut between characters.
[[nodiscard]] std::vector<TextLine> wrapText(const ImFont& font, float pixels, std::string_view text,
                                             float width);

}  // namespace deixis::renderer
