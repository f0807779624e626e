// What the tables of the pages have in common.
#pragma once

#include <functional>
#include <string>

#include "report_text.hpp"
#include "results/descriptive.hpp"

namespace deixis::results {

enum class TableWidth : unsigned char {
    normal,
    dense  ///< smaller, for many columns
};

/// What a wide table is scrolled in, by keyboard too; `label` names it to who does not see it.
[[nodiscard]] std::string openScroll(const std::string& label);

[[nodiscard]] std::string openTable(const std::string& caption, const std::string& columns,
                                    Numbering& numbering, TableWidth width = TableWidth::normal);

constexpr const char* close_table = "</tbody></table></div>";

/// Of a table of what box plots draw: the columns' heads, and the cells of a row, HTML.
extern const char* const box_columns;
[[nodiscard]] std::string boxCells(const BoxSummary& box, const std::function<std::string(double)>& text);

/// One of AnalysisResult::measures, or that of preferences.
[[nodiscard]] Measure measureOf(const AnalysisResult& result, const std::string& name);

}  // namespace deixis::results
