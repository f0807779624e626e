#include "sections.hpp"

#include "participants.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/page/html_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

namespace deixis::results {

namespace {

std::string chanceTable(const AnalysisResult& result, Numbering& numbering) {
    if (result.chance.empty()) return "";
    const Measure accuracy = measureOf(result, "accuracy");
    Table table = tables::chance(result);
    if (result.participants < 2)
        for (Table::Row& row : table.rows)
            for (const char* column : {"p", "p_holm"}) row.cells[table.at(column)] = {};
    return tableHtml(
        table,
        fmt::format(
            "Correct choices of each system, over all participants{}.",
            accuracy.balls > 1
                ? fmt::format(", and against chance ({}): signed-rank tests of participants' means of "
                              "correct choices minus each trial's chance level. n counts participants",
                              ballsText(accuracy))
                : ""),
        {"system", "successes", "choices", "estimate", "chance", "mean_above", "n", "p", "p_holm"},
        numbering);
}

std::string orderTable(const AnalysisResult& result, Numbering& numbering) {
    if (result.order.empty() || result.participants < 2) return "";
    return tableHtml(
        tables::order(result),
        "Answers over the course of the study: first and second half of each participant's answers, "
        "signed-rank test over participants, Holm over the measures.",
        {"measure", "first_half", "second_half", "n", "p", "p_holm"}, numbering);
}

std::string itemsTable(const AnalysisResult& result, Numbering& numbering) {
    constexpr std::size_t max_shown = 5;
    const Table all = tables::items(result);
    Table table{all.name, all.unit, "", all.columns};
    table.columns.push_back({"end", ColumnKind::text});
    table.columns.back().label = "";
    for (const Measure& measure : result.measures) {
        const Table items = all.where("measure", measure.name);
        const std::size_t n = items.rows.size();
        const std::size_t shown = std::min(max_shown, n / 2);
        for (std::size_t i = 0; i < n; ++i)
            if (i < shown || i >= n - shown)
                table.rows.emplace_back(items.rows[i]).cells.emplace_back(i < shown ? "lowest" : "highest");
    }
    if (table.rows.empty()) return "";
    return tableHtml(
        table,
        "Items with the lowest and the highest means, over systems and participants. All of them: --csv.",
        {"measure", "end", "item", "mean", "answers"}, numbering);
}

}  // namespace

Section descriptivesSection(const AnalysisResult& result, Numbering& numbering) {
    // One after another: the tables count.
    std::string html = chanceTable(result, numbering);
    if (!result.unanswered.empty())
        html += tableHtml(tables::unanswered(result),
                          "Choices that were not made. A choice that timed out counts as wrong; one that the "
                          "experimenter skipped is left out. Accuracy (means of participants' means) in this "
                          "way, over the choices actually made, and with all others as wrong.",
                          numbering);
    html += orderTable(result, numbering);
    if (!result.times.empty())
        html += tableHtml(tables::responseTimes(result), "Response times over answers, seconds.",
                          {"measure", "system", "q25_s", "median_s", "q75_s", "n"}, numbering);
    html += timeTestsHtml(result, numbering);
    html += itemsTable(result, numbering);
    return {"Chance, order, time and items", html};
}

Section presenceSection(const AnalysisResult& result, Numbering& numbering) {
    bool even = true;
    for (std::size_t m = 0; m < result.measures.size(); ++m)
        for (const PresenceRow& row : result.presence)
            for (const int answers : row.answers[m])
                even = even && answers == result.presence.front().answers[m].front();
    if (even) return {};
    Table table{
        "presence", units::answers, "", {{"participant", ColumnKind::text, {.label = "Participant"}}}};
    TableLook look;
    for (const Measure& measure : result.measures) {
        look.over.emplace_back(capitalised(measure.name), result.systems.size());
        for (const SystemResult& system : result.systems) {
            table.columns.emplace_back(fmt::format("answers {}", table.columns.size()), ColumnKind::number);
            table.columns.back().label = system.system;
        }
    }
    for (const PresenceRow& row : result.presence) {
        Table::Row& out = table.rows.emplace_back(Table::Row{{row.participant}});
        for (const auto& of_measure : row.answers)
            for (const int answers : of_measure) {
                if (answers == 0) out.marks.emplace_back(out.cells.size(), "missing");
                out.cells.push_back(answers > 0 ? Cell(answers) : Cell("none"));
            }
    }
    return {"Who answered what",
            tableHtml(table, "Answers of each participant on each system.", numbering, look)};
}

}  // namespace deixis::results
