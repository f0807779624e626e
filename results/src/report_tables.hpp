// What the report's tables have in common; private to the report.
#pragma once

#include <string>

#include "report_text.hpp"

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

/// One of AnalysisResult::measures, or that of preferences.
[[nodiscard]] Measure measureOf(const AnalysisResult& result, const std::string& name);

}  // namespace deixis::results
