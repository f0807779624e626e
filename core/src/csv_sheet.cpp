#include "core/csv_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/number.hpp"
#include "core/text.hpp"

namespace deixis {

std::optional<std::size_t> CsvSheet::find(std::string_view column) const {
    const auto found = std::find(header.fields.begin(), header.fields.end(), column);
    if (found == header.fields.end()) return std::nullopt;
    return static_cast<std::size_t>(found - header.fields.begin());
}

Result<std::size_t> CsvSheet::column(std::string_view column, std::string hint) const {
    const auto count = std::count(header.fields.begin(), header.fields.end(), column);
    if (count == 1) return *find(column);
    return fail(place(header),
                count == 0 ? fmt::format("the column '{}' is missing from the header", column)
                           : fmt::format("the column '{}' is in the header more than once", column),
                std::move(hint));
}

Result<void> CsvSheet::checkWidth(const CsvRecord& row) const {
    const std::size_t found = row.fields.size();
    if (found == header.fields.size()) return {};
    return fail(place(row), fmt::format("found {} field{}, expected {} as in the header", found,
                                        found == 1 ? "" : "s", header.fields.size()));
}

std::string CsvSheet::place(const CsvRecord& row) const {
    return fmt::format("{}:{}", name, row.line);
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

Result<CsvSheet> readCsvHeader(CsvReader& reader, const std::string& name) {
    CsvSheet sheet{name, {}, {}};
    if (const auto there = reader.next(sheet.header); !there) return tl::unexpected(there.error());
    for (std::string& field : sheet.header.fields) field = std::string(trimmed(field));
    return sheet;
}

Result<CsvSheet> parseCsvSheet(std::string_view text, const std::string& name, CsvForm form) {
    CsvReader reader(text, name, form);
    auto sheet = readCsvHeader(reader, name);
    if (!sheet) return sheet;
    for (;;) {
        CsvRecord row;
        const auto more = reader.next(row);
        if (!more) return tl::unexpected(more.error());
        if (!*more) return sheet;
        if (auto width = sheet->checkWidth(row); !width) return tl::unexpected(width.error());
        sheet->rows.push_back(std::move(row));
    }
}

}  // namespace deixis
