// Decisions beside those of other choices.
#include <fmt/core.h>

#include "report_details.hpp"
#include "results/page/report_tables.hpp"

namespace deixis::results {

namespace {

std::string decided(const std::optional<double>& p_holm, double alpha, bool changes) {
    if (!p_holm) return fmt::format("<td>{}</td>", dash);
    const char* verdict = *p_holm <= alpha ? "yes" : "no";
    return changes ? fmt::format("<td class=\"sig\">{} ({})</td>", pText(*p_holm), verdict)
                   : fmt::format("<td>{}</td>", pText(*p_holm));
}

std::string countsText(const AnswerCounts& counts) {
    return fmt::format("{}, {}", counted(counts.participants, "participant", "participants"),
                       counted(counts.answers, "answer", "answers"));
}

/// A column of the table.
struct OtherChoice {
    AnswerChoice choice;
    const char* column;
    const char* words;
};
constexpr OtherChoice other_choices[]{
    {AnswerChoice::with_left_out, "with left out", "with the participants who are left out"},
    {AnswerChoice::without_doubtful, "without doubtful",
     "without marked trials (interrupted, off place) and without participants who failed an attention check"},
    {AnswerChoice::answered_only, "without timed out",
     "without choices that timed out, which the headline "
     "counts as wrong"},
    {AnswerChoice::unanswered_wrong, "skipped as wrong", "with choices that were skipped as wrong ones"}};

const AnswerCounts& countsOf(const AnalysisResult& result, AnswerChoice choice) {
    return result.other_answers.at(static_cast<std::size_t>(choice));
}

}  // namespace

std::string sensitivityHtml(const AnalysisResult& result, Numbering& numbering) {
    if (result.participants < 2) return "";
    std::vector<OtherChoice> choices;
    for (const OtherChoice& one : other_choices)
        if (countsOf(result, one.choice).answers != result.headline_answers.answers) choices.push_back(one);
    std::string rows;
    bool any = false;
    for (const SensitivityResult& one : result.sensitivity) {
        const AdjustedTest& head = one.headline;
        if (head.test.n_pairs == 0 && one.other(AnswerChoice::with_left_out).test.test.n_pairs == 0) continue;
        const auto cell = [&](const std::optional<double>& p_holm, bool changes) {
            return decided(p_holm, result.alpha, changes);
        };
        bool hangs = head.depends_on_zeros || head.depends_on_approximation;
        std::string others;
        for (const OtherChoice& choice : choices) {
            const SensitivityResult::Other& other = one.other(choice.choice);
            hangs = hangs || other.changes;
            others += cell(other.test.p_holm, other.changes);
        }
        any = any || hangs;
        rows += fmt::format(
            "<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td class=\"text\">{}</td>{}{}{}{}"
            "<td class=\"text\">{}</td></tr>",
            escapeHtml(capitalised(one.measure)), escapeHtml(one.a), escapeHtml(one.b),
            cell(head.p_holm, false), cell(head.p_holm_pratt, head.depends_on_zeros),
            cell(head.p_holm_normal, head.depends_on_approximation), others, hangs ? "<b>yes</b>" : "no");
    }
    if (rows.empty()) return "";
    std::string caption = fmt::format(
        "The pairs of systems, p after Holm's correction: as in the headline ({}); with differences of zero "
        "ranked (Pratt); with the normal approximation",
        countsText(result.headline_answers));
    std::string columns;
    for (const OtherChoice& one : choices) {
        caption += fmt::format("; {} ({})", one.words, countsText(countsOf(result, one.choice)));
        columns += fmt::format("<th>{}</th>", one.column);
    }
    std::string out =
        "<h2>Decisions under other choices</h2>" +
        openTable(units::means, caption + ".",
                  fmt::format("<th>Measure</th><th class=\"text\">A</th><th class=\"text\">B</th>"
                              "<th>headline</th><th>Pratt</th><th>normal</th>{}<th class=\"text\">Depends "
                              "on it</th>",
                              columns),
                  numbering, TableWidth::dense) +
        rows + close_table;
    out += any ? fmt::format(
                     "<p class=\"small\">Where a decision at &#945;&#160;=&#160;{} would be another, "
                     "(yes) or (no) tells whether it is significant there.</p>",
                     result.alpha)
               : "<p class=\"small\">No decision depends on any of these choices.</p>";
    if (choices.empty())
        out +=
            "<p class=\"small\">No answers are left out by exclusion, and none are in doubt: no trial was "
            "marked, no participant failed a check, every choice was made.</p>";
    return out;
}

}  // namespace deixis::results
