// What was chosen in the game, and where.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "angles.hpp"
#include "figures.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/outputs/observers_html.hpp"
#include "results/page/html_table.hpp"
#include "sections.hpp"

namespace deixis::results {

namespace {

std::string roleHeading(const std::string& role) {
    if (role == "left" || role == "right") return fmt::format("{} of it", role);
    return role;
}

std::string confusionTable(const AnalysisResult& result, Numbering& numbering) {
    std::vector<std::string> roles;
    for (const ConfusionResult& one : result.confusion)
        if (std::find(roles.begin(), roles.end(), one.role) == roles.end()) roles.push_back(one.role);
    // Systems whose trials had fewer balls do not decide the order.
    std::stable_partition(roles.begin(), roles.end(),
                          [](const std::string& role) { return role != "left" && role != "right"; });
    const Table all = tables::confusion(result);
    const auto share = [chosen = all.at("chosen"), shown = all.at("shown")](const Table::Row& row) -> Cell {
        const auto times = *row.cells[chosen].as<long long>();
        const auto of = *row.cells[shown].as<long long>();
        return fmt::format("{:.1f}\u00a0% ({} of {})",
                           100.0 * static_cast<double>(times) / static_cast<double>(of), times, of);
    };
    return tableHtml(
        wide(all, {"system"}, "role", roles, {{roleHeading, share}}),
        "Which balls were chosen: how often, of how many such balls that were shown. \"nearest 1\" is the "
        "distractor "
        "nearest to the target; left and right are a distractor's side of the target, as seen from where the "
        "participant's head was.",
        numbering, dense_table);
}

std::string targetTable(const AnalysisResult& result, Numbering& numbering) {
    std::vector<std::string> systems{"all"};
    systems.insert(systems.end(), result.table.systems.begin(), result.table.systems.end());
    Table all = tables::targetSpace(result);
    all.column("item").label = "Target";
    const auto right = [mean = all.at("mean"), n = all.at("n")](const Table::Row& row) -> Cell {
        const auto of = *row.cells[n].as<long long>();
        return fmt::format("{:.0f} of {}", *row.cells[mean].as<double>() * static_cast<double>(of), of);
    };
    const auto name = [](const std::string& system) { return system; };
    return folded(
        "Correct choices by the target's place",
        tableHtml(wide(all, {"item", "x_m", "y_m", "z_m"}, "system", systems, {{name, right}}),
                  "Correct choices of all for each target; centres in metres in the avatar's frame, x to its "
                  "left, y up, z ahead.",
                  numbering));
}

std::string driftTable(const AnalysisResult& result, Numbering& numbering) {
    if (result.drift.empty()) return "";
    return tableHtml(
        tables::drift(result),
        "Choices and arms that keep moving during the hold: how often the chosen ball was the one nearest to "
        "a line of the arm when the hold begins, and when it ends; then the same for choices in which these "
        "are two balls. arm-finger: from the elbow through the fingertip; eye-fingertip: from the "
        "avatar's eye. The hold is detected in the clip as a simulated participant detects it.",
        numbering, dense_table);
}

}  // namespace

Section choicesSection(const AnalysisResult& result, Numbering& figures, Numbering& numbering) {
    if (result.confusion.empty()) return {};
    // One after another: the tables count.
    std::string out = confusionTable(result, numbering);
    out += driftTable(result, numbering);
    out += observersTable(result.observers, "choices", numbering);
    out += anglesHtml(result, figures, numbering);
    if (!result.target_space.empty()) out += figuresPlaced(figureHtml(placesFigure(result, figures)));
    return {"Which balls were chosen, and where", out + targetTable(result, numbering)};
}

}  // namespace deixis::results
