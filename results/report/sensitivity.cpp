// Decisions beside those of other choices.
#include <fmt/core.h>

#include "results/outputs/analysis_tables.hpp"
#include "results/page/html_table.hpp"
#include "results/page/page.hpp"
#include "sections.hpp"

namespace deixis::results {

namespace {

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
    {AnswerChoice::unanswered_wrong, "skipped as wrong", "with skipped choices as wrong"}};

const AnswerCounts& countsOf(const AnalysisResult& result, AnswerChoice choice) {
    return result.other_answers.at(static_cast<std::size_t>(choice));
}

}  // namespace

Section sensitivitySection(const AnalysisResult& result, Numbering& numbering) {
    if (result.participants < 2) return {};
    std::vector<OtherChoice> choices;
    for (const OtherChoice& one : other_choices)
        if (countsOf(result, one.choice).answers != result.headline_answers.answers) choices.push_back(one);
    std::vector<std::string> names{"headline", "pratt", "normal"};
    for (const OtherChoice& one : choices) names.emplace_back(nameOf(one.choice));
    const Table all = tables::sensitivity(result);
    const auto label = [&](const std::string& name) {
        for (const OtherChoice& one : choices)
            if (name == nameOf(one.choice)) return std::string(one.column);
        return name == "pratt" ? std::string("Pratt") : name;
    };
    const auto decided = [&](const Table::Row& row) -> Cell {
        const Cell& p_holm = row.cells[all.at("p_holm")];
        if (p_holm.empty()) return {};
        std::string out = pWords(*p_holm.as<double>());
        if (*row.cells[all.at("changes")].as<bool>())
            out += *row.cells[all.at("significant")].as<bool>() ? " (yes)" : " (no)";
        return out;
    };
    Table table = wide(all, {"measure", "a", "b"}, "choice", names, {{label, decided}});
    table.columns.push_back({"depends", ColumnKind::text, {.label = "Depends on it"}});
    bool any = false;
    for (Table::Row& row : table.rows) {
        bool hangs = false;
        for (std::size_t i = 3; i < row.cells.size(); ++i)
            if (row.cells[i].text().ends_with(')')) {
                hangs = true;
                row.marks.emplace_back(i, "sig");
            }
        any = any || hangs;
        if (hangs) row.marks.emplace_back(row.cells.size(), "sig");
        row.cells.emplace_back(hangs ? "yes" : "no");
    }
    std::size_t place = 0;
    std::erase_if(table.rows, [&](const Table::Row&) {
        const SensitivityResult& one = result.sensitivity[place++];
        return one.headline.test.n_pairs == 0 &&
               one.other(AnswerChoice::with_left_out).test.test.n_pairs == 0;
    });
    if (table.rows.empty()) return {};
    std::string caption = fmt::format(
        "The pairs of systems, p after Holm's correction: as in the headline ({}); with differences of zero "
        "ranked (Pratt); with the normal approximation",
        countsText(result.headline_answers));
    for (const OtherChoice& one : choices)
        caption += fmt::format("; {} ({})", one.words, countsText(countsOf(result, one.choice)));
    std::string out = tableHtml(table, caption + ".", numbering, dense_table);
    out += noteHtml(any ? fmt::format("If a decision at \u03b1\u00a0=\u00a0{} would differ, (yes) or (no) "
                                      "says whether it is significant there.",
                                      result.alpha)
                        : "No decision depends on any of these choices.");
    if (choices.empty())
        out += noteHtml(
            "No answers are left out by exclusion, and none are doubtful: no trial was marked, no "
            "participant failed a "
            "check, every choice was made.");
    return {"Decisions under other choices", out};
}

}  // namespace deixis::results
