// CSV as RFC 4180 has it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace deixis {

struct CsvRecord {
    int line = 1;  ///< on which it begins
    std::vector<std::string> fields;
};

/// Fields may be quoted, with "" for a quote; lines end in LF or CRLF, empty ones and a UTF-8 mark at the
/// start are passed over. `name` stands for the file in errors.
[[nodiscard]] Result<std::vector<CsvRecord>> parseCsv(std::string_view text, const std::string& name);

/// The field, quoted where it must be.
[[nodiscard]] std::string csvField(std::string_view text);

}  // namespace deixis
