// What the tables of the pages have in common.
#pragma once

#include <functional>
#include <string>

#include "results/analysis/analysis.hpp"
#include "results/page/report_text.hpp"
#include "results/statistics/descriptive.hpp"
#include "results/tables/table_unit.hpp"

namespace deixis::results {

enum class TableWidth : unsigned char {
    normal,
    dense  ///< smaller, for many columns
};

/// What a wide table is scrolled in, by keyboard too; `label` names it to who does not see it.
[[nodiscard]] std::string openScroll(const std::string& label);

/// The sentence at a caption's end, HTML.
[[nodiscard]] std::string unitText(TableUnit unit);

/// `caption` ends with its full stop; the unit stands behind it.
[[nodiscard]] std::string openTable(TableUnit unit, const std::string& caption, const std::string& columns,
                                    Numbering& numbering, TableWidth width = TableWidth::normal);

constexpr const char* close_table = "</tbody></table></div>";

/// Of a table of what box plots draw: the columns' heads, and the cells of a row, HTML.
extern const char* const box_columns;
[[nodiscard]] std::string boxCells(const BoxSummary& box, const std::function<std::string(double)>& text);

using NumberText = std::function<std::string(double)>;
/// scoreText() of a measure.
[[nodiscard]] NumberText scoreTextOf(const Measure& measure);

/// Of a table of signed-rank tests: the columns' heads, and the cells of a row but for the corrected p, HTML.
extern const char* const signed_rank_columns;
[[nodiscard]] std::string signedRankCells(const AdjustedTest& tested, const NumberText& text);

/// Likewise of rank-sum tests of two groups, and a group's mean, or a dash.
extern const char* const group_test_columns;
[[nodiscard]] std::string groupTestCells(const GroupTest& one, const NumberText& text);
[[nodiscard]] std::string groupMean(const NumberText& text, int n, double mean);

/// One of AnalysisResult::measures, or that of preferences.
[[nodiscard]] Measure measureOf(const AnalysisResult& result, const std::string& name);

}  // namespace deixis::results
