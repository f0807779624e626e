#include "results/store/shown_choices.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "results/database/counted_participants.hpp"
#include "results/database/database_open.hpp"

namespace deixis::results {

namespace {

ShownChoices readShown(SQLite::Database& database) {
    ShownChoices out;
    out.study_source = database.execAndGet("SELECT coalesce(source, '') FROM study").getString();
    SQLite::Statement rows(
        database,
        fmt::format(
            "SELECT r.participant, s.system, s.item, t.layout, b.text, g.value, h.value, "
            "r.head_x_m, r.head_y_m, r.head_z_m, c.clip_file, c.clip_hash, e.avatar_hash, s.clip "
            "FROM responses AS r JOIN {} AS p ON p.id = r.participant "
            "JOIN sessions AS e ON e.id = r.session "
            "JOIN trials AS t ON t.participant = r.participant AND t.trial_index = r.trial_index "
            "JOIN trial_values AS b ON b.participant = r.participant AND b.trial_index = r.trial_index AND "
            "b.name = 'balls' JOIN trial_values AS g ON g.participant = r.participant AND g.trial_index = "
            "r.trial_index AND g.name = 'target_place' "
            "JOIN response_values AS h ON h.response = r.id AND h.name = 'chosen_place' "
            "JOIN trial_stimuli AS s ON s.participant = r.participant AND s.trial_index = r.trial_index AND "
            "s.position = 0 "
            "JOIN response_stimuli AS c ON c.response = r.id AND c.position = 0 "
            "WHERE r.superseded IS NULL AND p.status = 'active' AND s.scored "
            "ORDER BY r.participant, r.trial_index",
            effectiveParticipants()));
    while (rows.executeStep()) {
        ShownChoice& one = out.choices.emplace_back();
        one.participant = rows.getColumn(0).getString();
        one.stimulus = {rows.getColumn(1).getString(), rows.getColumn(2).getString(),
                        rows.getColumn(13).getInt()};
        one.layout = rows.getColumn(3).getString();
        for (const auto& ball : nlohmann::json::parse(rows.getColumn(4).getString()))
            one.balls.emplace_back(ball.at(0).get<double>(), ball.at(1).get<double>(),
                                   ball.at(2).get<double>());
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
