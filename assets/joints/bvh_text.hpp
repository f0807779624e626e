// The words and lines of a BVH file; private to its reader.
#pragma once

#include <string>
#include <string_view>

#include "core/error.hpp"
#include "core/text.hpp"
#include "number_lines.hpp"

namespace deixis::assets {

/// The word as errors show it: cut where it is long, "the end of the file" where it is empty.
[[nodiscard]] std::string quoted(std::string_view word);

/// A finite number that is the whole word, perhaps behind a plus; `where` and `what` are for the error.
[[nodiscard]] Result<double> wholeNumber(std::string_view word, const std::string& where, const char* what);

/// Words and lines of a text, with the number of the line.
class BvhText {
  public:
    explicit BvhText(std::string_view text) : text_(withoutByteOrderMark(text)) {}

    /// The next word, over line ends; empty at the end. Braces and the colon's right side stand for
    /// themselves.
    std::string_view word();
    /// The next word of this line; empty at its end.
    std::string_view wordOfLine();
    /// What is left of this line up to a brace, without blanks around it.
    std::string_view restOfLine();

    [[nodiscard]] int wordLine() const { return word_line_; }  ///< of the latest word()
    [[nodiscard]] int line() const { return line_; }
    [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }

  private:
    std::string_view wordHere();

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
    int word_line_ = 1;
};

}  // namespace deixis::assets
