#include "store_differences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "studies/study_file/stage_kind.hpp"

namespace deixis::results {

namespace {

std::vector<std::string> column(SQLite::Database& database, const char* sql) {
    std::vector<std::string> out;
    SQLite::Statement query(database, sql);
    while (query.executeStep()) out.push_back(query.getColumn(0).getString());
    return out;
}

void compare(std::vector<std::string>& differences, const char* what, const std::string& kept,
             const std::string& given) {
    if (kept != given)
        differences.push_back(fmt::format("{} is kept as {}, given as {}", what, kept.empty() ? "none" : kept,
                                          given.empty() ? "none" : given));
}

std::string stageText(const studies::Stage& stage) {
    return fmt::format("{} ({})", stage.name, studies::stageKindName(stage.kind));
}

template <typename Things, typename Name>
std::string joined(const Things& things, const Name& name) {
    std::vector<std::string> names;
    for (const auto& thing : things) names.push_back(name(thing));
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string joined(const std::vector<std::string>& texts) {
    return fmt::format("{}", fmt::join(texts, ", "));
}

std::string groupsText(const studies::Groups& groups) {
    std::vector<std::string> out;
    for (const auto& [factor, level] : groups) out.push_back(factor + "=" + level);
    return joined(out);
}

/// The first line that is not the same in both texts.
void compareLines(std::vector<std::string>& differences, const std::string& kept, const std::string& given) {
    std::istringstream kept_lines(kept);
    std::istringstream given_lines(given);
    std::string a;
    std::string b;
    for (int line = 1;; ++line) {
        const bool more_a = static_cast<bool>(std::getline(kept_lines, a));
        const bool more_b = static_cast<bool>(std::getline(given_lines, b));
        if (!more_a && !more_b) return;
        if (!more_a) a.clear();
        if (!more_b) b.clear();
        if (more_a == more_b && a == b) continue;
        constexpr std::size_t longest = 60;
        differences.push_back(fmt::format("line {} of the study file is kept as '{}', given as '{}'", line,
                                          a.substr(0, longest), b.substr(0, longest)));
        return;
    }
}

std::string position(const Vec3& p) {
    return fmt::format("({}, {}, {})", p.x, p.y, p.z);
}

/// A trial in words, with all that is fixed in it.
std::string trialText(const studies::Trial& trial) {
    std::string out = fmt::format("{} {}", trial.stage, studies::stageKindName(trial.kind));
    if (trial.practice) out += fmt::format(", attempt {}", trial.attempt + 1);
    if (studies::declarationOf(trial.kind).in_pages) out += fmt::format(", page {}", trial.page + 1);
    for (const auto& stimulus : trial.stimuli) {
        out += fmt::format(", {} {}", stimulus.system, stimulus.item);
        if (stimulus.clip > 0) out += fmt::format(" (clip {})", stimulus.clip + 1);
    }
    if (!trial.layout.empty()) out += ", " + trial.layout;
    if (!trial.distance.empty()) out += ", " + trial.distance;
    if (!trial.stimuli.empty()) out += ", target " + position(trial.target);
    for (const Vec3& distractor : trial.distractors) out += ", distractor " + position(distractor);
    if (!trial.ball_order.empty()) out += fmt::format(", balls {}", fmt::join(trial.ball_order, " "));
    if (trial.check)
        out += fmt::format(", {} check {} {} {}", studies::checkKindName(trial.check->kind),
                           trial.check->stimulus, trial.check->expected, trial.check->of_trial);
    return out;
}

}  // namespace

std::vector<std::string> studyDifferences(SQLite::Database& database, const studies::Study& study) {
    std::vector<std::string> out;
    const auto name = [](const auto& thing) { return thing.name; };
    compare(out, "the title", joined(column(database, "SELECT title FROM study")), study.title);
    compare(out, "the list of stages",
            joined(column(database, "SELECT name || ' (' || kind || ')' FROM stages ORDER BY position")),
            joined(study.stages, stageText));
    compare(out, "the list of systems",
            joined(column(database, "SELECT name FROM systems ORDER BY position")),
            joined(study.systems, name));
    compare(out, "the list of layouts",
            joined(column(database, "SELECT name FROM layouts ORDER BY position")),
            joined(study.layouts, name));
    compare(out, "the list of distances",
            joined(column(database, "SELECT name FROM distances ORDER BY position")),
            joined(study.distances, name));
    const auto source = column(database, "SELECT source FROM study WHERE source IS NOT NULL");
    if (!source.empty() && !study.source.empty()) compareLines(out, source.front(), study.source);
    return out;
}

std::vector<std::string> planDifferences(const studies::StudyPlan& kept, const studies::StudyPlan& given) {
    std::vector<std::string> out;
    compare(out, "the number", std::to_string(kept.number), std::to_string(given.number));
    compare(out, "the seed", std::to_string(kept.seed), std::to_string(given.seed));
    compare(out, "the study file's hash", kept.study_hash.substr(0, 12), given.study_hash.substr(0, 12));
    compare(out, "the groups", groupsText(kept.groups), groupsText(given.groups));
    compare(out, "the list of stages", joined(kept.stages), joined(given.stages));
    compare(out, "the number of trials", std::to_string(kept.trials.size()),
            std::to_string(given.trials.size()));
    constexpr int max = 3;
    int different = 0;
    for (std::size_t i = 0; i < std::min(kept.trials.size(), given.trials.size()); ++i) {
        const std::string a = trialText(kept.trials[i]);
        const std::string b = trialText(given.trials[i]);
        if (a != b && ++different <= max)
            out.push_back(fmt::format("trial {} is kept as '{}', given as '{}'", i, a, b));
    }
    if (different > max) out.push_back(fmt::format("{} further trials differ", different - max));
    return out;
}

std::string listed(const std::vector<std::string>& differences) {
    return differences.empty() ? "" : fmt::format(": {}", fmt::join(differences, "; "));
}

}  // namespace deixis::results
