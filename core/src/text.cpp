#include "core/text.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace deixis {

namespace {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string lowerCase(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(), lower);
    return out;
}

std::string capitalised(std::string_view text) {
    std::string out(text);
    if (!out.empty() && out.front() >= 'a' && out.front() <= 'z')
        out.front() = static_cast<char>(out.front() - 'a' + 'A');
    return out;
}

bool sameLetters(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return lower(x) == lower(y); });
}

std::string_view withoutByteOrderMark(std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (text.starts_with(mark)) text.remove_prefix(mark.size());
    return text;
}

namespace {

/// How many bytes the character that begins the text takes; 0: none begins here. `text` is not empty.
std::size_t characterLength(std::string_view text) {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = at(0);
    if (first < 0x80U) return first == 0U ? 0 : 1;
    const std::size_t length = first >= 0xC2U && first < 0xE0U   ? 2
                               : first >= 0xE0U && first < 0xF0U ? 3
                               : first >= 0xF0U && first < 0xF5U ? 4
                                                                 : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if (!continuesCharacter(text[i])) return 0;
    // Longer than need be, a surrogate, or beyond the last character.
    if (first == 0xE0U && at(1) < 0xA0U) return 0;
    if (first == 0xEDU && at(1) >= 0xA0U) return 0;
    if (first == 0xF0U && at(1) < 0x90U) return 0;
    if (first == 0xF4U && at(1) >= 0x90U) return 0;
    return length;
}

/// Eight bytes of ASCII, none of them NUL: most of what is read.
bool plainEight(const char* text) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, text, sizeof eight);
    constexpr std::uint64_t ones = 0x0101010101010101ULL;
    constexpr std::uint64_t high = 0x8080808080808080ULL;
    return (eight & high) == 0 && ((eight - ones) & high) == 0;
}

}  // namespace

std::optional<std::pair<std::string, std::string>> nameAndValue(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0 || equals + 1 == text.size()) return std::nullopt;
    return std::pair(std::string(text.substr(0, equals)), std::string(text.substr(equals + 1)));
}

std::optional<std::size_t> firstUnstorable(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        if (text.size() - at >= 8 && plainEight(text.data() + at)) {
            at += 8;
            continue;
        }
        const std::size_t length = characterLength(text.substr(at));
        if (length == 0) return at;
        at += length;
    }
    return std::nullopt;
}

std::string storable(std::string_view text) {
    std::string out;
    while (const auto bad = firstUnstorable(text)) {
        out.append(text.substr(0, *bad)).append("\xEF\xBF\xBD");
        text.remove_prefix(*bad + 1);
    }
    return out.append(text);
}

void appendUtf8(std::string& text, char32_t character) {
    const auto c = static_cast<unsigned>(character);
    const auto add = [&](unsigned byte) { text += static_cast<char>(byte); };
    if (c < 0x80U) {
        add(c);
        return;
    }
    if (c < 0x800U) {
        add(0xC0U | (c >> 6U));
    } else if (c < 0x10000U) {
        add(0xE0U | (c >> 12U));
        add(0x80U | ((c >> 6U) & 0x3FU));
    } else {
        add(0xF0U | (c >> 18U));
        add(0x80U | ((c >> 12U) & 0x3FU));
        add(0x80U | ((c >> 6U) & 0x3FU));
    }
    add(0x80U | (c & 0x3FU));
}

char32_t nextCharacter(std::string_view text, std::size_t& at) {
    const std::size_t length = std::max<std::size_t>(1, characterLength(text.substr(at)));
    char32_t character = static_cast<unsigned char>(text[at++]);
    if (length > 1) character &= 0x7FU >> length;
    for (std::size_t i = 1; i < length; ++i)
        character = character << 6U | (static_cast<unsigned char>(text[at++]) & 0x3FU);
    return character;
}

}  // namespace deixis
