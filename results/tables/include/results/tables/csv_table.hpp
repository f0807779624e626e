// A table as CSV with the description of its columns, for exports.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace deixis::results {

enum class ColumnType : unsigned char { text, number, whole, truth };

struct ColumnSpec {
    std::string name;
    ColumnType type = ColumnType::text;
    std::string description;
    std::string unit{};  ///< as in the name's ending: m, s, deg; empty: none
};

/// As few digits as bring the same number back, behind what stands in `out`.
void appendNumber(std::string& out, double value);

/// Rows are built cell by cell, in the order of the columns, whose names are made safe and quoted likewise.
class CsvTable {
  public:
    explicit CsvTable(std::vector<ColumnSpec> columns);

    void text(std::string_view value);  ///< made safe (safeText()) and quoted where needed
    void number(double value);          ///< as few digits as bring the same number back
    void whole(long long value);
    void empty();
    /// NULL is empty.
    void cell(const SQLite::Column& value);
    /// Throws std::logic_error if the row has not as many cells as there are columns.
    void endRow();

    [[nodiscard]] const std::vector<ColumnSpec>& columns() const { return columns_; }
    [[nodiscard]] long long rows() const { return rows_; }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }  ///< header and rows, CRLF
    /// What has been built so far, which the table lets go of: for tables too large to be held.
    [[nodiscard]] std::string take() { return std::exchange(bytes_, {}); }

  private:
    void separate();

    std::vector<ColumnSpec> columns_;
    std::string bytes_;
    std::size_t cells_ = 0;
    long long rows_ = 0;
};

}  // namespace deixis::results
