// Interactions and equivalence.
#include <fmt/core.h>

#include "interactions.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/page/html_table.hpp"
#include "results/page/page.hpp"

namespace deixis::results {

namespace {

/// Takes over what both kinds of interactions have; `difference` and `between`: of which the contrast is.
void addContrasts(Table& out, const Table& from, const char* first_factor, const char* second_factor,
                  const char* a, const char* b, const char* c, const char* d) {
    for (const Table::Row& row : from.rows) {
        const auto text = [&](const char* column) { return row.cells[from.at(column)].text(); };
        const auto cell = [&](const char* column) { return row.cells[from.at(column)]; };
        const bool groups = std::string(first_factor) == "other_factor";
        const auto n = [&](const char* column) { return *cell(column).as<long long>(); };
        out.rows.push_back(
            {{cell("measure"), text(first_factor) + " \u00d7 " + text(second_factor),
              text(a) + " \u2212 " + text(b), text(c) + " \u2212 " + text(d),
              groups ? fmt::format("{} and {}", n("n_a"), n("n_b")) : fmt::format("{}", n("n")),
              cell("hodges_lehmann"), cell("p"), cell("p_holm")},
             row.percent,
             row.significant});
    }
}

}  // namespace

std::string interactionsHtml(const AnalysisResult& result, Numbering& numbering) {
    const Table within = tables::interactions(result);
    Table table{"interactions",
                units::differences,
                "",
                {{"measure", ColumnKind::text},
                 {"factors", ColumnKind::text, {.label = "Factors"}},
                 {"difference", ColumnKind::text, {.label = "Difference"}},
                 {"between", ColumnKind::text},
                 {"n", ColumnKind::number},
                 {"hodges_lehmann", ColumnKind::estimate},
                 {"p", ColumnKind::number},
                 {"p_holm", ColumnKind::number, {.marked = true}}}};
    addContrasts(table, within, "factor", "other_factor", "a", "b", "c", "d");
    addContrasts(table, tables::groupInteractions(result), "other_factor", "factor", "c", "d", "a", "b");
    if (table.rows.empty()) return "";
    return tableHtml(table,
                     "Interactions: does a difference change with the level of another factor? Each row "
                     "tests a difference of differences over participants, within participants by the "
                     "signed-rank test, between groups of participants (n of both) by the rank-sum test. "
                     "Bold: significant after Holm's "
                     "correction over "
                     "the rows of one measure and pair of factors.",
                     numbering, dense_table) +
           noteHtml("A non-significant test does not show that there is no interaction.");
}

std::string equivalenceHtml(const AnalysisResult& result, Numbering& numbering) {
    Table table = tables::equivalence(result);
    if (table.rows.empty()) return "";
    table.columns.push_back({"bounds", ColumnKind::number, {.label = "Bound"}});
    const std::size_t bound = table.at("bound");
    for (Table::Row& row : table.rows)
        row.cells.emplace_back("\u00b1 " + cellText(table.columns[bound], row.cells[bound], row.percent));
    return tableHtml(table,
                     "Equivalence within a bound declared in advance: two one-sided tests, the larger p, "
                     "Holm's correction within the families of the tests of difference.",
                     {"measure", "where", "a", "b", "bounds", "p", "p_holm", "verdict"}, numbering,
                     dense_table);
}

std::vector<std::string> interactionFindings(const AnalysisResult& result) {
    std::map<std::string, std::string> found;  // by measure and factors
    const auto add = [&](const std::string& measure, const std::string& factors, const std::string& what) {
        std::string& of = found[fmt::format("{} in {}", factors, escapeHtml(measure))];
        of += (of.empty() ? "" : "; ") + what;
    };
    const auto differs = [](const std::string& a, const std::string& b, const std::string& c,
                            const std::string& d) {
        return fmt::format("{} against {} differs between {} and {}", escapeHtml(a), escapeHtml(b),
                           escapeHtml(c), escapeHtml(d));
    };
    for (const InteractionResult& one : result.interactions)
        if (one.significant)
            add(one.measure, escapeHtml(one.factor) + " and " + escapeHtml(one.other_factor),
                differs(one.a, one.b, one.c, one.d));
    for (const GroupInteractionResult& one : result.group_interactions)
        if (one.significant)
            add(one.measure, escapeHtml(one.other_factor) + " and " + escapeHtml(one.factor),
                differs(one.c, one.d, one.a, one.b));
    std::vector<std::string> out;
    for (const auto& [where, what] : found)
        out.push_back(fmt::format(
            "Significant interaction of {}: {}. Differences over all levels of these factors hide it.", where,
            what));
    return out;
}

}  // namespace deixis::results
