#include "report_tables.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace deixis::results {

std::string openScroll(const std::string& label) {
    return fmt::format("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">", label);
}

std::string openTable(const std::string& caption, const std::string& columns, Numbering& numbering,
                      TableWidth width) {
    const std::string number = numbering.next();
    return fmt::format("{}<table{}><caption>{} {}</caption><thead><tr>{}</tr></thead><tbody>",
                       openScroll(numbering.name()), width == TableWidth::dense ? " class=\"dense\"" : "",
                       number, caption, columns);
}

Measure measureOf(const AnalysisResult& result, const std::string& name) {
    return *std::find_if(result.table.measures.begin(), result.table.measures.end(),
                         [&](const Measure& one) { return one.name == name; });
}

}  // namespace deixis::results
