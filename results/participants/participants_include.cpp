// Letting somebody in again who was excluded, declined or dropped out.
#include <fmt/core.h>

#include "participants_change.hpp"
#include "results/database/answer_hash.hpp"
#include "results/database/counted_participants.hpp"
#include "results/database/database_open.hpp"
#include "results/participants/participants.hpp"
#include "results/store/participant_lock.hpp"
#include "studies/session/events.hpp"

namespace deixis::results {

namespace {

using SQLite::Statement;

bool rejects(SQLite::Database& database, const std::string& participant) {
    Statement row(database, "SELECT " + declinedConsent("?"));
    row.bind(1, participant);
    row.executeStep();
    return row.getColumn(0).getInt() != 0;
}

/// Practice stages that somebody was excluded for, while the stage practised has not begun.
std::vector<std::string> failedPractice(SQLite::Database& database, const std::string& participant) {
    Statement rows(
        database,
        "SELECT g.name FROM stages AS g WHERE g.practice_of IS NOT NULL AND EXISTS (SELECT 1 FROM "
        "responses AS r JOIN trials AS t USING (participant, trial_index) JOIN sessions AS s ON "
        "s.participant = r.participant JOIN events AS e ON e.session = s.id WHERE r.participant = "
        "?1 AND t.stage = g.name AND r.superseded IS NULL AND r.session <= e.session AND e.kind = "
        "'excluded' AND e.detail = ?2 || g.name) AND NOT EXISTS (SELECT 1 FROM responses AS r JOIN "
        "trials AS t USING (participant, trial_index) WHERE r.participant = ?1 AND t.stage = "
        "g.practice_of AND r.superseded IS NULL) ORDER BY g.position");
    rows.bind(1, participant);
    rows.bind(2, std::string(studies::practice_failed_reason));
    std::vector<std::string> out;
    while (rows.executeStep()) out.push_back(rows.getColumn(0).getString());
    return out;
}

void practiseAnew(SQLite::Database& database, const std::string& participant, const std::string& stage,
                  double utc_s) {
    Statement answers(
        database,
        "SELECT r.id, r.hash IS NOT NULL FROM responses AS r JOIN trials AS t USING (participant, "
        "trial_index) WHERE r.participant = ? AND t.stage = ? AND r.superseded IS NULL");
    answers.bind(1, participant);
    answers.bind(2, stage);
    std::vector<std::pair<std::int64_t, bool>> found;
    while (answers.executeStep())
        found.emplace_back(answers.getColumn(0).getInt64(), answers.getColumn(1).getInt() != 0);
    AnswerHasher hasher(database, AnswerHasher::Scope::one);
    for (const auto& [id, hashed] : found) {
        Statement update(database,
                         "UPDATE responses SET superseded = 'the practice begins anew', superseded_utc_s = ? "
                         "WHERE id = ?");
        update.bind(1, utc_s);
        update.bind(2, id);
        update.exec();
        if (!hashed) continue;
        Statement hash(database, "UPDATE responses SET hash = ? WHERE id = ?");
        hash.bind(1, hasher.of(id));
        hash.bind(2, id);
        hash.exec();
    }
}

int countFailedChecks(SQLite::Database& database, const std::string& participant) {
    Statement row(database,
                  "SELECT count(*) FROM responses WHERE participant = ?1 AND superseded IS NULL AND "
                  "check_passed = 0 AND session > coalesce((SELECT max(e.session) FROM events AS e JOIN "
                  "sessions AS s ON s.id = e.session WHERE s.participant = ?1 AND e.kind = 'included'), 0)");
    row.bind(1, participant);
    row.executeStep();
    return row.getColumn(0).getInt();
}

/// Marks the end of the sessions whose failed checks no rule counts any more. On the clock of the last one.
void noteInclusion(SQLite::Database& database, const std::string& participant, double utc_s) {
    Statement insert(
        database,
        "INSERT INTO events (session, kind, trial_index, time_s, utc_s, detail) SELECT s.id, 'included', "
        "NULL, coalesce((SELECT e.time_s + ?2 - e.utc_s FROM events AS e WHERE e.session = s.id ORDER BY "
        "e.id "
        "LIMIT 1), 0.0), ?2, (SELECT coalesce(reason, '') FROM participants WHERE id = ?1) FROM sessions AS "
        "s "
        "WHERE s.participant = ?1 ORDER BY s.id DESC LIMIT 1");
    insert.bind(1, participant);
    insert.bind(2, utc_s);
    insert.exec();
}

}  // namespace

Result<Inclusion> includeParticipant(const std::filesystem::path& database, const std::string& participant,
                                     double utc_s) {
    // Asked first: a lock's file is made only for somebody who is there.
    if (const auto known = showParticipant(database, participant); !known)
        return tl::unexpected(known.error());
    const auto lock = ParticipantLock::take(database, participant);
    if (!lock) return tl::unexpected(lock.error());
    Inclusion out;
    const auto changed = changeParticipant(database, participant, [&](SQLite::Database& open) {
        out.consent_asked_anew = rejects(open, participant);
        out.practice = failedPractice(open, participant);
        for (const std::string& stage : out.practice) practiseAnew(open, participant, stage, utc_s);
        out.failed_checks_forgiven = countFailedChecks(open, participant);
        noteInclusion(open, participant, utc_s);
        if (out.consent_asked_anew)
            setStatus(open, participant, ParticipantStatus::dropped, asked_anew_reason);
        else
            setStatus(open, participant, ParticipantStatus::active, std::nullopt);
    });
    if (!changed) return tl::unexpected(changed.error());
    return out;
}

}  // namespace deixis::results
