#include "core/csv_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/number.hpp"

namespace deixis {

std::optional<std::size_t> CsvSheet::find(std::string_view column) const {
    const auto found = std::find(header.fields.begin(), header.fields.end(), column);
    if (found == header.fields.end()) return std::nullopt;
    return static_cast<std::size_t>(found - header.fields.begin());
}

Result<std::size_t> CsvSheet::column(std::string_view column, std::string hint) const {
    if (const auto found = find(column)) return *found;
    return fail(fmt::format("{}:{}", name, header.line),
                fmt::format("the column '{}' is missing from the header", column), std::move(hint));
}

std::string CsvSheet::place(const CsvRecord& row, std::size_t column) const {
    return fmt::format("{}:{}: {}", name, row.line, header.fields[column]);
}

Result<double> CsvSheet::number(const CsvRecord& row, std::size_t column, std::string_view expected,
                                double max) const {
    const std::string& cell = row.fields[column];
    const auto value = finiteNumber(cell);
    if (value && std::abs(*value) <= max) return *value;
    return fail(place(row, column), fmt::format("found '{}', expected {}", cell, expected));
}

Result<CsvSheet> parseCsvSheet(std::string_view text, const std::string& name) {
    auto records = parseCsv(text, name);
    if (!records) return tl::unexpected(records.error());
    CsvSheet sheet{name, {}, {}};
    if (records->empty()) return sheet;
    sheet.header = std::move(records->front());
    records->erase(records->begin());
    for (const CsvRecord& row : *records)
        if (row.fields.size() != sheet.header.fields.size())
            return fail(fmt::format("{}:{}", name, row.line),
                        fmt::format("found {} fields, expected {} as in the header", row.fields.size(),
                                    sheet.header.fields.size()));
    sheet.rows = std::move(*records);
    return sheet;
}

}  // namespace deixis
