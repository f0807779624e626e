#include "results/participants/participants.hpp"

#include <fmt/core.h>

#include <array>
#include <cstddef>
#include <optional>

#include "core/text.hpp"
#include "participants_change.hpp"
#include "results/database/counted_participants.hpp"
#include "results/database/database_open.hpp"

namespace deixis::results {

namespace {

/// In braces: effectiveParticipants().
constexpr const char* rows_format = R"sql(
SELECT p.id, p.number, p.language, p.status, coalesce(p.reason, ''),
       coalesce((SELECT max(synthetic) FROM sessions WHERE participant = p.id), 0),
       (SELECT count(*) FROM sessions WHERE participant = p.id),
       (SELECT count(*) FROM responses AS r WHERE participant = p.id AND superseded IS NULL AND NOT EXISTS
               (SELECT 1 FROM answers WHERE response = r.id AND question = 'consent' AND value = 0)),
       (SELECT count(*) FROM trials AS t WHERE participant = p.id AND (attempt = 0 OR EXISTS (SELECT 1 FROM
               responses AS r WHERE r.participant = p.id AND r.trial_index = t.trial_index AND
               r.superseded IS NULL))),
       (SELECT count(*) FROM responses WHERE participant = p.id AND superseded IS NULL AND check_passed = 0),
       coalesce((SELECT max(max(s.started_utc_s, coalesce(s.ended_utc_s, 0.0), coalesce(r.utc_s, 0.0)))
                   FROM sessions AS s LEFT JOIN (SELECT session, max(answered_utc_s) AS utc_s FROM responses
                        WHERE participant = p.id GROUP BY session) AS r ON r.session = s.id
                  WHERE s.participant = p.id), 0.0),
       (SELECT min(agreed) FROM consents AS c WHERE participant = p.id AND
               session = (SELECT max(session) FROM consents WHERE participant = p.id AND stage = c.stage))
  FROM {} AS p {} ORDER BY p.number
)sql";

/// Of everybody, or of one participant.
std::vector<ParticipantRow> readRows(SQLite::Database& database,
                                     const std::optional<std::string>& participant = std::nullopt) {
    std::vector<ParticipantRow> out;
    SQLite::Statement row(
        database, fmt::format(rows_format, effectiveParticipants(), participant ? "WHERE p.id = ?1" : ""));
    if (participant) row.bind(1, *participant);
    while (row.executeStep()) {
        ParticipantRow& one = out.emplace_back();
        one.id = row.getColumn(0).getString();
        one.number = row.getColumn(1).getInt();
        one.language = row.getColumn(2).getString();
        one.status = participantStatusNamed(row.getColumn(3).getString());
        one.reason = row.getColumn(4).getString();
        one.synthetic = row.getColumn(5).getInt() != 0;
        one.sessions = row.getColumn(6).getInt();
        one.answered = row.getColumn(7).getInt();
        one.planned = row.getColumn(8).getInt();
        one.checks_failed = row.getColumn(9).getInt();
        one.last_utc_s = row.getColumn(10).getDouble();
        if (!row.getColumn(11).isNull())
            one.consent = row.getColumn(11).getInt() != 0 ? Consent::agreed : Consent::declined;
        SQLite::Statement group(database,
                                "SELECT factor, level FROM participant_groups WHERE participant = ?");
        group.bind(1, one.id);
        while (group.executeStep())
            one.groups[group.getColumn(0).getString()] = group.getColumn(1).getString();
    }
    return out;
}

std::vector<std::pair<std::string, std::string>> readFields(SQLite::Database& database,
                                                            const std::string& participant) {
    SQLite::Statement row(
        database,
        "SELECT field, value, text FROM participant_fields WHERE participant = ? "
        "ORDER BY (SELECT min(100 * s.position + q.position) FROM questions AS q JOIN stages "
        "AS s ON s.name = q.stage WHERE q.question = field), field");
    row.bind(1, participant);
    std::vector<std::pair<std::string, std::string>> out;
    while (row.executeStep()) {
        const auto value = row.getColumn(1);
        const auto text = row.getColumn(2);
        // An option's id says more than its place.
        out.emplace_back(row.getColumn(0).getString(), text.isNull() && !value.isNull()
                                                           ? fmt::format("{}", value.getDouble())
                                                           : text.getString());
    }
    return out;
}

std::vector<std::string> lines(SQLite::Database& database, const char* sql, const std::string& participant) {
    SQLite::Statement row(database, sql);
    row.bind(1, participant);
    std::vector<std::string> out;
    while (row.executeStep()) out.push_back(row.getColumn(0).getString());
    return out;
}

constexpr const char* sessions_sql = R"sql(
SELECT s.id || ': ' || strftime('%Y-%m-%d %H:%M UTC', s.started_utc_s, 'unixepoch') || ', ' || s.station ||
       ', ' || coalesce(s.outcome || ' after ' || CAST(round((s.ended_utc_s - s.started_utc_s) / 60.0) AS INTEGER)
                        || ' min', 'not ended') || ', ' ||
       (SELECT count(*) FROM responses WHERE session = s.id AND superseded IS NULL) || ' answered'
  FROM sessions AS s WHERE s.participant = ? ORDER BY s.id
)sql";

