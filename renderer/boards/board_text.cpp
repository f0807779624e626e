#include "renderer/boards/board_text.hpp"

#include <algorithm>
#include <array>
#include <cfloat>

#include "core/files.hpp"
#include "core/text.hpp"
#include "renderer/boards/fonts.hpp"

namespace deixis::renderer {
namespace {

constexpr std::size_t max_fonts = 24;  // after these the atlas starts afresh
constexpr ImWchar first_beyond_latin = 0x100;

Result<std::string> readFont(const std::string& path, bool hangul) {
    Result<std::string> bytes = readFile(path);
    if (bytes) return bytes;
    return fail(path, "a font of the boards cannot be read: " + bytes.error().message,
                hangul ? "Install the Nanum fonts (Debian: apt install fonts-nanum), or configure again with "
                         "-DDEIXIS_FONT_HANGUL_REGULAR=FILE -DDEIXIS_FONT_HANGUL_BOLD=FILE"
                       : "Install Open Sans (Debian: apt install fonts-open-sans), or configure again with "
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

ImVector<ImWchar> rangesOf(const std::set<ImWchar>& characters, ImWchar from) {
    ImFontGlyphRangesBuilder builder;
    for (auto c = characters.lower_bound(from); c != characters.end(); ++c) builder.AddChar(*c);
    ImVector<ImWchar> ranges;
    builder.BuildRanges(&ranges);
    return ranges;
}

// Whether a line that ends here parts what belongs together: neither spaces nor punctuation stand there.
bool cutsWord(const char* begin, const char* stop, const char* end) {
    const auto within = [](char c) {
        return std::string_view(" \t\n.,;!?\"-").find(c) == std::string_view::npos;
    };
    return stop > begin && stop < end && within(*stop) && within(*(stop - 1));
}

}  // namespace

Result<BoardFonts> BoardFonts::load() {
    BoardFonts fonts;
    const std::array<std::string, 2> own{regularFontFile(), boldFontFile()};
    const std::array<std::string, 2> hangul{regularHangulFontFile(), boldHangulFontFile()};
    for (std::size_t bold = 0; bold < 2; ++bold) {
        Result<std::string> read = readFont(own[bold], false);
        if (!read) return tl::unexpected(read.error());
        fonts.files_[bold] = std::move(*read);
        read = readFont(hangul[bold], true);
        if (!read) return tl::unexpected(read.error());
        fonts.hangul_files_[bold] = std::move(*read);
    }
    for (ImWchar c = 0x20; c < 0x7F; ++c) fonts.characters_.insert(c);
    for (ImWchar c = 0xA0; c < first_beyond_latin; ++c) fonts.characters_.insert(c);
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
    if (fonts_.size() + keys.size() <= max_fonts)
        for (const auto& [key, font] : fonts_) all.insert(key);
    build(all);
    noteMissing();
    return true;
}

void BoardFonts::build(const std::set<FontKey>& keys) {
    const ImVector<ImWchar> ranges = rangesOf(characters_, 0);
    const ImVector<ImWchar> beyond = rangesOf(characters_, first_beyond_latin);
    atlas_->Clear();
    fonts_.clear();
    atlas_->Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight | ImFontAtlasFlags_NoMouseCursors;
    const auto add = [&](std::string& file, float pixels, const ImFontConfig& config,
                         const ImVector<ImWchar>& of) {
        return atlas_->AddFontFromMemoryTTF(file.data(), static_cast<int>(file.size()), pixels, &config,
                                            of.Data);
    };
    for (const FontKey& key : keys) {
        const std::size_t face = key.bold ? 1 : 0;
        ImFontConfig config;
        config.OversampleH = key.pixels < 40 ? 2 : 1;
        config.OversampleV = 1;
        fonts_[key] = add(files_[face], static_cast<float>(key.pixels), config, ranges);
        if (beyond.Size <= 1) continue;  // the end mark alone
        config.MergeMode = true;         // only what the first face lacks
        add(hangul_files_[face], hangul_size * static_cast<float>(key.pixels), config, beyond);
    }
    // The files' bytes are ours: told to the atlas only now, because it would copy what it does not own.
    for (ImFontConfig& config : atlas_->ConfigData) config.FontDataOwnedByAtlas = false;
    atlas_->Build();
}

void BoardFonts::noteMissing() {
    missing_.clear();
    if (fonts_.empty()) return;
    const ImFont& any = *fonts_.begin()->second;
    for (auto c = characters_.lower_bound(first_beyond_latin); c != characters_.end(); ++c)
        if (any.FindGlyphNoFallback(*c) == nullptr) appendUtf8(missing_, *c);
}

const char* afterCharacter(const char* at, const char* end) {
    ++at;
    while (at < end && continuesCharacter(*at)) ++at;
    return at;
}

float textWidth(const ImFont& font, float pixels, const char* begin, const char* end) {
    return font.CalcTextSizeA(pixels, FLT_MAX, 0.0F, begin, end).x;
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
            if (stop == at && stop < feed) stop = afterCharacter(at, feed);  // it is wider than the box
            lines.push_back({at, stop, textWidth(font, pixels, at, stop), cutsWord(at, stop, feed)});
            at = stop;
            while (at < feed && *at == ' ') ++at;
        } while (at < feed);
        at = feed + 1;
    }
    return lines;
}

}  // namespace deixis::renderer
