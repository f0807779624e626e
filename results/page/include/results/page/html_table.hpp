// Tables on a page: HTML from the one model of a table.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "results/analysis/analysis.hpp"
#include "results/page/number_text.hpp"
#include "results/statistics/descriptive.hpp"
#include "results/tables/table.hpp"

namespace deixis::results {

/// A column that a page shows.
struct Shown {
    const char* name;
    const char* label = "";  ///< empty: the column's own

    Shown(const char* column, const char* shown_label = "")  // NOLINT(google-explicit-constructor)
        : name(column), label(shown_label) {}
};

struct TableLook {
    bool dense = false;     ///< smaller, for many columns
    bool row_names = true;  ///< the first cell names its row
    /// A row above the columns' heads, behind the first: heads, and over how many columns each stands.
    std::vector<std::pair<std::string, std::size_t>> over{};
};
inline const TableLook dense_table{true};

/// `caption` is text and ends with its full stop; the unit stands behind it.
[[nodiscard]] std::string tableHtml(const Table& table, const std::string& caption,
                                    const std::vector<Shown>& shown, Numbering& numbering,
                                    const TableLook& look = {});
/// All columns.
[[nodiscard]] std::string tableHtml(const Table& table, const std::string& caption, Numbering& numbering,
                                    const TableLook& look = {});
/// Without a number, folded away under `summary`; belongs to the table called `name`.
[[nodiscard]] std::string foldedTable(const Table& table, const std::string& summary, const std::string& name,
                                      const std::vector<Shown>& shown, const TableLook& look);
/// HTML folded away.
[[nodiscard]] std::string folded(const std::string& summary, const std::string& html);

/// How a cell stands on a page, text.
[[nodiscard]] std::string cellText(const Column& column, const Cell& cell, bool percent);

/// What stands in a wide table for each value of one column.
struct AcrossColumn {
    std::function<std::string(const std::string&)> label;  ///< of the value
    std::function<Cell(const Table::Row&)> cell;
};
/// A row for each combination of `keys` in the order in which they first stand, and columns for each of
/// `values` of the column `across`; empty if there is no such row.
[[nodiscard]] Table wide(const Table& table, const std::vector<const char*>& keys, const char* across,
                         const std::vector<std::string>& values, const std::vector<AcrossColumn>& columns);

/// The columns of what box plots draw; text() makes the numbers.
[[nodiscard]] Fields<BoxSummary> boxFields(const std::function<std::string(double)>& text);

/// One of AnalysisResult::measures, or that of preferences.
[[nodiscard]] Measure measureOf(const AnalysisResult& result, const std::string& name);

}  // namespace deixis::results
