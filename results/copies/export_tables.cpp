#include "export_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "results/database/counted_participants.hpp"
#include "results/database/views.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::results {

namespace {

using enum ColumnType;

const ExportColumn participant_column{
    {"participant", text, "Pseudonymous id"}, "participant", Privacy::participant};
const ExportColumn session{
    {"session", whole, "One session of a participant with the program"}, "session", Privacy::session};
const ExportColumn trial_index{
    {"trial_index", whole, "Which answered unit, from 0 over all sessions in the planned order"},
    "trial_index"};

/// SQL for what the study says of a questionnaire's answer that rates a system: its measure or its system.
std::string ratedBy(const char* key) {
    return fmt::format(
        "(SELECT json_extract(e.value, '$.{}') FROM study, json_each(study.analysis, '$.rates') AS e WHERE "
        "json_extract(e.value, '$.stage') = f.stage AND json_extract(e.value, '$.question') = f.question)",
        key);
}

/// SQL for what a row of responses_flat measures, as the kinds of stages declare it.
std::string measureOfAnswer() {
    std::string out = "CASE";
    for (const studies::StageDeclaration* kind : studies::allDeclarations())
        for (const studies::DeclaredMeasure& measure : kind->measures)
            if (!measure.question.empty())
                out +=
                    fmt::format(" WHEN kind = '{}' AND question = '{}' THEN {}", kind->name, measure.question,
                                measure.name.empty() ? "(SELECT measure FROM stages WHERE name = f.stage)"
                                                     : fmt::format("'{}'", measure.name));
    return out + fmt::format(" WHEN kind = 'questionnaire' THEN {} END", ratedBy("measure"));
}

ExportTable responsesTable() {
    return {
        "responses.csv",
        "One row for each answer to a question or rating, and one for each response without any (a choice of "
        "the game, "
        "a skipped trial). Answers that were given again appear with the new ones only.",
        "FROM responses_flat AS f WHERE participant = ?1 ORDER BY trial_index, response, stimulus, question",
        {
            participant_column,
            {{"participant_status", text,
              "active, excluded (left out of the analysis) or dropped (left the study, or declined consent "
              "when last asked)"},
             "participant_status"},
            session,
            trial_index,
            {{"stage", text, "Name of the stage in the study file"}, "stage"},
            {{"kind", text,
              "Kind of the stage: rating, parallel-rating, pairwise, referential-game, questionnaire, "
              "consent"},
             "kind"},
            {{"practice", truth, "1: practice, which is not analysed"}, "practice"},
            {{"attempt", whole, "Practice: which attempt, from 0"}, "attempt"},
            {{"status", text, "answered, timed_out (the time limit passed) or skipped (by the experimenter)"},
             "status"},
            {{"question", text,
              "rating, preference, confidence, reasons, consent, or a questionnaire's question"},
             "question"},
            {{"measure", text, "What the answer measures in the report; empty: nothing, or a choice"},
             measureOfAnswer()},
            {{"stimulus", whole, "Which of the trial's clips, from 0; empty: of both, or none"}, "stimulus"},
            {{"system", text,
              "System that made the clip, or that the questionnaire's answer rates; of a pair the one on the "
              "left"},
             "coalesce(system, " + ratedBy("system") + ")"},
            {{"other_system", text, "Of a pair: the one on the right"}, "other_system"},
            {{"item", text, "Item (target) that the clip is for"}, "item"},
            {{"scored", truth, "1: counts in the analysis; 0: practice, an attention check, another page"},
             "CASE WHEN " + ratedBy("system") + " IS NULL THEN scored ELSE 1 END"},
            {{"value", number,
              "The answer as a number; a preference runs from -2 (clearly left, system) to 2 (clearly right, "
              "other_system)"},
             "value"},
            {{"scale_low", number, "Lowest possible answer"},
             "(SELECT low FROM questions AS q WHERE q.stage = f.stage AND q.question = f.question)"},
            {{"scale_high", number, "Highest possible answer"},
             "(SELECT high FROM questions AS q WHERE q.stage = f.stage AND q.question = f.question)"},
            {{"text", text, "Chosen options by their ids, or what was typed"},
             "text",
             Privacy::kept,
             "CASE WHEN EXISTS (SELECT 1 FROM questions AS q WHERE q.stage = f.stage AND q.question = "
             "f.question AND "
             "q.kind = 'text') THEN NULL ELSE text END"},
            {{"chosen_place", whole, "Game: the ball chosen, from 0 in the order shown"}, "chosen_place"},
            {{"target_place", whole, "Game: the ball that was the target"}, "target_place"},
            {{"balls", whole, "Game: how many balls were shown"}, "json_array_length(balls)"},
            {{"correct", truth, "Game: 1 if the target was chosen"}, "correct"},
            {{"check_kind", text, "Attention check: number, catch or repeat"}, "check_kind"},
            {{"check_passed", truth, "Attention check: 1 passed, 0 failed"}, "check_passed"},
            {{"layout", text, "Where the participant stood"}, "layout"},
            {{"viewer_x_m", number, "Where the participant was asked to stand, in the avatar's frame", "m"},
             "viewer_x_m"},
            {{"viewer_z_m", number, "", "m"}, "viewer_z_m"},
            {{"viewer_heading_deg", number,
              "Where the participant was asked to face: 0 as the avatar does, 180 at the avatar", "degrees"},
             "heading_deg"},
            {{"distance", text, "Game: band of the distractors' distance"}, "distance"},
            {{"target_id", text, "Item of the trial"}, "target_id"},
            {{"response_time_s", number, "From the end of the motion to the answer, without pauses", "s"},
             "response_time_s"},
            {{"replays", whole, "How many times a clip was replayed on request"}, "replays"},
            {{"plays", whole, "How many times this clip was shown to its end"}, "plays"},
            {{"pauses", whole, "How many times the trial was interrupted"}, "pauses"},
            {{"paused_s", number, "For how long while the answer was open", "s"}, "paused_s"},
            {{"begun_before", truth, "1: its clip had started in an earlier session, which was interrupted"},
             "begun_before"},
            {{"marked", text, "Why the trial is doubtful: interrupted, off place; empty: it is not"},
             "(SELECT group_concat(why, ', ') FROM (SELECT 'interrupted' AS why WHERE f.pauses > 0 OR "
             "f.begun_before UNION ALL SELECT 'off place' WHERE EXISTS (SELECT 1 FROM events AS v WHERE "
             "v.session = f.session AND v.trial_index = f.trial_index AND v.kind = 'off_place')))"},
            {{"input", text, "ray or key; empty if nothing was answered"}, "input"},
            {{"dropped_frames", whole, "Display periods without a new frame during the trial"},
             "dropped_frames"},
            {{"samples_missing", whole, "Tracked frames of the trial that were not stored"},
             "samples_missing"},
            {{"max_off_place_m", number, "Largest distance of the head from its place in the trial", "m"},
             "max_off_place_m"},
            {{"clip_file", text, "File of the clip"}, "clip_file", Privacy::left_out},
            {{"clip_hash", text, "SHA-256 of the clip's bytes"}, "clip_hash"},
            {{"clip", whole, "Which of the system's clips for the item, from 0, if there are several"},
             "clip"},
            {{"author", text, "Who made the clip, as its manifest says"}, "author", Privacy::left_out},
            {{"author_trial", whole, "In which of the author's trials"}, "author_trial"},
            {{"onset_s", number, "First frame of the last clip's last play", "s"}, "onset_s", Privacy::clock},
            {{"motion_end_s", number, "Last frame of that clip: the answer opened", "s"},
             "motion_end_s",
             Privacy::clock},
            {{"answered_s", number, "The answer", "s"}, "answered_s", Privacy::clock},
            {{"answered_utc", text, "The answer, UTC"}, "answered_utc", Privacy::left_out},
            {{"head_x_m", number, "Head at the answer: position in the avatar's frame", "m"}, "head_x_m"},
            {{"head_y_m", number, "", "m"}, "head_y_m"},
            {{"head_z_m", number, "", "m"}, "head_z_m"},
            {{"head_qw", number, "Head at the answer: unit quaternion; -z looks forward"}, "head_qw"},
            {{"head_qx", number, ""}, "head_qx"},
            {{"head_qy", number, ""}, "head_qy"},
            {{"head_qz", number, ""}, "head_qz"},
            {{"ray_x_m", number, "Pointing ray at the answer: origin", "m"}, "ray_x_m"},
            {{"ray_y_m", number, "", "m"}, "ray_y_m"},
            {{"ray_z_m", number, "", "m"}, "ray_z_m"},
            {{"ray_dx", number, "Pointing ray at the answer: unit direction"}, "ray_dx"},
            {{"ray_dy", number, ""}, "ray_dy"},
            {{"ray_dz", number, ""}, "ray_dz"},
            {{"station", text, "desktop, headset, studio or simulated"}, "station"},
            {{"synthetic", truth, "1: a simulated participant answered; no evidence about people"},
             "synthetic"},
        }};
}

ExportTable trialsTable() {
    return {
        "trials.csv",
        "What was planned: one row for each unit that is answered.",
        "FROM trials AS t WHERE participant = ?1 ORDER BY trial_index",
        {
            participant_column,
            trial_index,
            {{"stage", text, "Name of the stage in the study file"}, "stage"},
            {{"kind", text, "Kind of the stage"}, "kind"},
            {{"practice", truth, "1: practice, which is not analysed"}, "practice"},
            {{"attempt", whole, "Practice: which attempt, from 0"}, "attempt"},
            {{"page", whole, "Questionnaire: which page, from 0"}, "page"},
            {{"stimuli", text,
              "Clips in the order shown, SYSTEM/ITEM separated by ';', with /CLIP if that is not 0"},
             "(SELECT group_concat(one, ';') FROM (SELECT s.system || '/' || s.item || CASE WHEN s.clip > 0 "
             "THEN '/' || s.clip ELSE '' END AS one FROM "
             "trial_stimuli AS s WHERE "
             "s.participant = t.participant AND s.trial_index = t.trial_index ORDER BY s.position))"},
            {{"layout", text, "Where the participant stands"}, "layout"},
            {{"distance", text, "Game: band of the distractors' distance"}, "distance"},
            {{"target_id", text, "Item of the trial"}, "target_id"},
            {{"target_x_m", number, "Target in the avatar's frame", "m"}, "target_x_m"},
            {{"target_y_m", number, "", "m"}, "target_y_m"},
            {{"target_z_m", number, "", "m"}, "target_z_m"},
            {{"visibility", text,
              "Game: visible share of each ball's disc from the layout's places, with the avatar at rest and "
              "pointing, JSON"},
             "visibility"},
            {{"min_seen_headset", number,
              "Game: the smallest of these shares of any ball, at the place for a headset"},
             "(SELECT min(s.atom) FROM json_tree(t.visibility, '$.headset') AS s WHERE s.atom IS NOT NULL)"},
            {{"min_seen_desktop", number, "The same at the place for a desktop"},
             "(SELECT min(s.atom) FROM json_tree(t.visibility, '$.desktop') AS s WHERE s.atom IS NOT NULL)"},
            {{"angles", text,
              "Game: angle between each distractor and the target, as seen by the avatar and by the "
              "participant at the layout's places, JSON",
              "degrees"},
             "angles"},
            {{"min_angle_avatar_deg", number, "Game: the smallest of these angles as seen by the avatar",
              "degrees"},
             "(SELECT min(s.atom) FROM json_tree(t.angles, '$.avatar') AS s WHERE s.atom IS NOT NULL)"},
            {{"min_angle_headset_deg", number, "The same from the place for a headset", "degrees"},
             "(SELECT min(s.atom) FROM json_tree(t.angles, '$.headset') AS s WHERE s.atom IS NOT NULL)"},
            {{"min_angle_desktop_deg", number, "The same from the place for a desktop", "degrees"},
             "(SELECT min(s.atom) FROM json_tree(t.angles, '$.desktop') AS s WHERE s.atom IS NOT NULL)"},
            {{"check_kind", text, "Attention check: number, catch or repeat"}, "check_kind"},
            {{"check_stimulus", whole, "Number: the clip with which it is shown"}, "check_stimulus"},
            {{"check_expected", number, "Number: the number to enter"}, "check_expected"},
            {{"check_of_trial", whole, "Repeat: the trial that is repeated"}, "check_of_trial"},
        }};
}

ExportTable sessionsTable() {
    return {
        "sessions.csv",
        "One row for each run of the program with a participant.",
        "FROM sessions AS e WHERE participant = ?1 ORDER BY id",
        {
            participant_column,
            {{"session", whole, "One session of a participant with the program"}, "id", Privacy::session},
            {{"station", text, "desktop, headset, studio or simulated"}, "station"},
            {{"station_details", text, "Device, driver, display"}, "station_details", Privacy::left_out},
            {{"synthetic", truth, "1: a simulated participant answered; no evidence about people"},
             "synthetic"},
            {{"program_version", text, "Version of the program"}, "program_version"},
            {{"avatar_hash", text, "SHA-256 of the avatar shown"}, "avatar_hash"},
            {{"started_utc", text, "Beginning, UTC"},
             "strftime('%Y-%m-%dT%H:%M:%fZ', started_utc_s, 'unixepoch')",
             Privacy::left_out},
            {{"ended_utc", text, "End, UTC; empty if the program ended unexpectedly"},
             "strftime('%Y-%m-%dT%H:%M:%fZ', ended_utc_s, 'unixepoch')",
             Privacy::left_out},
            {{"duration_s", number, "From beginning to end", "s"}, "ended_utc_s - started_utc_s"},
            {{"outcome", text,
              "finished, quit, aborted, declined or excluded; empty: ended unexpectedly, or still running"},
             "outcome"},
        }};
}

ExportTable eventsTable() {
    return {"events.csv",
            "What happened, in order; the kinds are listed in docs/database.md.",
            "FROM (SELECT v.*, e.participant FROM events AS v JOIN sessions AS e ON e.id = v.session) WHERE "
            "participant = ?1 "
            "ORDER BY id",
            {
                participant_column,
                session,
                {{"time_s", number, "When, on the station's clock", "s"}, "time_s", Privacy::clock},
                {{"utc", text, "When, UTC"},
                 "strftime('%Y-%m-%dT%H:%M:%fZ', utc_s, 'unixepoch')",
                 Privacy::left_out},
                {{"kind", text, "What happened"}, "kind"},
                {{"trial_index", whole, "Current trial; empty: none"}, "trial_index"},
                {{"detail", text, "Details"},
                 "detail",
                 Privacy::kept,
                 "CASE WHEN kind LIKE 'operator\\_%' ESCAPE '\\' OR kind IN ('quit', 'edit') THEN '' ELSE "
                 "detail END"},
            }};
}

/// What is known of the participant, and the levels of the system, beside each answer.
void joinColumns(SQLite::Database& database, std::vector<ExportColumn>& columns) {
    const auto add = [&](const char* names, const std::string& prefix, const char* description,
                         const auto& sql) {
        SQLite::Statement name(database, names);
        while (name.executeStep()) {
            const std::string one = name.getColumn(0).getString();
            columns.push_back({{prefix + one, text, description}, sql(quotedSql(one), "")});
            columns.back().anonymous_sql =
                sql(quotedSql(one), " AND field NOT IN (SELECT question FROM questions WHERE kind = 'text')");
        }
    };
    add("SELECT DISTINCT factor FROM participant_groups ORDER BY 1", "group_",
        "The participant's level of this between-participants factor",
        [](const std::string& one, const char*) {
            return "(SELECT level FROM participant_groups WHERE participant = ?1 AND factor = " + one + ")";
        });
    add("SELECT DISTINCT l.key FROM systems AS s, json_each(s.levels) AS l ORDER BY 1", "level_",
        "The system's level of this factor", [](const std::string& one, const char*) {
            return "(SELECT l.value FROM systems AS s, json_each(s.levels) AS l WHERE s.name = f.system AND "
                   "l.key = " +
                   one + ")";
        });
    add("SELECT DISTINCT field FROM participant_fields ORDER BY 1", "field_",
        "The participant's answer to this question about themselves",
        [](const std::string& one, const char* shared) {
            return "(SELECT coalesce(text, value) FROM participant_fields WHERE participant = ?1 AND field "
                   "= " +
                   one + shared + ")";
        });
}

ColumnType typeOf(studies::KeptType type) {
    switch (type) {
        case studies::KeptType::whole:
            return whole;
        case studies::KeptType::truth:
            return truth;
        case studies::KeptType::number:
            return number;
        case studies::KeptType::text:
            return text;
    }
    return text;
}

/// What kinds of the study keep, where the table has no column for it yet. `row`: SQL of which row of
/// `values`, called v, belongs to the table's.
void keptColumns(SQLite::Database& database, std::vector<ExportColumn>& columns,
                 studies::KeptFields studies::StageDeclaration::*kept, const char* values, const char* row) {
    SQLite::Statement kind(database, "SELECT DISTINCT kind FROM stages ORDER BY kind");
    while (kind.executeStep()) {
        const studies::StageDeclaration* declared = studies::findDeclaration(kind.getColumn(0).getString());
        if (declared == nullptr) continue;
        for (const studies::KeptField& field : (declared->*kept).fields) {
            const std::string name(field.name);
            if (std::any_of(columns.begin(), columns.end(),
                            [&](const ExportColumn& one) { return one.spec.name == name; }))
                continue;
            columns.push_back({{name, typeOf(field.type), std::string(field.about), std::string(field.unit)},
                               keptValueSql(field, values, row)});
        }
    }
}

}  // namespace

std::vector<ExportTable> exportTables(SQLite::Database& database) {
    std::vector<ExportTable> tables{responsesTable(), trialsTable(), sessionsTable(), eventsTable()};
    keptColumns(database, tables[0].columns, &studies::StageDeclaration::response_values, "response_values",
                "v.response = f.response");
    keptColumns(database, tables[1].columns, &studies::StageDeclaration::trial_values, "trial_values",
                "v.participant = t.participant AND v.trial_index = t.trial_index");
    joinColumns(database, tables[0].columns);
    return tables;
}

}  // namespace deixis::results
