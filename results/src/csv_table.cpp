#include "csv_table.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "core/csv.hpp"

namespace deixis::results {

std::string safeText(std::string_view text) {
    constexpr std::string_view formula_starts = "=+-@\t\r";
    if (!text.empty() && formula_starts.find(text.front()) != std::string_view::npos)
        return "'" + std::string(text);
    return std::string(text);
}

CsvTable::CsvTable(std::vector<ColumnSpec> columns) : columns_(std::move(columns)) {
    for (std::size_t i = 0; i < columns_.size(); ++i) bytes_ += (i > 0 ? "," : "") + columns_[i].name;
    bytes_ += "\r\n";
}

void CsvTable::separate() {
    if (cells_++ > 0) bytes_ += ',';
}

void CsvTable::text(std::string_view value) {
    separate();
    bytes_ += csvField(safeText(value));
}

void CsvTable::number(double value) {
    separate();
    fmt::format_to(std::back_inserter(bytes_), "{}", value);
}

void CsvTable::whole(long long value) {
    separate();
    fmt::format_to(std::back_inserter(bytes_), "{}", value);
}

void CsvTable::empty() {
    separate();
}

void CsvTable::cell(const SQLite::Column& value) {
    if (value.isNull())
        empty();
    else if (value.isInteger())
        whole(value.getInt64());
    else if (value.isFloat())
        number(value.getDouble());
    else
        text(value.getString());
}

void CsvTable::endRow() {
    if (cells_ != columns_.size())
        throw std::logic_error(
            fmt::format("a row of {} cells in a table of {} columns", cells_, columns_.size()));
    bytes_ += "\r\n";
    cells_ = 0;
    ++rows_;
}

}  // namespace deixis::results
