// Characters and texts, whatever the locale.
//
// Decoding is ours and not utf8proc's: boards and their layout run in the browser, too, where it is not. What
// utf8proc has beyond that finds no use: boards and panels measure their texts by the fonts themselves,
// scripts whose letters combine are refused, and texts are erased by characters, as keyboards send them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace deixis {

[[nodiscard]] constexpr bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

/// Without spaces, tabs and line ends around it.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// With small letters for A to Z; other letters stay.
[[nodiscard]] std::string lowerCase(std::string_view text);

/// With a capital letter to begin with, where one of a to z stands there.
[[nodiscard]] std::string capitalised(std::string_view text);

/// Alike but for small and capital letters from A to Z.
[[nodiscard]] bool sameLetters(std::string_view a, std::string_view b);

/// Without the byte order mark of UTF-8, where one stands first.
[[nodiscard]] std::string_view withoutByteOrderMark(std::string_view text);

/// "NAME=VALUE" at its first "=", neither part empty; else none.
[[nodiscard]] std::optional<std::pair<std::string, std::string>> nameAndValue(std::string_view text);

/// Where the first byte stands that cannot be kept everywhere: a NUL, or one that is no part of a character
/// of UTF-8 (RFC 3629). PostgreSQL takes neither. None: all of the text can be kept.
[[nodiscard]] std::optional<std::size_t> firstUnstorable(std::string_view text);
[[nodiscard]] inline bool storableText(std::string_view text) {
    return !firstUnstorable(text);
}

/// The text with U+FFFD for each such byte: for what a device or driver says, which nobody can mend.
[[nodiscard]] std::string storable(std::string_view text);

/// Adds a character (a scalar value of Unicode) in UTF-8.
void appendUtf8(std::string& text, char32_t character);

/// The character at `at`, a place within the text, which moves behind it. A byte that is no part of one
/// stands for itself.
[[nodiscard]] char32_t nextCharacter(std::string_view text, std::size_t& at);

/// Whether a byte of UTF-8 belongs to a character that began before it.
[[nodiscard]] constexpr bool continuesCharacter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

}  // namespace deixis
