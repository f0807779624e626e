// A CSV file whose first record names its columns.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/csv.hpp"

namespace deixis {

struct CsvSheet {
    std::string name;             ///< of the file, for errors
    CsvRecord header;             ///< without blanks around names; no fields where the text holds no record
    std::vector<CsvRecord> rows;  ///< each has as many fields as the header

    [[nodiscard]] std::optional<std::size_t> find(std::string_view column) const;
    /// Where the column stands; an error that names the header's line where it does not, or stands twice.
    [[nodiscard]] Result<std::size_t> column(std::string_view column, std::string hint = {}) const;
    /// An error where the row has more fields than the header, or fewer.
    [[nodiscard]] Result<void> checkWidth(const CsvRecord& row) const;
    /// "FILE:LINE"
    [[nodiscard]] std::string place(const CsvRecord& row) const;
    /// "FILE:LINE: COLUMN"
    [[nodiscard]] std::string place(const CsvRecord& row, std::size_t column) const;
    /// finiteNumber() of a cell, of at most `max` to either side.
    [[nodiscard]] Result<double> number(const CsvRecord& row, std::size_t column,
                                        std::string_view expected = "a finite number",
                                        double max = 1e308) const;
};

[[nodiscard]] Result<CsvSheet> parseCsvSheet(std::string_view text, const std::string& name,
                                             CsvForm form = {});

/// The header alone: for tables whose rows are read one by one from the same reader, since there may be many
/// or each is to be told what is wrong with it.
[[nodiscard]] Result<CsvSheet> readCsvHeader(CsvReader& reader, const std::string& name);

}  // namespace deixis
