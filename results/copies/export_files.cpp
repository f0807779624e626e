#include "export_files.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <optional>
#include <utility>
#include <vector>

#include "results/answers/questionnaire_scores.hpp"
#include "results/database/counted_participants.hpp"
#include "results/database/tracking_blocks.hpp"

namespace deixis::results {

namespace {

using SQLite::Statement;
using enum ColumnType;

std::vector<std::string> names(SQLite::Database& database, const char* sql) {
    std::vector<std::string> out;
    Statement query(database, sql);
    while (query.executeStep()) out.push_back(query.getColumn(0).getString());
    return out;
}

// The value of a field, as a number or text; nothing where it was not answered or is not shared.
void fieldCell(SQLite::Database& database, CsvTable& table, const std::string& participant,
               const std::string& field, bool anonymise) {
    Statement stored(
        database,
        "SELECT value, text, EXISTS (SELECT 1 FROM questions WHERE question = ?2 AND kind = 'text') "
        "FROM participant_fields WHERE participant = ?1 AND field = ?2");
    stored.bind(1, participant);
    stored.bind(2, field);
    if (!stored.executeStep() || (anonymise && stored.getColumn(2).getInt() != 0))
        table.empty();
    else
        table.cell(stored.getColumn(stored.getColumn(1).isNull() ? 0 : 1));
}

}  // namespace

ExportedFile participantsFile(SQLite::Database& database, const AnonymousNames& naming, bool anonymise) {
    const auto factors = names(database, "SELECT DISTINCT factor FROM participant_groups ORDER BY 1");
    const auto fields = names(database, "SELECT DISTINCT field FROM participant_fields ORDER BY 1");
    std::vector<ColumnSpec> columns{{"participant", text, "Pseudonymous id"}};
    if (!anonymise)
        columns.push_back({"number", whole, "Number within the study, which determines the order of trials"});
    columns.push_back({"language", text, "Language of the participant's texts"});
    columns.push_back({"status", text,
                       "active, excluded (left out of the analysis) or dropped (left the study, or declined "
                       "consent when last asked)"});
    if (!anonymise) {
        columns.push_back({"reason", text, "Why excluded or dropped out"});
        columns.push_back({"registered_utc", text, "First seen, UTC"});
    }
    columns.push_back({"sessions", whole, "How many times the program ran with the participant"});
    columns.push_back(
        {"answered", whole, "Units answered: trials, practice and pages, but not declined consent"});
    columns.push_back(
        {"planned", whole, "Units planned, including further attempts at a practice once they have begun"});
    columns.push_back({"checks_failed", whole, "Attention checks failed"});
    columns.push_back({"consent", truth, "1 agreed, 0 declined, when last asked; empty: not asked"});
    for (const auto& factor : factors)
        columns.push_back({"group_" + factor, text, "Level of this between-participants factor"});
    for (const auto& field : fields)
        columns.push_back({"field_" + field, text, "Answer to this question about the participant"});
    ExportedFile out{"participants.csv", "One row for each participant, except those who withdrew.",
                     CsvTable(std::move(columns))};
    Statement rows(
        database,
        "SELECT number, language, status, reason, "
        "strftime('%Y-%m-%dT%H:%M:%fZ', registered_utc_s, 'unixepoch'), "
        "(SELECT count(*) FROM sessions AS e WHERE e.participant = p.id), "
        "(SELECT count(*) FROM responses AS r WHERE r.participant = p.id AND r.superseded IS NULL AND NOT "
        "EXISTS (SELECT 1 FROM answers WHERE response = r.id AND question = 'consent' AND value = 0)), "
        "(SELECT count(*) FROM trials AS t WHERE t.participant = p.id AND (attempt = 0 OR EXISTS (SELECT 1 "
        "FROM responses AS r WHERE r.participant = p.id AND r.trial_index = t.trial_index AND r.superseded "
        "IS NULL))), "
        "(SELECT count(*) FROM responses AS r WHERE r.participant = p.id AND r.superseded IS NULL AND "
        "r.check_passed = 0), "
        "(SELECT min(agreed) FROM consents AS c WHERE c.participant = p.id AND session = (SELECT "
        "max(session) FROM consents AS o WHERE o.participant = c.participant AND o.stage = c.stage)) "
        "FROM " +
            effectiveParticipants() + " AS p WHERE id = ?");
    for (const std::string& participant : naming.participants()) {
        rows.reset();
        rows.bind(1, participant);
        if (!rows.executeStep()) continue;
        CsvTable& table = out.table;
        table.text(naming.nameOf(participant));
        if (!anonymise) table.cell(rows.getColumn(0));
        table.cell(rows.getColumn(1));
        table.cell(rows.getColumn(2));
        if (!anonymise) {
            table.cell(rows.getColumn(3));
            table.cell(rows.getColumn(4));
        }
        for (int i = 5; i <= 9; ++i) table.cell(rows.getColumn(i));
        for (const auto& factor : factors) {
            Statement level(database,
                            "SELECT level FROM participant_groups WHERE participant = ? AND factor = ?");
            level.bind(1, participant);
            level.bind(2, factor);
            if (level.executeStep())
                table.cell(level.getColumn(0));
            else
                table.empty();
        }
        for (const auto& field : fields) fieldCell(database, table, participant, field, anonymise);
        table.endRow();
    }
    return out;
}

ExportedFile scoresFile(SQLite::Database& database, const AnonymousNames& naming) {
    ExportedFile out{"scores.csv",
                     "Scores of questionnaires by their published rules; empty if an item was not answered.",
                     CsvTable({{"participant", text, "Pseudonymous id"},
                               {"stage", text, "Name of the stage in the study file"},
                               {"score", text, "Name of the score"},
                               {"value", number, "Its value"}})};
    const auto scores = readQuestionnaireScores(database);
    for (const std::string& participant : naming.participants())
        for (const QuestionnaireScore& score : scores) {
            if (score.participant != participant) continue;
            out.table.text(naming.nameOf(participant));
            out.table.text(score.stage);
            out.table.text(score.score);
            if (score.value)
                out.table.number(*score.value);
            else
                out.table.empty();
            out.table.endRow();
        }
    return out;
}

namespace {

void addPoseColumns(std::vector<ColumnSpec>& columns, const std::string& prefix, const std::string& what) {
    columns.push_back({prefix + "_valid", truth, what + ": position and orientation are known"});
    columns.push_back({prefix + "_tracked", truth, what + ": measured now, not held or guessed"});
    for (const char* axis : {"x_m", "y_m", "z_m"})
        columns.push_back({prefix + "_" + axis, number, what + ": position in the avatar's frame", "m"});
    for (const char* part : {"qw", "qx", "qy", "qz"})
        columns.push_back(
            {prefix + "_" + part, number, what + ": unit quaternion; -z looks or points forward"});
}

void poseCells(CsvTable& table, const studies::TrackedPose* pose) {
    if (pose == nullptr || !pose->valid()) {
        table.whole(0);
        table.whole(0);
        for (int i = 0; i < 7; ++i) table.empty();
        return;
    }
    table.whole(1);
    table.whole(pose->tracked ? 1 : 0);
    const Vec3& p = pose->stage_from_device.position;
    const Quat& q = pose->stage_from_device.orientation;
    for (const double value : {p.x, p.y, p.z, q.w, q.x, q.y, q.z}) table.number(value);
}

}  // namespace

Result<ExportedFile> trackingFile(SQLite::Database& database, const AnonymousNames& naming, bool anonymise,
                                  const std::filesystem::path& file) {
    std::vector<ColumnSpec> columns{
        {"participant", text, "Pseudonymous id"},
        {"session", whole, "One session of a participant with the program"},
        {"trial_index", whole, "Current trial; empty: none"},
        {"frame", whole, "Number of the frame"},
        {"display_time_s", number, "When it was shown, on the station's clock", "s"},
        {"dropped_frames", whole, "Display periods without a new frame before it"},
        {"off_place_m", number, "Distance of the head from its place", "m"}};
    addPoseColumns(columns, "head", "Head");
    for (const char* hand : {"left", "right"})
        addPoseColumns(columns, fmt::format("aim_{}", hand),
                       fmt::format("Pointing ray of the {} hand", hand));
    for (const char* hand : {"left", "right"})
        addPoseColumns(columns, fmt::format("grip_{}", hand), fmt::format("Grip of the {} hand", hand));
    addPoseColumns(columns, "gaze", "Gaze");
    ExportedFile out{"tracking.csv", "One row for each tracked frame.", CsvTable(std::move(columns))};
    Statement blocks(
        database,
        "SELECT b.session, b.trial_index, b.data FROM tracking_blocks AS b JOIN sessions AS e ON e.id = "
        "b.session WHERE e.participant = ? ORDER BY b.session, b.first_frame");
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    for (const std::string& participant : naming.participants()) {
        blocks.reset();
        blocks.bind(1, participant);
        while (blocks.executeStep()) {
            const long long session = blocks.getColumn(0).getInt64();
            const SQLite::Column data = blocks.getColumn(2);
            const auto samples = unpackTracking(
                {static_cast<const char*>(data.getBlob()), static_cast<std::size_t>(data.getBytes())});
            if (!samples) return tl::unexpected(samples.error());
            for (const studies::TrackingSample& sample : *samples) {
                CsvTable& table = out.table;
                table.text(naming.nameOf(participant));
                table.whole(naming.nameOfSession(session));
                table.cell(blocks.getColumn(1));
                table.whole(static_cast<long long>(sample.frame));
                table.number(anonymise ? sample.display_time_s - naming.startOfSession(session)
                                       : sample.display_time_s);
                table.whole(sample.dropped_frames);
                table.number(sample.off_place_m);
                poseCells(table, &sample.head);
                for (const auto& pose : sample.aim) poseCells(table, &pose);
                for (const auto& pose : sample.grip) poseCells(table, &pose);
                poseCells(table, sample.gaze ? &*sample.gaze : nullptr);
                table.endRow();
            }
            stream << out.table.take();
        }
    }
    if (!stream.flush()) return fail(file.string(), "cannot be written");
    return out;
}

}  // namespace deixis::results
