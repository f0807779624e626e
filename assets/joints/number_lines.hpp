// Tables of numbers as text: a field after the other, a line after the other.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>
#include "core/text.hpp"

namespace deixis::assets {

[[nodiscard]] inline bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

/// Lines of a text without their ends and blanks around them; empty ones are skipped.
class TextLines {
  public:
    explicit TextLines(std::string_view text) : text_(withoutByteOrderMark(text)) {}
    /// The next line that is not empty; none at the end.
    [[nodiscard]] std::optional<std::string_view> next();
    [[nodiscard]] int line() const { return line_; }  ///< number of the latest
    [[nodiscard]] std::size_t charactersLeft() const { return text_.size(); }

  private:
    std::string_view text_;
    int line_ = 0;
};

/// Fields between `separator`, blanks around them dropped; ' ' separates by any number of blanks and tabs.
void splitFields(std::string_view line, char separator, std::vector<std::string_view>& fields);

/// The field as a finite number; none where it is anything else.
[[nodiscard]] std::optional<double> finiteNumber(std::string_view field);

/// What may help where a field is no number: a word on decimal commas where it has one, else empty.
[[nodiscard]] std::string hintOfNumber(std::string_view field);

/// What separates the fields of a line: a tab, a semicolon, a comma, or else blanks.
[[nodiscard]] char separatorOf(std::string_view line);

}  // namespace deixis::assets
