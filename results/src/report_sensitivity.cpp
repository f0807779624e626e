// Decisions beside those of other choices.
#include <fmt/core.h>

#include "report_details.hpp"
#include "report_tables.hpp"

namespace deixis::results {

namespace {

std::string decided(const std::optional<double>& p_holm, double alpha, bool changes) {
    if (!p_holm) return fmt::format("<td>{}</td>", dash);
    const char* verdict = *p_holm <= alpha ? "yes" : "no";
    return changes ? fmt::format("<td class=\"sig\">{} ({})</td>", pText(*p_holm), verdict)
                   : fmt::format("<td>{}</td>", pText(*p_holm));
}

std::string countsText(const AnswerCounts& counts) {
    return fmt::format("{} participants, {} answers", counts.participants, counts.answers);
}

}  // namespace

std::string sensitivityHtml(const AnalysisResult& result, Numbering& numbering) {
    if (result.participants < 2) return "";
    const bool left_out = result.answers_with_left_out.answers != result.headline_answers.answers;
    const bool doubtful = result.answers_without_doubtful.answers != result.headline_answers.answers;
    std::string rows;
    bool any = false;
    for (const SensitivityResult& one : result.sensitivity) {
        const AdjustedTest& head = one.headline;
        if (head.test.n_pairs == 0 && one.with_left_out.test.n_pairs == 0) continue;
        const auto cell = [&](const std::optional<double>& p_holm, bool changes) {
            return decided(p_holm, result.alpha, changes);
        };
        const bool hangs = head.depends_on_zeros || head.depends_on_approximation ||
                           one.depends_on_left_out || one.depends_on_doubtful;
        any = any || hangs;
        rows += fmt::format(
            "<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td class=\"text\">{}</td>{}{}{}{}{}"
            "<td class=\"text\">{}</td></tr>",
            escapeHtml(capitalised(one.measure)), escapeHtml(one.a), escapeHtml(one.b),
            cell(head.p_holm, false), cell(head.p_holm_pratt, head.depends_on_zeros),
            cell(head.p_holm_normal, head.depends_on_approximation),
            left_out ? cell(one.with_left_out.p_holm, one.depends_on_left_out) : "",
            doubtful ? cell(one.without_doubtful.p_holm, one.depends_on_doubtful) : "",
            hangs ? "<b>yes</b>" : "no");
    }
    if (rows.empty()) return "";
    std::string caption = fmt::format(
        "The pairs of systems, p after Holm's correction: as in the headline ({}); with differences of zero "
        "ranked (Pratt); with the normal approximation",
        countsText(result.headline_answers));
    if (left_out)
        caption += fmt::format("; with the participants who are left out ({})",
                               countsText(result.answers_with_left_out));
    if (doubtful)
        caption += fmt::format(
            "; without marked trials (interrupted, off place) and without participants who failed an "
            "attention check ({})",
            countsText(result.answers_without_doubtful));
    std::string out =
        "<h2>Does the decision hang on a choice?</h2>" +
        openTable(caption + ".",
                  fmt::format("<th>Measure</th><th class=\"text\">A</th><th class=\"text\">B</th>"
                              "<th>headline</th><th>Pratt</th><th>normal</th>{}{}<th class=\"text\">Does it?"
                              "</th>",
                              left_out ? "<th>with left out</th>" : "",
                              doubtful ? "<th>without doubtful</th>" : ""),
                  numbering, TableWidth::dense) +
        rows + close_table;
    out += any ? fmt::format(
                     "<p class=\"small\">Where a decision at &#945;&#160;=&#160;{} would be another, "
                     "(yes) or (no) tells whether it is significant there.</p>",
                     result.alpha)
               : "<p class=\"small\">No decision depends on any of these choices.</p>";
    if (!left_out && !doubtful)
        out +=
            "<p class=\"small\">No answers are left out by exclusion, and none are in doubt: no trial was "
            "marked, no participant failed a check.</p>";
    return out;
}

}  // namespace deixis::results
