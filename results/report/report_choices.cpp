// What was chosen in the game, and where.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "report_angles.hpp"
#include "report_details.hpp"
#include "report_figures.hpp"
#include "results/outputs/observers_html.hpp"
#include "results/page/report_tables.hpp"

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
    std::string columns = "<th>System</th>";
    for (const std::string& role : roles) columns += "<th>" + roleHeading(role) + "</th>";
    std::string out = openTable(
        units::choices,
        "Which balls were chosen: how often, of how many such balls that were shown. \"nearest 1\" is the "
        "distractor nearest to the target; left and right are a distractor's side of the target, as seen "
        "from where the participant's head was.",
        columns, numbering, TableWidth::dense);
    for (const std::string& system : result.table.systems) {
        std::string cells;
        bool any = false;
        for (const std::string& role : roles) {
            const auto found = std::find_if(
                result.confusion.begin(), result.confusion.end(),
                [&](const ConfusionResult& one) { return one.system == system && one.role == role; });
            any = any || found != result.confusion.end();
            cells += found == result.confusion.end()
                         ? fmt::format("<td>{}</td>", dash)
                         : fmt::format("<td>{:.1f}&#160;% ({} of {})</td>",
                                       100.0 * found->chosen / found->shown, found->chosen, found->shown);
        }
        if (any) out += fmt::format("<tr><th scope=\"row\">{}</th>{}</tr>", escapeHtml(system), cells);
    }
    return out + close_table;
}

std::string targetTable(const AnalysisResult& result, Numbering& numbering) {
    using Place = std::tuple<std::string, double, double, double>;
    std::map<Place, std::map<std::string, const TargetPlace*>> places;
    for (const TargetPlace& one : result.target_space)
        places[{one.target_id, one.position_m.x, one.position_m.y, one.position_m.z}][one.system] = &one;
    std::vector<std::string> systems{"all"};
    systems.insert(systems.end(), result.table.systems.begin(), result.table.systems.end());
    std::string columns = "<th>Target</th><th>x</th><th>y</th><th>z</th>";
    for (const std::string& system : systems) columns += fmt::format("<th>{}</th>", escapeHtml(system));
    std::string out =
        "<details><summary>Correct choices by the target's place</summary>" +
        openTable(
            units::choices,
            "Correct choices of all for each target; centres in metres in the avatar's frame, x to its left, "
            "y up, z ahead.",
            columns, numbering);
    for (const auto& [place, of_place] : places) {
        const auto& [target, x, y, z] = place;
        out += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td>",
                           escapeHtml(target), signedText(fmt::format("{:.2f}", x)),
                           signedText(fmt::format("{:.2f}", y)), signedText(fmt::format("{:.2f}", z)));
        for (const std::string& system : systems) {
            const auto found = of_place.find(system);
            out += found == of_place.end()
                       ? fmt::format("<td>{}</td>", dash)
                       : fmt::format("<td>{:.0f} of {}</td>", found->second->mean * found->second->n,
                                     found->second->n);
        }
        out += "</tr>";
    }
    return out + close_table + "</details>";
}

std::string driftTable(const AnalysisResult& result, Numbering& numbering) {
    if (result.drift.empty()) return "";
    std::string out = openTable(
        units::choices,
        "Choices and arms that go on moving while they are held: how often the ball was chosen that is "
        "nearest to a line of the arm when the hold begins, and when it ends; then the same of the choices "
        "in which these are two balls. arm-finger: from the elbow through the fingertip; eye-fingertip: from "
        "the avatar's eye. The hold is found in the clip as a simulated participant finds it.",
        "<th>System</th><th class=\"text\">line</th><th>choices</th><th>nearest at first</th><th>at "
        "last</th><th>two balls</th><th>the first chosen</th><th>the last</th><th>another</th>",
        numbering, TableWidth::dense);
    for (const DriftResult& one : result.drift)
        out += fmt::format(
            "<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}"
            "</td><td>{}</td><td>{}</td><td>{}</td></tr>",
            escapeHtml(one.system), one.line, one.choices, one.of_first, one.of_last, one.moved,
            one.moved_first, one.moved_last, one.moved - one.moved_first - one.moved_last);
    return out + close_table;
}

}  // namespace

std::string choicesHtml(const AnalysisResult& result, Numbering& figures, Numbering& numbering) {
    if (result.confusion.empty()) return "";
    // One after another: the tables count.
    std::string out = "<h2>Which balls were chosen, and where</h2>" + confusionTable(result, numbering);
    out += driftTable(result, numbering);
    out += observersTable(result.observers, "choices", numbering);
    out += anglesHtml(result, figures, numbering);
    if (!result.target_space.empty())
        out += "<div class=\"plots\">" + figureHtml(placesFigure(result, figures)) + "</div>";
    return out + targetTable(result, numbering);
}

}  // namespace deixis::results
