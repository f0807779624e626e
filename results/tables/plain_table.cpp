#include "results/tables/plain_table.hpp"

namespace deixis::results {

PlainCell knownCell(bool known, double value) {
    return known ? PlainCell(value) : PlainCell();
}

PlainCell plainCell(const std::optional<double>& value) {
    return value ? PlainCell(*value) : PlainCell();
}

std::string csvText(const PlainTable& table) {
    std::vector<ColumnSpec> columns;
    for (const PlainColumn& column : table.columns) columns.push_back({column.name, column.type, ""});
    const std::string unit = table.unit.words;
    if (!unit.empty()) columns.push_back({"unit", ColumnType::text, ""});
    CsvTable csv(std::move(columns));
    for (const auto& row : table.rows) {
        for (const PlainCell& cell : row) {
            if (const auto* text = std::get_if<std::string>(&cell))
                csv.text(*text);
            else if (const auto* number = std::get_if<double>(&cell))
                csv.number(*number);
            else if (const auto* whole = std::get_if<long long>(&cell))
                csv.whole(*whole);
            else if (const auto* truth = std::get_if<bool>(&cell))
                csv.whole(*truth ? 1 : 0);
            else
                csv.empty();
        }
        if (!unit.empty()) csv.text(unit);
        csv.endRow();
    }
    return csv.take();
}

}  // namespace deixis::results
