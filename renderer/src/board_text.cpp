#include "board_text.hpp"

#include <algorithm>
#include <cfloat>
#include <filesystem>

#include "core/files.hpp"

namespace deixis::renderer {
namespace {

constexpr std::size_t most_fonts = 24;  // after these the atlas starts afresh

Result<std::string> readFont(const char* path) {
    Result<std::string> bytes = readFile(path);
    if (bytes) return bytes;
    return fail(path, "the board's font cannot be read: " + bytes.error().message,
                "Install Open Sans (Debian: apt install fonts-open-sans), or configure again with "
                "-DDEIXIS_FONT_REGULAR=FILE -DDEIXIS_FONT_BOLD=FILE");
}

// The code points of UTF-8 text; a byte that is not UTF-8 counts as itself.
void addCharacters(std::string_view text, std::set<ImWchar>& characters) {
    ImFontGlyphRangesBuilder builder;
    builder.AddText(text.data(), text.data() + text.size());
    ImVector<ImWchar> ranges;
    builder.BuildRanges(&ranges);
    for (int i = 0; i + 1 < ranges.Size && ranges[i] != 0; i += 2)
        for (unsigned c = ranges[i]; c <= ranges[i + 1]; ++c) characters.insert(static_cast<ImWchar>(c));
}

}  // namespace

Result<BoardFonts> BoardFonts::load() {
    Result<std::string> regular = readFont(DEIXIS_FONT_REGULAR);
    if (!regular) return tl::unexpected(regular.error());
    Result<std::string> bold = readFont(DEIXIS_FONT_BOLD);
    if (!bold) return tl::unexpected(bold.error());
    BoardFonts fonts;
    fonts.regular_ = std::move(*regular);
    fonts.bold_ = std::move(*bold);
    for (ImWchar c = 0x20; c < 0x7F; ++c) fonts.characters_.insert(c);
    for (ImWchar c = 0xA0; c <= 0xFF; ++c) fonts.characters_.insert(c);
    return fonts;
}

bool BoardFonts::require(const std::set<FontKey>& keys, std::string_view characters) {
    std::set<ImWchar> wanted = characters_;
    addCharacters(characters, wanted);
    const bool have_fonts =
        std::all_of(keys.begin(), keys.end(), [&](const FontKey& key) { return fonts_.contains(key); });
    if (have_fonts && wanted.size() == characters_.size()) return false;

    characters_ = std::move(wanted);
    std::set<FontKey> all = keys;
    if (fonts_.size() + keys.size() <= most_fonts)
        for (const auto& [key, font] : fonts_) all.insert(key);
    ImFontGlyphRangesBuilder builder;
    for (const ImWchar c : characters_) builder.AddChar(c);
    ImVector<ImWchar> ranges;
    builder.BuildRanges(&ranges);
    atlas_->Clear();
    fonts_.clear();
    atlas_->Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight | ImFontAtlasFlags_NoMouseCursors;
    for (const FontKey& key : all) {
        ImFontConfig config;
        config.FontDataOwnedByAtlas = false;
        config.OversampleH = key.pixels < 40 ? 2 : 1;
        config.OversampleV = 1;
        std::string& file = key.bold ? bold_ : regular_;
        fonts_[key] = atlas_->AddFontFromMemoryTTF(file.data(), static_cast<int>(file.size()),
                                                   static_cast<float>(key.pixels), &config, ranges.Data);
    }
    atlas_->Build();
    return true;
}

std::vector<TextLine> wrapText(const ImFont& font, float pixels, std::string_view text, float width) {
    std::vector<TextLine> lines;
    const float scale = pixels / font.FontSize;
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    while (at < end) {
        const char* feed = std::find(at, end, '\n');
        do {
            const char* stop = width > 0.0F ? font.CalcWordWrapPositionA(scale, at, feed, width) : feed;
            if (stop == at && stop < feed) ++stop;  // a character wider than the box still takes its place
            lines.push_back({at, stop, font.CalcTextSizeA(pixels, FLT_MAX, 0.0F, at, stop).x});
            at = stop;
            while (at < feed && *at == ' ') ++at;
        } while (at < feed);
        at = feed + 1;
    }
    return lines;
}

}  // namespace deixis::renderer
