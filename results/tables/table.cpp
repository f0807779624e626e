#include "results/tables/table.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "column_words.hpp"
#include "results/tables/csv_table.hpp"

namespace deixis::results {

std::string inWords(std::string key) {
    std::replace(key.begin(), key.end(), '_', ' ');
    return key;
}

Column::Column(std::string called, ColumnKind of_kind, const Show& show)
    : name(std::move(called)),
      kind(show.estimate ? ColumnKind::estimate : of_kind),
      in(show.in),
      json(show.json != nullptr ? show.json : name),
      place(show.place),
      sparse(show.sparse),
      heading(show.heading),
      marked(show.marked),
      right(show.right) {
    const ColumnWords words = columnWords(name);
    const auto first = [&](const char* own, const char* known) {
        return own != nullptr ? own : known != nullptr ? known : "";
    };
    label = first(show.label, words.label);
    if (show.label == nullptr && words.label == nullptr) label = inWords(name);
    latex = first(show.latex, words.latex);
    format = show.format.value_or(words.format);
}

std::size_t Table::at(std::string_view column) const {
    const auto found =
        std::find_if(columns.begin(), columns.end(), [&](const Column& one) { return one.name == column; });
    if (found == columns.end()) throw std::logic_error(name + " has no column " + std::string(column));
    return static_cast<std::size_t>(found - columns.begin());
}

Table Table::where(std::string_view column, const std::string& value) const {
    const std::size_t place = at(column);
    Table out{name, unit, caption, columns};
    for (const Row& row : rows)
        if (row.cells[place].text() == value) out.rows.push_back(row);
    return out;
}

namespace {

std::vector<ColumnSpec> csvColumns(const Column& column) {
    using enum ColumnType;
    const std::string& name = column.name;
    if (column.kind == ColumnKind::text) return {{name, text, ""}};
    if (column.kind == ColumnKind::number) return {{name, number, ""}};
    const std::string end = name == "interval" ? "" : name + "_";
    if (column.kind == ColumnKind::range) return {{end + "lower", number, ""}, {end + "upper", number, ""}};
    return {{name, number, ""},
            {end + "lower", number, ""},
            {end + "upper", number, ""},
            {end + "lower_included", truth, ""},
            {end + "upper_included", truth, ""},
            {end + "level", number, ""}};
}

void addCsv(CsvTable& csv, const Column& column, const Cell& cell) {
    const auto add = [&](const std::optional<double>& value) { value ? csv.number(*value) : csv.empty(); };
    if (const auto* text = cell.as<std::string>()) return csv.text(*text);
    if (const auto* number = cell.as<double>()) return csv.number(*number);
    if (const auto* whole = cell.as<long long>()) return csv.whole(*whole);
    if (const auto* truth = cell.as<bool>()) return csv.whole(*truth ? 1 : 0);
    const auto* interval = cell.as<Interval>();
    if (interval == nullptr) return csv.empty();
    const bool all = column.kind == ColumnKind::estimate;
    if (all) add(interval->estimate);
    add(interval->lower);
    add(interval->upper);
    if (!all) return;
    csv.whole(interval->lower_included ? 1 : 0);
    csv.whole(interval->upper_included ? 1 : 0);
    add(interval->level);
}

struct CellJson {
    bool estimate;
    Json operator()(std::monostate) const { return {}; }
    Json operator()(const Interval& of) const {
        if (estimate)
            return {{"estimate", jsonOf(of.estimate)},     {"lower", jsonOf(of.lower)},
                    {"upper", jsonOf(of.upper)},           {"lower_included", of.lower_included},
                    {"upper_included", of.upper_included}, {"level", jsonOf(of.level)}};
        return of.lower ? Json{{"lower", *of.lower}, {"upper", *of.upper}} : Json();
    }
    Json operator()(const JsonValue& value) const { return *value; }
    Json operator()(const auto& value) const { return value; }
};

}  // namespace

std::string csvText(const Table& table) {
    std::vector<ColumnSpec> specs;
    for (const Column& column : table.columns)
        if ((column.in & in_csv) != 0)
            for (ColumnSpec& spec : csvColumns(column)) specs.push_back(std::move(spec));
    const std::string unit = table.unit.words;
    if (!unit.empty()) specs.push_back({"unit", ColumnType::text, ""});
    CsvTable csv(std::move(specs));
    for (const Table::Row& row : table.rows) {
        for (std::size_t i = 0; i < row.cells.size(); ++i)
            if ((table.columns[i].in & in_csv) != 0) addCsv(csv, table.columns[i], row.cells[i]);
        if (!unit.empty()) csv.text(unit);
        csv.endRow();
    }
    return csv.take();
}

Json rowJson(const std::vector<Column>& columns, const std::vector<Cell>& cells) {
    std::vector<std::size_t> order(columns.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return columns[a].place < columns[b].place; });
    Json out = Json::object();
    for (const std::size_t i : order) {
        const Column& column = columns[i];
        const bool nothing =
            cells[i].empty() || (cells[i].as<std::string>() != nullptr && cells[i].text().empty());
        if ((column.in & in_json) == 0 || (column.sparse && nothing)) continue;
        const std::size_t inner = column.json.find('/');
        Json& value = inner == std::string::npos
                          ? out[column.json]
                          : out[column.json.substr(0, inner)][column.json.substr(inner + 1)];
        value = std::visit(CellJson{column.kind == ColumnKind::estimate}, cells[i].value());
    }
    return out;
}

Json tableJson(const Table& table) {
    Json out = Json::array();
    for (const Table::Row& row : table.rows) out.push_back(rowJson(table.columns, row.cells));
    return out;
}

}  // namespace deixis::results
