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
    return fmt::format("{}<table{}><caption><span>{} {}</span></caption><thead><tr>{}</tr></thead><tbody>",
                       openScroll(numbering.name()), width == TableWidth::dense ? " class=\"dense\"" : "",
                       number, caption, columns);
}

const char* const box_columns =
    "<th>5&#160;%</th><th>25&#160;%</th><th>Median</th><th>75&#160;%</th><th>95&#160;%</th><th>Notch</th>"
    "<th>n</th>";

std::string boxCells(const BoxSummary& box, const std::function<std::string(double)>& text) {
    std::string out;
    for (const double value : {box.q05, box.q25, box.median, box.q75, box.q95})
        out += "<td>" + text(value) + "</td>";
    return out +
           (box.notch_low >= box.q25 && box.notch_high <= box.q75
                ? fmt::format("<td>[{}, {}]</td>", text(box.notch_low), text(box.notch_high))
                : fmt::format("<td>{}</td>", dash)) +
           fmt::format("<td>{}</td>", box.n);
}

Measure measureOf(const AnalysisResult& result, const std::string& name) {
    return *std::find_if(result.table.measures.begin(), result.table.measures.end(),
                         [&](const Measure& one) { return one.name == name; });
}

}  // namespace deixis::results
