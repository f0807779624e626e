#include "participant_fields.hpp"

#include <fmt/core.h>

namespace deixis::results {

void readParticipantFields(SQLite::Database& database, const std::string& people, ResponseTable& table) {
    SQLite::Statement fields(
        database,
        fmt::format(
            "SELECT f.participant, f.field, f.value, f.text, q.kind FROM participant_fields AS f JOIN "
            "{} AS p ON p.id = f.participant JOIN questions AS q ON q.question = f.field JOIN stages "
            "AS s ON s.name = q.stage WHERE p.status = 'active' AND q.kind IN ('number', 'scale', "
            "'choice') GROUP BY f.participant, f.field ORDER BY min(100 * s.position + q.position), "
            "f.participant",
            people));
    while (fields.executeStep()) {
        FieldRow& row = table.fields.emplace_back();
        row.participant = fields.getColumn(0).getString();
        row.field = fields.getColumn(1).getString();
        if (fields.getColumn(4).getString() == "choice")
            row.option = fields.getColumn(3).getString();
        else if (!fields.getColumn(2).isNull())
            row.number = fields.getColumn(2).getDouble();
    }
    // A session that was cut off has no end but its last answer.
    SQLite::Statement sessions(
        database,
        fmt::format("SELECT s.participant, sum(coalesce(s.ended_utc_s, (SELECT max(r.answered_utc_s) FROM "
                    "responses AS r WHERE r.session = s.id)) - s.started_utc_s) / 60.0 FROM sessions AS s "
                    "JOIN {} AS p ON p.id = s.participant WHERE p.status = 'active' GROUP BY s.participant",
                    people));
    while (sessions.executeStep())
        if (!sessions.getColumn(1).isNull())
            table.session_minutes[sessions.getColumn(0).getString()] = sessions.getColumn(1).getDouble();
    SQLite::Statement stages(
        database,
        "SELECT c.stage, group_concat(c.name || c.items || c.reversed || c.mean || ' ' || c.factor || ' ' || "
        "c.offset_) FROM (SELECT * FROM scores ORDER BY stage, position) AS c JOIN stages AS g ON g.name = "
        "c.stage GROUP BY c.stage ORDER BY g.position");
    std::vector<std::string> definitions;
    while (stages.executeStep()) {
        const std::string definition = stages.getColumn(1).getString();
        std::size_t at = 0;
        while (at < definitions.size() && definitions[at] != definition) ++at;
        if (at == definitions.size()) {
            definitions.push_back(definition);
            table.repeated_questionnaires.emplace_back();
        }
        table.repeated_questionnaires[at].push_back(stages.getColumn(0).getString());
    }
    std::erase_if(table.repeated_questionnaires, [](const auto& same) { return same.size() < 2; });
}

}  // namespace deixis::results
