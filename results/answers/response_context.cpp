#include "response_context.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "results/database/counted_participants.hpp"
#include "results/database/game_values.hpp"

namespace deixis::results {

void addLevel(std::vector<Factor>& factors, const std::string& name, const std::string& level) {
    auto factor =
        std::find_if(factors.begin(), factors.end(), [&](const Factor& known) { return known.name == name; });
    if (factor == factors.end()) factor = factors.insert(factors.end(), {name, {}});
    if (std::find(factor->levels.begin(), factor->levels.end(), level) == factor->levels.end())
        factor->levels.push_back(level);
}

namespace {

using nlohmann::json;
using SQLite::Statement;

void readGroups(SQLite::Database& database, ResponseTable& table) {
    Statement groups(database, "SELECT participant, factor, level FROM participant_groups ORDER BY 2, 3, 1");
    while (groups.executeStep()) {
        const std::string factor = groups.getColumn(1).getString();
        const std::string level = groups.getColumn(2).getString();
        addLevel(table.between, factor, level);
        table.groups[groups.getColumn(0).getString()][factor] = level;
    }
}

/// Factors nested in the systems, which are within participants where these meet several systems.
void readSystemFactors(SQLite::Database& database, ResponseTable& table) {
    std::map<std::string, std::map<std::string, std::string>> of_system;
    Statement systems(database, "SELECT name, levels, generator IS NOT NULL FROM systems ORDER BY position");
    while (systems.executeStep()) {
        const std::string name = systems.getColumn(0).getString();
        if (std::find(table.systems.begin(), table.systems.end(), name) == table.systems.end()) continue;
        if (systems.getColumn(2).getInt() != 0) table.built_in_systems.push_back(name);
        const json levels = json::parse(systems.getColumn(1).getString());
        for (const auto& [factor, level] : levels.items()) {
            of_system[name][factor] = level.get<std::string>();
            addLevel(table.within, factor, level.get<std::string>());
        }
    }
    for (auto* rows : {&table.rows, &table.left_out_rows, &table.skipped_rows})
        for (ResponseRow& row : *rows)
            for (const Factor& factor : table.within)
                row.within.push_back(of_system[row.system][factor.name]);
}

/// A trial is in doubt where it was interrupted, and where the participant stood off the layout's place.
void readMarks(SQLite::Database& database, ResponseTable& table) {
    std::map<std::pair<std::string, int>, std::string> marks;
    const auto mark = [&](Statement& rows) {
        while (rows.executeStep()) {
            std::string& why = marks[{rows.getColumn(0).getString(), rows.getColumn(1).getInt()}];
            why += (why.empty() ? "" : ", ") + rows.getColumn(2).getString();
        }
    };
    Statement interrupted(database,
                          "SELECT participant, trial_index, 'interrupted' FROM responses WHERE superseded IS "
                          "NULL AND (pauses > 0 OR begun_before)");
    mark(interrupted);
    Statement off_place(database,
                        "SELECT DISTINCT r.participant, r.trial_index, 'off place' FROM events AS v JOIN "
                        "responses AS r ON r.session = v.session AND r.trial_index = v.trial_index WHERE "
                        "r.superseded IS NULL AND v.kind = 'off_place'");
    mark(off_place);
    for (auto* rows : {&table.rows, &table.left_out_rows, &table.skipped_rows})
        for (ResponseRow& row : *rows)
            if (const auto found = marks.find({row.participant, row.trial}); found != marks.end())
                row.marked = found->second;
}

void readParticipants(SQLite::Database& database, const std::string& people, ResponseTable& table) {
    Statement failed(database,
                     fmt::format("SELECT DISTINCT r.participant FROM responses AS r JOIN {} AS p ON p.id = "
                                 "r.participant WHERE r.superseded IS NULL AND r.check_passed = 0 AND "
                                 "p.status = 'active'",
                                 people));
    while (failed.executeStep()) table.failed_checks.insert(failed.getColumn(0).getString());
    std::set<std::string> declined;
    // Who declined and agreed later has agreed.
    Statement consents(database, "SELECT id FROM participants WHERE " + declinedConsent("participants.id"));
    while (consents.executeStep()) declined.insert(consents.getColumn(0).getString());
    std::erase_if(table.left_out_rows,
                  [&](const ResponseRow& row) { return declined.contains(row.participant); });
}

double smallestOf(const json& angles) {
    const auto all = angles.get<std::vector<double>>();
    return *std::min_element(all.begin(), all.end());
}

void readBalls(SQLite::Database& database, const std::string& people, ResponseTable& table) {
    Statement rows(
        database,
        fmt::format(
            "SELECT r.participant, s.system, t.target_id, g.balls, g.target_place, h.chosen_place, "
            "r.head_x_m, r.head_z_m, CASE WHEN e.synthetic THEN 'simulated' ELSE e.station END, t.angles, "
            "t.layout "
            "FROM responses AS r JOIN sessions AS e ON e.id = r.session JOIN {} AS p ON p.id = r.participant "
            "JOIN trials AS t ON t.participant = r.participant AND t.trial_index = r.trial_index "
            "{}JOIN trial_stimuli AS s ON s.participant = r.participant AND s.trial_index = "
            "r.trial_index AND s.position = 0 WHERE r.superseded IS NULL AND p.status = 'active' AND "
            "s.scored AND h.chosen_place IS NOT NULL ORDER BY r.participant, r.trial_index",
            people, game_values));
    while (rows.executeStep()) {
        ChoiceRow& choice = table.choices.emplace_back(
            ChoiceRow{rows.getColumn(0).getString(), rows.getColumn(1).getString(),
                      rows.getColumn(2).getString(), positionsOf(rows.getColumn(3).getString()),
                      rows.getColumn(4).getInt(), rows.getColumn(5).getInt(), rows.getColumn(6).getDouble(),
                      rows.getColumn(7).getDouble(), rows.getColumn(8).getString()});
        choice.layout = rows.getColumn(10).getString();
        if (rows.getColumn(9).isNull()) continue;
        const json angles = json::parse(rows.getColumn(9).getString());
        choice.avatar_angle_deg = smallestOf(angles.at("avatar"));
        choice.participant_angle_deg =
            smallestOf(angles.at(choice.station == "headset" ? "headset" : "desktop"));
    }
}

void readTargets(SQLite::Database& database, ResponseTable& table) {
    const auto measured = [](const Measure& measure) { return !measure.unit.empty(); };
    if (std::none_of(table.measures.begin(), table.measures.end(), measured)) return;
    Statement targets(
        database,
        "SELECT DISTINCT target_id, target_x_m, target_y_m, target_z_m FROM trials WHERE target_id IS "
        "NOT NULL AND target_x_m IS NOT NULL");
    while (targets.executeStep())
        table.target_positions[targets.getColumn(0).getString()] = {targets.getColumn(1).getDouble(),
                                                                    targets.getColumn(2).getDouble(),
                                                                    targets.getColumn(3).getDouble()};
}

}  // namespace

void readResponseContext(SQLite::Database& database, const std::string& people, ResponseTable& table) {
    readGroups(database, table);
    readSystemFactors(database, table);
    readMarks(database, table);
    readParticipants(database, people, table);
    readBalls(database, people, table);
    readTargets(database, table);
}

}  // namespace deixis::results
