#include "results/page/html_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"

namespace deixis::results {

namespace {

const std::string nothing = "\u2013";

std::string numberText(double value, Format format, bool percent) {
    switch (format) {
        case Format::p_value:
            return pWords(value);
        case Format::rank:
            return fmt::format("{}", value);
        case Format::magnitude:
            return fixedText(std::abs(value), 2);
        case Format::one_decimal:
            return fixedText(value, 1);
        case Format::three_decimals:
            return fixedText(value, 3);
        case Format::percent:
            return fixedText(100.0 * value, 1) + "\u00a0%";
        case Format::score:
            return percent ? numberText(value, Format::percent, true) : fixedText(value, 2);
        case Format::plain:
        case Format::title:
        case Format::key:
            break;
    }
    return fixedText(value, 2);
}

struct PageCell {
    const Column& column;
    bool percent;
    [[nodiscard]] std::string number(const std::optional<double>& value) const {
        return value ? numberText(*value, column.format, percent) : nothing;
    }
    std::string operator()(std::monostate) const { return nothing; }
    std::string operator()(const std::string& text) const {
        return column.format == Format::title ? capitalised(text)
               : column.format == Format::key ? inWords(text)
                                              : text;
    }
    std::string operator()(double value) const { return number(value); }
    std::string operator()(long long value) const { return fmt::format("{}", value); }
    std::string operator()(bool value) const { return value ? "yes" : "no"; }
    std::string operator()(const Interval& of) const {
        const bool estimate = column.kind == ColumnKind::estimate;
        if (estimate && !of.estimate) return nothing;
        const std::string before = estimate ? number(of.estimate) : "";
        if (!of.lower || !of.upper) return estimate ? before : nothing;
        return fmt::format("{}{}{}{}, {}{}{}", before, estimate ? " " : "", of.lower_included ? "[" : "(",
                           number(of.lower), number(of.upper), of.upper_included ? "]" : ")", of.mark);
    }
    std::string operator()(const JsonValue&) const { return nothing; }
};

bool ofText(const Column& column) {
    return column.kind == ColumnKind::text && !column.right;
}

Json cellData(const Column& column, const Table::Row& row, std::size_t place, bool name) {
    std::string text = cellText(column, row.cells[place], row.percent);
    std::string marks = ofText(column) ? "text" : "";
    const auto add = [&](const std::string& mark) { marks += (marks.empty() ? "" : " ") + mark; };
    if (column.marked) add(row.significant ? "sig" : "not");
    for (const auto& [at, mark] : row.marks)
        if (at == place) add(mark);
    const std::size_t line = text.find('\n');
    Json out{{"name", name}, {"class", marks}, {"text", text.substr(0, line)}};
    if (line != std::string::npos) out["below"] = text.substr(line + 1);
    if (column.name == "link" && !row.cells[place].empty()) {
        out["link"] = text;
        out["text"] = "";
    }
    return out;
}

Json tableData(const Table& table, const std::vector<Shown>& shown, const TableLook& look) {
    Json columns = Json::array();
    std::vector<std::size_t> places;
    for (const Shown& one : shown) {
        places.push_back(table.at(one.name));
        const Column& column = table.columns[places.back()];
        const bool text = ofText(column) && !(look.row_names && columns.empty());
        columns.push_back({{"heading", one.label[0] != '\0' ? one.label : column.label}, {"of_text", text}});
    }
    Json rows = Json::array();
    for (const Table::Row& row : table.rows) {
        Json cells = Json::array();
        for (const std::size_t place : places)
            cells.push_back(cellData(table.columns[place], row, place, look.row_names && cells.empty()));
        rows.push_back({{"all", row.all}, {"cells", std::move(cells)}});
    }
    Json over = Json::array();
    for (const auto& [heading, width] : look.over) over.push_back({{"heading", heading}, {"width", width}});
    return {{"dense", look.dense},     {"unit", table.unit.words},  {"columns", std::move(columns)},
            {"rows", std::move(rows)}, {"has_over", !over.empty()}, {"over", over}};
}

std::vector<Shown> allColumns(const Table& table) {
    std::vector<Shown> out;
    for (const Column& column : table.columns) out.emplace_back(column.name.c_str());
    return out;
}

}  // namespace

std::string cellText(const Column& column, const Cell& cell, bool percent) {
    return std::visit(PageCell{column, percent}, cell.value());
}

std::string tableHtml(const Table& table, const std::string& caption, const std::vector<Shown>& shown,
                      Numbering& numbering, const TableLook& look) {
    Json data = tableData(table, shown, look);
    (void)numbering.next();
    data["label"] = numbering.name();
    data["number"] = numbering.name();
    data["caption"] = caption;
    // Such a table is not to be read past.
    constexpr std::string_view warning = "pseudo-replicated";
    if (const auto at = caption.find(std::string(warning) + ":"); at != std::string::npos) {
        data["caption"] = caption.substr(0, at);
        data["warning"] = warning;
        data["rest"] = caption.substr(at + warning.size());
    }
    return filled("table.mustache", data);
}

std::string tableHtml(const Table& table, const std::string& caption, Numbering& numbering,
                      const TableLook& look) {
    return tableHtml(table, caption, allColumns(table), numbering, look);
}

std::string foldedTable(const Table& table, const std::string& summary, const std::string& name,
                        const std::vector<Shown>& shown, const TableLook& look) {
    Json data = tableData(table, shown, look);
    data["label"] = name + ": " + lowerCase(summary.substr(0, 1)) + summary.substr(1);
    return folded(summary, filled("table.mustache", data));
}

std::string folded(const std::string& summary, const std::string& html) {
    return filled("folded.mustache", {{"summary", summary}, {"html", html}});
}

Table wide(const Table& table, const std::vector<const char*>& keys, const char* across,
           const std::vector<std::string>& values, const std::vector<AcrossColumn>& columns) {
    Table out{table.name, table.unit};
    std::vector<std::size_t> places;
    for (const char* key : keys) {
        places.push_back(table.at(key));
        out.columns.push_back(table.columns[places.back()]);
    }
    for (const std::string& value : values)
        for (const AcrossColumn& column : columns) {
            out.columns.emplace_back(fmt::format("column {}", out.columns.size()), ColumnKind::number);
            out.columns.back().label = column.label(value);
        }
    const std::size_t place_across = table.at(across);
    for (const Table::Row& row : table.rows) {
        std::vector<Cell> key;
        for (const std::size_t place : places) key.push_back(row.cells[place]);
        const auto same = [&](const Table::Row& other) {
            return std::equal(key.begin(), key.end(), other.cells.begin(),
                              [](const Cell& a, const Cell& b) { return a.value() == b.value(); });
        };
        auto found = std::find_if(out.rows.begin(), out.rows.end(), same);
        if (found == out.rows.end()) {
            key.resize(out.columns.size());
            out.rows.push_back({std::move(key), row.percent});
            found = out.rows.end() - 1;
        }
        const auto value = std::find(values.begin(), values.end(), row.cells[place_across].text());
        if (value == values.end()) continue;
        const auto first = keys.size() + static_cast<std::size_t>(value - values.begin()) * columns.size();
        for (std::size_t i = 0; i < columns.size(); ++i) found->cells[first + i] = columns[i].cell(row);
    }
    return out;
}

Fields<BoxSummary> boxFields(const std::function<std::string(double)>& text) {
    const Show number{.right = true};
    const auto of = [=](double BoxSummary::*member) {
        return [=](const BoxSummary& one) { return text(one.*member); };
    };
    const auto notch = [=](const BoxSummary& one) {
        return one.notched() ? fmt::format("[{}, {}]", text(one.notch_low), text(one.notch_high)) : nothing;
    };
    return {{"q05", of(&BoxSummary::q05), number},
            {"q25", of(&BoxSummary::q25), number},
            {"median", of(&BoxSummary::median), number},
            {"q75", of(&BoxSummary::q75), number},
            {"q95", of(&BoxSummary::q95), number},
            {"notch", notch, {.label = "Notch", .right = true}},
            {"n", &BoxSummary::n}};
}

Measure measureOf(const AnalysisResult& result, const std::string& name) {
    return *std::find_if(result.table.measures.begin(), result.table.measures.end(),
                         [&](const Measure& one) { return one.name == name; });
}

}  // namespace deixis::results
