#include "results/tables/csv_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/csv.hpp"

namespace deixis::results {

void appendNumber(std::string& out, double value) {
    constexpr double exact = 1e15;
    if (value == std::floor(value) && std::abs(value) < exact && !std::signbit(value)) {
        const fmt::format_int digits(static_cast<long long>(value));  // the same digits, sooner
        out.append(digits.data(), digits.size());
    } else {
        fmt::format_to(std::back_inserter(out), "{}", value);
    }
}

CsvTable::CsvTable(std::vector<ColumnSpec> columns) : columns_(std::move(columns)) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        if (i > 0) bytes_ += ',';
        appendSafeCsvField(bytes_, columns_[i].name);
    }
    bytes_ += "\r\n";
}

void CsvTable::separate() {
    if (cells_++ > 0) bytes_ += ',';
}

void CsvTable::text(std::string_view value) {
    separate();
    appendSafeCsvField(bytes_, value);
}

void CsvTable::number(double value) {
    separate();
    appendNumber(bytes_, value);
}

void CsvTable::whole(long long value) {
    separate();
    const fmt::format_int digits(value);
    bytes_.append(digits.data(), digits.size());
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
