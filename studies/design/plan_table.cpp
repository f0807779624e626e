// The plan for people: a table, one line a trial.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "studies/design/plan.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::studies {

namespace {

std::string joined(const std::vector<std::string>& texts, std::string_view by) {
    return fmt::format("{}", fmt::join(texts, by));
}

/// A row of the table for people.
using Row = std::array<std::string, 8>;

Row tableRow(const Trial& trial) {
    std::vector<std::string> systems;
    for (const Stimulus& stimulus : trial.stimuli)
        systems.push_back(stimulus.clip == 0
                              ? stimulus.system
                              : fmt::format("{} (clip {})", stimulus.system, stimulus.clip + 1));
    std::string role = "page";
    if (trial.practice)
        role = trial.attempt == 0 ? "practice" : fmt::format("practice, attempt {}", trial.attempt + 1);
    else if (trial.check)
        role = checkKindName(trial.check->kind);
    else if (!trial.stimuli.empty())
        role = "scored";
    if (declarationOf(trial.kind).in_pages) role = fmt::format("page {}", trial.page + 1);

    std::string shown;
    if (const int place = trial.targetPlace(); place >= 0)
        shown = fmt::format("target is ball {} of {}", place + 1, trial.ball_order.size());
    if (trial.check && trial.check->kind == CheckKind::number)
        shown = fmt::format("asks for {} with {}", trial.check->expected,
                            systems[static_cast<std::size_t>(trial.check->stimulus)]);
    if (trial.check && trial.check->kind == CheckKind::repeat)
        shown += fmt::format("{}trial {} again", shown.empty() ? "" : ", ", trial.check->of_trial);
    const auto orDash = [](std::string text) { return text.empty() ? std::string("-") : text; };
    return {fmt::format("{}", trial.index),
            trial.stage,
            role,
            orDash(joined(systems, " | ")),
            trial.stimuli.empty() ? "-" : trial.stimuli.front().item,
            orDash(trial.layout),
            orDash(trial.distance),
            orDash(shown)};
}

}  // namespace

std::string planTable(const StudyPlan& plan) {
    std::vector<Row> rows{{"trial", "stage", "role", "system", "item", "layout", "distance", "shown"}};
    for (const Trial& trial : plan.trials) rows.push_back(tableRow(trial));
    std::array<std::size_t, std::tuple_size_v<Row>> widths{};
    for (const Row& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());

    const std::string in_cell =
        plan.number_in_cell ? fmt::format(", {} in its groups", *plan.number_in_cell) : "";
    std::string out = fmt::format("participant {} (number {}{}), study {}, seed {}\n", plan.participant,
                                  plan.number, in_cell, plan.study_name, plan.seed);
    for (const auto& group : plan.groups) out += fmt::format("{}: {}\n", group.first, group.second);
    for (const Row& row : rows) {
        std::string line = fmt::format("{:>{}}", row[0], widths[0]);
        for (std::size_t i = 1; i < row.size(); ++i) line += fmt::format("  {:<{}}", row[i], widths[i]);
        line.erase(line.find_last_not_of(' ') + 1);
        out += line + '\n';
    }
    return out;
}

}  // namespace deixis::studies
