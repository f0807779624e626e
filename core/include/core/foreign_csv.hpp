// CSV as written by spreadsheets and experiment programs.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/csv.hpp"

namespace deixis {

struct ForeignCsv {
    std::string text;  ///< UTF-8
    CsvForm form{};    ///< with comments
    /// The first of its letters that are not ASCII, where it was read as Windows-1252; else empty.
    std::string taken_for_windows_1252{};
};

/// Recognises UTF-16 by its mark, and the separator (comma, semicolon or tab) by the first line that is no
/// comment. Text that is not UTF-8 is read as Windows-1252, as Excel and Latin-1 have it, and lines may end
/// in CR alone. Fails, naming the line, where it is not text in any of these. `name` stands for the file.
[[nodiscard]] Result<ForeignCsv> readForeignCsv(std::string bytes, const std::string& name);

/// A number whose comma stands for a decimal point ("-3,5") with the point; none of anything else.
[[nodiscard]] std::optional<std::string> decimalCommaAsPoint(std::string_view number);

}  // namespace deixis