constexpr const char* events_sql = R"sql(
SELECT strftime('%Y-%m-%d %H:%M:%S', at, 'unixepoch') || ' ' || what FROM (
    SELECT e.utc_s AS at, e.kind || coalesce(' in trial ' || e.trial_index, '') ||
           iif(e.detail = '', '', ': ' || e.detail) AS what
      FROM events AS e JOIN sessions AS s ON s.id = e.session
     WHERE s.participant = ?1 AND (e.kind LIKE 'operator_%' OR e.kind IN ('pause', 'quit', 'check_failed',
           'warned', 'practice_failed', 'excluded', 'included', 'trial_repeated'))
    UNION ALL
    SELECT superseded_utc_s, 'answer of trial ' || trial_index || ' superseded' ||
           CASE superseded WHEN '' THEN '' ELSE ': ' || superseded END
      FROM responses WHERE participant = ?1 AND superseded IS NOT NULL
    UNION ALL
    SELECT answered_utc_s, 'trial ' || trial_index || ' ' || replace(status, '_', ' ') ||
           coalesce(': ' || reason, '')
      FROM responses WHERE participant = ?1 AND status <> 'answered')
 ORDER BY at, what
)sql";

}  // namespace

std::string_view consentName(Consent consent) {
    constexpr std::array<std::string_view, 3> names{"", "agreed", "declined"};
    return names.at(static_cast<std::size_t>(consent));
}

bool mayTakePart(const ParticipantRow& participant) {
    if (participant.consent == Consent::declined) return participant.reason == asked_anew_reason;
    return participant.status == ParticipantStatus::active;
}

Result<ParticipantList> listParticipants(const std::filesystem::path& database) {
    return readDatabase(database, [](SQLite::Database& open) -> Result<ParticipantList> {
        return ParticipantList{
            readRows(open), open.execAndGet("SELECT count(*) FROM withdrawals").getInt(),
            open.execAndGet("SELECT count(*) FROM withdrawals WHERE cleared = 0").getInt()};
    });
}

Result<ParticipantDetails> showParticipant(const std::filesystem::path& database,
                                           const std::string& participant) {
    return readDatabase(database, [&](SQLite::Database& open) -> Result<ParticipantDetails> {
        const auto found = readRows(open, participant);
        if (found.empty()) return noParticipant(database, participant);
        return ParticipantDetails{found.front(), readFields(open, participant),
                                  lines(open, sessions_sql, participant),
                                  lines(open, events_sql, participant)};
    });
}

Result<void> excludeParticipant(const std::filesystem::path& database, const std::string& participant,
                                const std::string& reason) {
    if (trimmed(reason).empty())
        return fail(database.string(),
                    fmt::format("participant {} cannot be excluded without a reason", participant),
                    "Say why: the reason is recorded and reported");
    if (!storableText(reason))
        return fail(database.string(), "the reason is not UTF-8 text", "Give it in UTF-8");
    return changeParticipant(database, participant, [&](SQLite::Database& open) {
        setStatus(open, participant, ParticipantStatus::excluded, reason);
    });
}

}  // namespace deixis::results
