#include "characters.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace deixis::speech {

namespace {

struct Script {
    char32_t first;
    char32_t last;
    const char* name;
};

/// Letters by the blocks of Unicode 15, in their order.
constexpr Script scripts[]{
    {0x0180, 0x02AF, "Latin letters beyond Europe's"},
    {0x0370, 0x03FF, "Greek"},
    {0x0400, 0x052F, "Cyrillic"},
    {0x0530, 0x058F, "Armenian"},
    {0x0590, 0x05FF, "Hebrew"},
    {0x0600, 0x06FF, "Arabic"},
    {0x0700, 0x074F, "Syriac"},
    {0x0750, 0x077F, "Arabic"},
    {0x0780, 0x07BF, "Thaana"},
    {0x07C0, 0x08FF, "an African or Semitic script"},
    {0x0900, 0x097F, "Devanagari"},
    {0x0980, 0x09FF, "Bengali"},
    {0x0A00, 0x0DFF, "a script of India"},
    {0x0E00, 0x0E7F, "Thai"},
    {0x0E80, 0x0EFF, "Lao"},
    {0x0F00, 0x0FFF, "Tibetan"},
    {0x1000, 0x109F, "Burmese"},
    {0x10A0, 0x10FF, "Georgian"},
    {0x1100, 0x11FF, "Korean"},
    {0x1200, 0x139F, "Ethiopic"},
    {0x13A0, 0x177F, "a script other than Latin"},
    {0x1780, 0x17FF, "Khmer"},
    {0x1800, 0x18AF, "Mongolian"},
    {0x18B0, 0x1CFF, "a script other than Latin"},
    {0x1D00, 0x1DBF, "phonetic letters"},
    {0x1E00, 0x1EFF, "Latin letters beyond Europe's"},
    {0x1F00, 0x1FFF, "Greek"},
    {0x2C00, 0x2DFF, "a script other than Latin"},
    {0x2E80, 0x2FDF, "Chinese"},
    {0x3040, 0x30FF, "Japanese"},
    {0x3100, 0x312F, "Chinese"},
    {0x3130, 0x318F, "Korean"},
    {0x31A0, 0x31BF, "Chinese"},
    {0x31F0, 0x31FF, "Japanese"},
    {0x3400, 0x4DBF, "Chinese"},
    {0x4E00, 0x9FFF, "Chinese"},
    {0xA000, 0xA95F, "a script other than Latin"},
    {0xA960, 0xA97F, "Korean"},
    {0xA980, 0xABFF, "a script other than Latin"},
    {0xAC00, 0xD7FF, "Korean"},
    {0xF900, 0xFAFF, "Chinese"},
    {0xFB1D, 0xFB4F, "Hebrew"},
    {0xFB50, 0xFDFF, "Arabic"},
    {0xFE70, 0xFEFE, "Arabic"},
    {0xFF00, 0xFFEF, "wide letters"},
    {0x10000, 0x1CFFF, "a script other than Latin"},
    {0x1E000, 0x1EFFF, "a script other than Latin"},
    {0x20000, 0x3FFFF, "Chinese"},
};

/// U+00C0 to U+017F in ASCII, separated by spaces; "*" is no letter.
constexpr std::string_view latin =
    "A A A A A A AE C E E E E I I I I D N O O O O O * O U U U U Y Th ss a a a a a a ae c e e e e i i i i d n "
    "o o o "
    "o o * o u u u u y th y A a A a A a C c C c C c C c D d D d E e E e E e E e E e G g G g G g G g H h H h "
    "I i I i "
    "I i I i I i IJ ij J j K k k L l L l L l L l L l N n N n N n n N n O o O o O o OE oe R r R r R r S s S s "
    "S s S "
    "s T t T t T t U u U u U u U u U u U u W w Y y Y Z z Z z Z z s";

const std::array<std::string_view, 0x180 - 0xC0>& latinLetters() {
    static const auto letters = [] {
        std::array<std::string_view, 0x180 - 0xC0> out;
        std::size_t at = 0;
        for (std::string_view& letter : out) {
            const std::size_t end = std::min(latin.find(' ', at), latin.size());
            letter = latin.substr(at, end - at);
            at = end + 1;
        }
        return out;
    }();
    return letters;
}

struct Symbol {
    char32_t character;
    CharacterKind kind;
    const char* ascii;
};

constexpr Symbol symbols[]{
    {0x00A0, CharacterKind::blank, ""},       {0x00A3, CharacterKind::word, "pound"},
    {0x00AB, CharacterKind::mark, "\""},      {0x00B0, CharacterKind::word, "degrees"},
    {0x00B5, CharacterKind::word, "micro"},   {0x00BB, CharacterKind::mark, "\""},
    {0x00BC, CharacterKind::word, "quarter"}, {0x00BD, CharacterKind::word, "half"},
    {0x00D7, CharacterKind::word, "times"},   {0x2010, CharacterKind::word, "-"},
    {0x2011, CharacterKind::word, "-"},       {0x2012, CharacterKind::word, "-"},
    {0x2013, CharacterKind::dash, ""},        {0x2014, CharacterKind::dash, ""},
    {0x2015, CharacterKind::dash, ""},        {0x2018, CharacterKind::mark, "'"},
    {0x2019, CharacterKind::mark, "'"},       {0x201A, CharacterKind::mark, "'"},
    {0x201C, CharacterKind::mark, "\""},      {0x201D, CharacterKind::mark, "\""},
    {0x201E, CharacterKind::mark, "\""},      {0x2026, CharacterKind::mark, "..."},
    {0x2028, CharacterKind::blank, ""},       {0x2029, CharacterKind::blank, ""},
    {0x202F, CharacterKind::blank, ""},       {0x2039, CharacterKind::mark, "'"},
    {0x203A, CharacterKind::mark, "'"},       {0x205F, CharacterKind::blank, ""},
    {0x20AC, CharacterKind::word, "euro"},    {0x2212, CharacterKind::word, "-"},
    {0x3000, CharacterKind::blank, ""},
};

}  // namespace

CharacterUse useOf(char32_t character) {
    if (character < 0x80) {
        const char c = static_cast<char>(character);
        if (c == ' ' || c == '\t' || c == '\n' || c == '\r') return {CharacterKind::blank};
        if (c < ' ') return {};
        constexpr std::string_view marks = "\"'`.,:;!?(){}[]<>-_/\\|~^*";
        return {marks.find(c) == std::string_view::npos ? CharacterKind::word : CharacterKind::mark, {c}};
    }
    const auto symbol = std::lower_bound(std::begin(symbols), std::end(symbols), character,
                                         [](const Symbol& s, char32_t c) { return s.character < c; });
    if (symbol != std::end(symbols) && symbol->character == character) return {symbol->kind, symbol->ascii};
    if (character >= 0x2000 && character <= 0x200A) return {CharacterKind::blank};
    if (character >= 0xC0 && character < 0x180) {
        const std::string_view letter = latinLetters()[character - 0xC0];
        if (letter == "*") return {};
        return {CharacterKind::word, std::string(letter)};
    }
    if (character >= 0x300 && character < 0x370)
        return {CharacterKind::word};  // marks over the letter before
    const auto* const script = std::upper_bound(std::begin(scripts), std::end(scripts), character,
                                                [](char32_t c, const Script& s) { return c < s.first; });
    if (script != std::begin(scripts) && character <= std::prev(script)->last)
        return {CharacterKind::foreign, {}, std::prev(script)->name};
    return {};  // emoji, arrows
}

}  // namespace deixis::speech
