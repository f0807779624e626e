#include "results/store/shown_choices.hpp"

#include <fmt/core.h>

#include "results/database/counted_participants.hpp"
#include "results/database/database_open.hpp"
#include "results/database/game_values.hpp"

namespace deixis::results {

namespace {

ShownChoices readShown(SQLite::Database& database) {
    ShownChoices out;
    out.study_source = database.execAndGet("SELECT coalesce(source, '') FROM study").getString();
    SQLite::Statement rows(
        database,
        fmt::format(
            "SELECT r.participant, s.system, s.item, t.layout, g.balls, g.target_place, h.chosen_place, "
            "r.head_x_m, r.head_y_m, r.head_z_m, c.clip_file, c.clip_hash, e.avatar_hash, s.clip "
            "FROM responses AS r JOIN {} AS p ON p.id = r.participant "
            "JOIN sessions AS e ON e.id = r.session "
            "JOIN trials AS t ON t.participant = r.participant AND t.trial_index = r.trial_index "
            "{}JOIN trial_stimuli AS s ON s.participant = r.participant AND s.trial_index = r.trial_index "
            "AND "
            "s.position = 0 "
            "JOIN response_stimuli AS c ON c.response = r.id AND c.position = 0 "
            "WHERE r.superseded IS NULL AND p.status = 'active' AND s.scored AND h.chosen_place IS NOT NULL "
            "ORDER BY r.participant, r.trial_index",
            effectiveParticipants(), game_values));
    while (rows.executeStep()) {
        ShownChoice& one = out.choices.emplace_back();
        one.participant = rows.getColumn(0).getString();
        one.stimulus = {rows.getColumn(1).getString(), rows.getColumn(2).getString(),
                        rows.getColumn(13).getInt()};
        one.layout = rows.getColumn(3).getString();
        one.balls = positionsOf(rows.getColumn(4).getString());
        one.target_place = rows.getColumn(5).getInt();
        one.chosen_place = rows.getColumn(6).getInt();
        one.head_m = {rows.getColumn(7).getDouble(), rows.getColumn(8).getDouble(),
                      rows.getColumn(9).getDouble()};
        one.clip = {rows.getColumn(10).getString(), rows.getColumn(11).getString()};
        one.avatar_hash = rows.getColumn(12).getString();
    }
    return out;
}

}  // namespace

Result<ShownChoices> loadShownChoices(const std::filesystem::path& database) {
    return readDatabase(database,
                        [](SQLite::Database& opened) -> Result<ShownChoices> { return readShown(opened); });
}

}  // namespace deixis::results
