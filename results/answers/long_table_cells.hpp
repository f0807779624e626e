// What a cell of a long table can say; private to its reader.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/text.hpp"

namespace deixis::results {

/// Trimmed and in small letters: a cell's text as words are looked for in it.
[[nodiscard]] inline std::string plainWord(std::string_view text) {
    return lowerCase(trimmed(text));
}

// The cells of these are lowered.
[[nodiscard]] bool isMissing(const std::string& cell);
[[nodiscard]] std::optional<bool> truthOf(const std::string& cell);
[[nodiscard]] std::optional<double> numberOf(const std::string& cell);  ///< finite

/// Of a cell as it stands; without value where it is missing or no number.
struct NumberCell {
    bool missing = false;
    std::optional<double> value{};
    bool with_comma = false;  ///< for the decimal point
};
[[nodiscard]] NumberCell numberCell(const std::string& cell);

/// Likewise.
struct TruthCell {
    bool missing = false;
    std::optional<bool> value{};
};
[[nodiscard]] TruthCell truthCell(const std::string& cell);

enum class Attention : unsigned char { none, check, passed, failed };
[[nodiscard]] std::optional<Attention> attentionOf(const std::string& cell);

/// A flag with its reason, not lowered: empty where it is not set, `word` where it is set without a reason.
[[nodiscard]] std::string reasonOf(const std::string& cell, const char* word);

/// A name as it stands in a cell: trimmed, without a spreadsheet's guard.
[[nodiscard]] std::string nameIn(const std::string& cell);

}  // namespace deixis::results
