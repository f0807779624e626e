// Interactions and equivalence.
#include <fmt/core.h>

#include "report_interactions.hpp"
#include "results/page/report_tables.hpp"

namespace deixis::results {

namespace {

/// Of signed-rank and rank-sum tests.
template <typename Result>
std::string shiftCells(const Result& one, const Measure& measure, const std::optional<double>& p) {
    return fmt::format(
        "<td>{}</td><td>{}</td><td class=\"{}\">{}</td></tr>",
        shiftText(one.test.hodges_lehmann, [&](double value) { return scoreText(measure, value); }), pText(p),
        one.significant ? "sig" : "not", pText(one.p_holm));
}

/// "naive - skilled, across - beside".
std::string contrast(const std::string& a, const std::string& b, const std::string& c, const std::string& d) {
    return fmt::format("<td class=\"text\">{} &#8722; {}</td><td class=\"text\">{} &#8722; {}</td>",
                       escapeHtml(a), escapeHtml(b), escapeHtml(c), escapeHtml(d));
}

}  // namespace

std::string interactionsHtml(const AnalysisResult& result, Numbering& numbering) {
    std::string rows;
    for (const InteractionResult& one : result.interactions) {
        const Measure measure = measureOf(result, one.measure);
        rows += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"text\">{} &#215; {}</td>{}<td>{}</td>",
                            escapeHtml(capitalised(one.measure)), escapeHtml(one.factor),
                            escapeHtml(one.other_factor), contrast(one.a, one.b, one.c, one.d),
                            one.test.n_pairs) +
                shiftCells(one, measure, one.test.p_two_sided);
    }
    for (const GroupInteractionResult& one : result.group_interactions) {
        const Measure measure = measureOf(result, one.measure);
        rows +=
            fmt::format(
                "<tr><th scope=\"row\">{}</th><td class=\"text\">{} &#215; {}</td>{}<td>{} and {}</td>",
                escapeHtml(capitalised(one.measure)), escapeHtml(one.other_factor), escapeHtml(one.factor),
                contrast(one.c, one.d, one.a, one.b), one.test.n_a, one.test.n_b) +
            shiftCells(one, measure, one.test.p_two_sided);
    }
    if (rows.empty()) return "";
    return openTable(
               units::differences,
               "Interactions: is a difference another one under another level? Each row tests a difference "
               "of "
               "differences over participants, within participants by the signed-rank test, between groups "
               "of "
               "participants (n of both) by the rank-sum test. Bold: significant after Holm's correction "
               "over "
               "the rows of one measure and pair of factors.",
               "<th>Measure</th><th class=\"text\">Factors</th><th class=\"text\">Difference</th>"
               "<th class=\"text\">between</th><th>n</th><th>Shift</th><th>p</th><th>p (Holm)</th>",
               numbering, TableWidth::dense) +
           rows + close_table +
           "<p class=\"small\">A test that is not significant does not show that there is no "
           "interaction.</p>";
}

std::string equivalenceHtml(const AnalysisResult& result, Numbering& numbering) {
    std::string rows;
    const auto add = [&](const std::string& measure, const std::string& where, const std::string& a,
                         const std::string& b, const std::optional<Equivalence>& found) {
        if (!found) return;
        rows += fmt::format(
            "<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td class=\"text\">{}</td>"
            "<td class=\"text\">{}</td><td>&#177; {}</td><td>{}</td><td>{}</td>"
            "<td class=\"text {}\">{}</td></tr>",
            escapeHtml(capitalised(measure)), escapeHtml(where), escapeHtml(a), escapeHtml(b),
            scoreText(measureOf(result, measure), found->bound), pText(found->p), pText(found->p_holm),
            found->equivalent ? "sig" : "not", found->equivalent ? "equivalent" : "not shown");
    };
    const auto place = [](const std::string& factor, const std::string& system) {
        return factor.empty() ? std::string("systems") : factor + (system == "all" ? "" : ", " + system);
    };
    for (const auto* tests : {&result.pairwise, &result.level_tests})
        for (const Comparison& one : *tests)
            add(one.measure, place(one.factor, one.system), one.a, one.b, one.equivalence);
    for (const BetweenResult& one : result.between)
        add(one.measure, place(one.factor, one.system), one.a, one.b, one.equivalence);
    if (rows.empty()) return "";
    return openTable(
               units::means,
               "Equivalence within the bound that was declared before: two one-sided tests, p of the larger "
               "one, Holm's correction within the families of the tests of difference.",
               "<th>Measure</th><th class=\"text\">Of</th><th class=\"text\">A</th><th class=\"text\">B</th>"
               "<th>Bound</th><th>p</th><th>p (Holm)</th><th class=\"text\">Result</th>",
               numbering, TableWidth::dense) +
           rows + close_table;
}

std::string interactionFindings(const AnalysisResult& result) {
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
    std::string out;
    for (const auto& [where, what] : found)
        out += fmt::format(
            "<li>Significant interaction of {}: {}. Differences over all levels of these factors "
            "hide it.</li>",
            where, what);
    return out;
}

}  // namespace deixis::results
