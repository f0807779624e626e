#include "synthetic_motion.hpp"

#include <fmt/format.h>

#include "results/answers/motion_origin.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/page/html_table.hpp"

namespace deixis::results {

std::string syntheticMotionText(const ResponseTable& table) {
    std::vector<std::string> by_rules, learned, either;
    for (const auto& [system, motion] : syntheticSystems(table))
        (motion == "synthetic"                ? by_rules
         : motion == "learned from synthetic" ? learned
                                              : either)
            .push_back(escapeHtml(system));
    std::string out;
    if (!either.empty())
        out += fmt::format(
            "The motion of {} is synthetic: this program made it, by formulas or by what was learned from "
            "demonstrations that follow them. ",
            inSentence(either));
    if (!by_rules.empty())
        out += fmt::format(
            "The motion of {} is synthetic: rules or formulas made it, and it is no recording of a "
            "person. ",
            inSentence(by_rules));
    if (!learned.empty())
        out += fmt::format(
            "The motion of {} was made by {} that learned from synthetic demonstrations, which rules or "
            "formulas made. ",
            inSentence(learned), learned.size() == 1 ? "a system" : "systems");
    if (out.empty()) return "";
    return out +
           "Answers about it say nothing about recorded motion, or about a method that was trained on it.";
}

std::string systemWithMotion(const ResponseTable& table, const std::string& system) {
    const std::string motion = motionText(table, system);
    return escapeHtml(system) + (motion.empty() ? "" : " (" + motion + ")");
}

Section notComparedSection(const AnalysisResult& result, Numbering& numbering) {
    if (result.not_compared.empty()) return {};
    std::vector<std::string> why;
    for (const SystemResult& one : result.not_compared)
        why.push_back(fmt::format("{}: {}", strongHtml(one.system),
                                  escapeHtml(result.table.not_compared.at(one.system))));
    Table table = tables::notCompared(result);
    for (Table::Row& row : table.rows) {
        Cell& name = row.cells[table.at("system")];
        if (const std::string motion = motionText(result.table, name.text()); !motion.empty())
            name = fmt::format("{} ({})", name.text(), motion);
    }
    return {
        "Shown, but not compared",
        paragraphHtml(
            "The study does not compare these systems: they are in no test, ranking or figure of this "
            "report.") +
            itemsHtml(why) +
            tableHtml(table, "Means of the systems that are not compared, over participants.",
                      {"measure", "system", "mean", "interval", "sd_participants", "sd_trials", "answers"},
                      numbering)};
}

}  // namespace deixis::results
