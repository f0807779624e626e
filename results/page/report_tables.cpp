#include "results/page/report_tables.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace deixis::results {

std::string unitText(TableUnit unit) {
    return fmt::format("Unit:&#160;{}.", escapeHtml(unit.words));
}

std::string openScroll(const std::string& label) {
    return fmt::format("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">", label);
}

std::string openTable(TableUnit unit, const std::string& caption, const std::string& columns,
                      Numbering& numbering, TableWidth width) {
    const std::string number = numbering.next();
    return fmt::format("{}<table{}><caption><span>{} {} {}</span></caption><thead><tr>{}</tr></thead><tbody>",
                       openScroll(numbering.name()), width == TableWidth::dense ? " class=\"dense\"" : "",
                       number, caption, unitText(unit), columns);
}

const char* const box_columns =
    "<th>5&#160;%</th><th>25&#160;%</th><th>Median</th><th>75&#160;%</th><th>95&#160;%</th><th>Notch</th>"
    "<th>n</th>";

std::string boxCells(const BoxSummary& box, const std::function<std::string(double)>& text) {
    std::string out;
    for (const double value : {box.q05, box.q25, box.median, box.q75, box.q95})
        out += "<td>" + text(value) + "</td>";
    return out +
           (box.notched() ? fmt::format("<td>[{}, {}]</td>", text(box.notch_low), text(box.notch_high))
                          : fmt::format("<td>{}</td>", dash)) +
           fmt::format("<td>{}</td>", box.n);
}

NumberText scoreTextOf(const Measure& measure) {
    return [measure](double value) { return scoreText(measure, value); };
}

namespace {

std::string effectText(const std::optional<double>& effect) {
    return effect ? signedText(fmt::format("{:.2f}", *effect)) : std::string(dash);
}

}  // namespace

const char* const signed_rank_columns = "<th>n</th><th>Shift</th><th>r</th><th>p</th><th>p (Holm)</th>";

std::string signedRankCells(const AdjustedTest& tested, const NumberText& text) {
    const SignedRankTest& test = tested.test;
    return fmt::format("<td>{}</td><td>{}</td><td>{}</td><td>{}</td>", test.n_pairs,
                       shiftText(test.hodges_lehmann, text), effectText(test.rank_biserial),
                       test.n_pairs > 0 ? pText(test.p_two_sided) : std::string(dash));
}

const char* const group_test_columns =
    "<th>Shift</th><th>&#948;</th><th>A<sub>12</sub></th><th>p</th><th>p (Holm)</th>";

std::string groupTestCells(const GroupTest& one, const NumberText& text) {
    const RankSumTest& test = one.test;
    return fmt::format("<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"{}\">{}</td>",
                       shiftText(test.hodges_lehmann, text), effectText(test.cliffs_delta),
                       test.a12 ? fmt::format("{:.2f}", *test.a12) : std::string(dash),
                       pText(test.p_two_sided), one.significant ? "sig" : "not", pText(one.p_holm));
}

std::string groupMean(const NumberText& text, int n, double mean) {
    return n > 0 ? text(mean) : dash;
}

Measure measureOf(const AnalysisResult& result, const std::string& name) {
    return *std::find_if(result.table.measures.begin(), result.table.measures.end(),
                         [&](const Measure& one) { return one.name == name; });
}

}  // namespace deixis::results
