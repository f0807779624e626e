#include "report_tables.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace deixis::results {

std::string openTable(const std::string& caption, const std::string& columns, Numbering& numbering,
                      TableWidth width) {
    return fmt::format(
        "<div class=\"scroll\"><table{}><caption>{} {}</caption><thead><tr>{}</tr></thead><tbody>",
        width == TableWidth::dense ? " class=\"dense\"" : "", numbering.next(), caption, columns);
}

Measure measureOf(const AnalysisResult& result, const std::string& name) {
    return *std::find_if(result.table.measures.begin(), result.table.measures.end(),
                         [&](const Measure& one) { return one.name == name; });
}

}  // namespace deixis::results
