#include "stats_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>
#include <unordered_map>
#include <utility>

#include "core/csv_sheet.hpp"
#include "core/files.hpp"
#include "core/foreign_csv.hpp"
#include "core/text.hpp"
#include "results/statistics/rounded_fraction.hpp"

namespace deixis::app {

namespace {

using results::Rational;
using Cell = std::optional<Rational>;

/// As the answers of `deixis report`.
bool isMissing(std::string_view text) {
    constexpr std::size_t longest = 4;
    if (text.size() > longest) return false;
    std::string lower(text);
    for (char& c : lower)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
    return lower.empty() || lower == "na" || lower == "nan" || lower == "null";
}

/// Digits behind the point of a plain decimal; 0 of what has an exponent or is a fraction.
int decimalsOf(std::string_view text) {
    const auto point = text.find('.');
    if (point == std::string_view::npos || text.find_first_of("eE/") != std::string_view::npos) return 0;
    return static_cast<int>(text.size() - point - 1);
}

struct Source {
    CsvSheet sheet;
    char separator = ',';
    mutable int rounded = 0;  ///< cells that number() took as fractions
    /// The first that it read with a decimal comma, and with a decimal point: "FILE:LINE: COLUMN: 3,5".
    mutable std::string with_comma{}, with_point{};

    [[nodiscard]] Result<std::size_t> find(const std::string& column) const {
        return sheet.column(column,
                            fmt::format("Columns found, separated by {}: {}", separatorName(separator),
                                        fmt::join(sheet.header.fields, ", ")));
    }
    [[nodiscard]] Result<Cell> number(const CsvRecord& row, std::size_t column) const {
        std::string_view text = trimmed(row.fields[column]);
        if (isMissing(text)) return Cell();
        // Between commas one within a number may part thousands.
        const auto as_point = separator == ',' ? std::nullopt : decimalCommaAsPoint(text);
        std::string& first = as_point ? with_comma : with_point;
        if (first.empty() && (as_point || text.find('.') != std::string_view::npos))
            first = fmt::format("{}: {}", sheet.place(row, column), text);
        if (as_point) text = *as_point;
        auto value = Rational::parse(text);
        if (!value) return fail(sheet.place(row, column), value.error());
        if (auto fraction = results::roundedFraction(*value, decimalsOf(text))) {
            ++rounded;
            return Cell(std::move(*fraction));
        }
        return Cell(std::move(*value));
    }
};

int linesIn(std::string_view text) {
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

/// The reader passes over empty lines; in a file of one column they are cells.
void restoreEmptyCells(CsvSheet& sheet, std::string_view text) {
    std::vector<CsvRecord> all;
    int next = sheet.header.line + 1 + linesIn(sheet.header.fields[0]);
    const auto fill = [&](int up_to) {
        for (; next < up_to; ++next) all.push_back({next, {""}});
    };
    for (CsvRecord& record : sheet.rows) {
        fill(record.line);
        next += 1 + linesIn(record.fields[0]);
        all.push_back(std::move(record));
    }
    fill(1 + linesIn(text) + (text.back() == '\n' ? 0 : 1));
    sheet.rows = std::move(all);
}

Result<Source> readSource(const std::string& file) {
    const std::string name = file == "-" ? "standard input" : file;
    auto read = file == "-" ? readAll(std::cin, name) : readFile(file);
    if (!read) return tl::unexpected(read.error());
    const auto csv = readForeignCsv(std::move(*read), name);
    if (!csv) return tl::unexpected(csv.error());
    auto sheet = parseCsvSheet(csv->text, name, csv->form);
    if (!sheet) return tl::unexpected(sheet.error());
    if (sheet->header.fields.empty())
        return fail(name, "is empty; expected a CSV file with the columns' names in its first line");
    if (sheet->header.fields.size() == 1) restoreEmptyCells(*sheet, csv->text);
    return Source{std::move(*sheet), csv->form.separator};
}

/// Means of the cells that belong to one participant and one column.
class Means {
  public:
    void add(const Cell& cell) {
        if (!cell) return;
        sum_ += *cell;
        ++count_;
    }
    [[nodiscard]] Cell mean() const {
        if (count_ == 0) return {};
        return sum_ / Rational(count_);
    }

  private:
    Rational sum_{};
    std::int64_t count_ = 0;
};

/// Participants in order of appearance.
class Participants {
  public:
    explicit Participants(std::size_t columns) : columns_(columns) {}
    std::vector<Means>& operator[](const std::string& id) {
        const auto [place, is_new] = places_.try_emplace(id, rows_.size());
        if (is_new) rows_.emplace_back(columns_);
        return rows_[place->second];
    }
    void fill(std::vector<StatsColumn>& columns) const {
        for (std::size_t c = 0; c < columns.size(); ++c)
            for (const auto& row : rows_) columns[c].cells.push_back(row[c].mean());
    }

  private:
    std::size_t columns_;
    std::unordered_map<std::string, std::size_t> places_;
    std::vector<std::vector<Means>> rows_;
};

Result<std::string> nameIn(const Source& source, const CsvRecord& row, std::size_t column) {
    const std::string_view text = trimmed(row.fields[column]);
    if (text.empty()) return fail(source.sheet.place(row, column), "is empty; expected a name");
    return std::string(text);
}

Result<void> readWide(const Source& source, const ColumnChoice& choice, StatsTable& table) {
    std::vector<std::size_t> places;
    for (const std::string& name : choice.columns) {
        const auto place = source.find(name);
        if (!place) return tl::unexpected(place.error());
        places.push_back(*place);
        table.columns.push_back({name});
        table.columns.back().cells.reserve(source.sheet.rows.size());
    }
    const bool joined = !choice.paired_by.empty();
    std::size_t by = 0;
    if (joined) {
        const auto place = source.find(choice.paired_by);
        if (!place) return tl::unexpected(place.error());
        by = *place;
    }
    Participants participants(places.size());
    for (const CsvRecord& row : source.sheet.rows) {
        std::vector<Means>* means = nullptr;
        if (joined) {
            const auto id = nameIn(source, row, by);
            if (!id) return tl::unexpected(id.error());
            means = &participants[*id];
        } else {
            table.lines.push_back(row.line);
        }
        for (std::size_t c = 0; c < places.size(); ++c) {
            auto cell = source.number(row, places[c]);
            if (!cell) return tl::unexpected(cell.error());
            if (joined)
                (*means)[c].add(*cell);
            else
                table.columns[c].cells.push_back(std::move(*cell));
        }
    }
    if (joined) participants.fill(table.columns);
    return {};
}

/// The place of the row's level among the columns; nothing where it is not wanted.
Result<std::optional<std::size_t>> levelOf(const Source& source, const CsvRecord& row, std::size_t group,
                                           bool all_levels, StatsTable& table) {
    const auto level = nameIn(source, row, group);
    if (!level) return tl::unexpected(level.error());
    for (std::size_t c = 0; c < table.columns.size(); ++c)
        if (table.columns[c].name == *level) return c;
    if (!all_levels) return std::nullopt;
    table.columns.push_back({*level});
    return table.columns.size() - 1;
}

Result<void> readLong(const Source& source, const ColumnChoice& choice, StatsTable& table) {
    const auto group = source.find(choice.group);
    if (!group) return tl::unexpected(group.error());
    const auto value = source.find(choice.value);
    if (!value) return tl::unexpected(value.error());
    const bool joined = !choice.paired_by.empty();
    std::size_t by = 0;
    if (joined) {
        const auto place = source.find(choice.paired_by);
        if (!place) return tl::unexpected(place.error());
        by = *place;
    }
    table.paired = joined;
    for (const std::string& level : choice.columns) table.columns.push_back({level});
    // Levels first: they say how many columns there are.
    std::vector<std::optional<std::size_t>> levels;
    for (const CsvRecord& row : source.sheet.rows) {
        const auto level = levelOf(source, row, *group, choice.columns.empty(), table);
        if (!level) return tl::unexpected(level.error());
        levels.push_back(*level);
    }
    for (std::size_t c = 0; c < table.columns.size(); ++c)
        if (std::find(levels.begin(), levels.end(), std::optional(c)) == levels.end())
            return fail(source.sheet.name, fmt::format("has no row with \"{}\" in column \"{}\"",
                                                       table.columns[c].name, choice.group));
    Participants participants(table.columns.size());
    for (std::size_t r = 0; r < source.sheet.rows.size(); ++r) {
        if (!levels[r]) continue;
        auto cell = source.number(source.sheet.rows[r], *value);
        if (!cell) return tl::unexpected(cell.error());
        if (!joined) {
            table.columns[*levels[r]].cells.push_back(std::move(*cell));
            continue;
        }
        const auto id = nameIn(source, source.sheet.rows[r], by);
        if (!id) return tl::unexpected(id.error());
        participants[*id][*levels[r]].add(*cell);
    }
    if (joined) participants.fill(table.columns);
    return {};
}

}  // namespace

std::vector<Rational> StatsColumn::values() const {
    std::vector<Rational> out;
    out.reserve(cells.size());
    for (const Cell& cell : cells)
        if (cell) out.push_back(*cell);
    return out;
}

int StatsColumn::missing() const {
    return static_cast<int>(
        std::count_if(cells.begin(), cells.end(), [](const Cell& cell) { return !cell; }));
}

Result<std::vector<std::string>> parseColumnNames(std::string_view text) {
    const auto lines = parseCsv(text, "--columns");
    if (!lines) return tl::unexpected(lines.error());
    if (lines->size() != 1)
        return fail("--columns", fmt::format("found {} lines, expected one, as in a,b", lines->size()));
    std::vector<std::string> names;
    for (const std::string& name : lines->front().fields) names.emplace_back(trimmed(name));
    return names;
}

Result<StatsTable> readStatsTable(const ColumnChoice& choice) {
    if (choice.group.empty() != choice.value.empty())
        return fail("",
                    "--group and --value belong together: the column with the conditions, and the column "
                    "with the numbers");
    if (choice.group.empty() && choice.columns.empty())
        return fail("", "no columns were named", "Name them: --columns a,b");
    const auto source = readSource(choice.file);
    if (!source) return tl::unexpected(source.error());
    StatsTable table;
    table.name = source->sheet.name;
    const auto read =
        choice.group.empty() ? readWide(*source, choice, table) : readLong(*source, choice, table);
    if (!read) return tl::unexpected(read.error());
    if (!source->with_comma.empty() && !source->with_point.empty())
        return fail(source->sheet.name,
                    fmt::format("has numbers with a decimal comma ({}) and with a decimal point ({})",
                                source->with_comma, source->with_point),
                    "Write all of them in the same way");
    table.rounded = source->rounded;
    table.decimal_commas = !source->with_comma.empty();
    return table;
}

std::vector<std::vector<Rational>> completeRows(const StatsTable& table) {
    std::vector<std::vector<Rational>> rows;
    for (std::size_t r = 0; r < table.columns.front().cells.size(); ++r) {
        std::vector<Rational> row;
        for (const StatsColumn& column : table.columns)
            if (column.cells[r]) row.push_back(*column.cells[r]);
        if (row.size() == table.columns.size()) rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace deixis::app
