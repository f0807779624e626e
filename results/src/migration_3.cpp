// Version 2 knew one kind of study: naturalness ratings, then the referential game, each after some practice.
// Its two stages become up to four (practice is a stage of its own), a rating becomes an answer, a clip shown
// becomes a stimulus, and tracked frames are packed into blocks.
#include "migration_3.hpp"

#include <fmt/core.h>

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "core/hash.hpp"
#include "results/tracking_blocks.hpp"
#include "schema.hpp"
#include "studies/plan.hpp"
#include "tracking_writer.hpp"

namespace deixis::results {

namespace {

constexpr std::array old_tables{
    "study",    "systems",     "layouts",       "participants", "plans",
    "trials",   "sessions",    "responses",     "events",       "session_properties",
    "tracking", "hand_joints", "trial_tracking"};

constexpr const char* copy_rows = R"sql(
INSERT INTO study SELECT id, name, title, hash, source, alpha, NULL FROM before_3_study;

INSERT INTO systems SELECT position, name, generator, manifest, '{}' FROM before_3_systems;
INSERT INTO layouts SELECT * FROM before_3_layouts;

CREATE TEMP TABLE stage_names (position, stage, practice, name, kind, practice_of);
INSERT INTO stage_names VALUES
    (0, 'naturalness', 1, 'naturalness-practice', 'rating', 'naturalness'),
    (1, 'naturalness', 0, 'naturalness', 'rating', NULL),
    (2, 'game', 1, 'game-practice', 'referential-game', 'game'),
    (3, 'game', 0, 'game', 'referential-game', NULL);

INSERT INTO stages
SELECT n.position, n.name, n.kind, 1, n.practice_of, iif(n.kind = 'rating', 'naturalness', NULL),
       iif(n.kind = 'rating', 1, NULL), iif(n.kind = 'rating', s.rating_steps, NULL), NULL
  FROM stage_names AS n, before_3_study AS s
 WHERE EXISTS (SELECT 1 FROM before_3_trials AS t WHERE t.stage = n.stage AND t.practice = n.practice);
INSERT INTO questions
SELECT name, 'rating', 0, 'scale', '', scale_low, scale_high, NULL FROM stages WHERE kind = 'rating';

INSERT INTO trials
SELECT t.participant, t.trial_index, n.name, n.kind, t.practice, 0, 0, t.layout, NULL,
       t.target_id, t.target_x_m, t.target_y_m, t.target_z_m,
       iif(t.stage = 'game', t.distractors, NULL), t.balls, t.target_place, NULL, NULL, NULL, NULL
  FROM before_3_trials AS t JOIN stage_names AS n ON n.stage = t.stage AND n.practice = t.practice;
INSERT INTO trial_stimuli
SELECT participant, trial_index, 0, system, target_id, NOT practice FROM before_3_trials;

INSERT INTO sessions SELECT * FROM before_3_sessions;
INSERT INTO session_properties SELECT * FROM before_3_session_properties;

INSERT INTO responses
SELECT id, participant, trial_index, session, 'answered', chosen_place, correct, NULL,
       onset_s, onset_utc_s, motion_end_s, motion_end_utc_s, answered_s, answered_utc_s,
       response_time_s, paused_s, replays, pauses, 0, NULL, input,
       head_x_m, head_y_m, head_z_m, head_qw, head_qx, head_qy, head_qz,
       ray_x_m, ray_y_m, ray_z_m, ray_dx, ray_dy, ray_dz, NULL, NULL
  FROM before_3_responses;
INSERT INTO response_stimuli SELECT id, 0, clip_file, clip_hash, replays + 1 FROM before_3_responses;
INSERT INTO answers
SELECT id, 0, 'rating', 0, rating, NULL FROM before_3_responses WHERE rating IS NOT NULL;

INSERT INTO events SELECT * FROM before_3_events;
INSERT INTO hand_joints SELECT * FROM before_3_hand_joints;
INSERT INTO trial_tracking SELECT * FROM before_3_trial_tracking;

DROP TABLE stage_names;
)sql";

/// Numbers of the participants, which version 2 did not have: what the id ends in, where nobody else has it.
std::map<std::string, int> numbers(SQLite::Database& database) {
    std::map<std::string, int> out;
    std::set<int> taken{0};
    std::vector<std::string> others;
    SQLite::Statement row(database, "SELECT id FROM before_3_participants ORDER BY id");
    while (row.executeStep()) {
        const std::string id = row.getColumn(0).getString();
        const auto number = studies::numberOfParticipant(id);
        if (number && taken.insert(*number).second)
            out[id] = *number;
        else
            others.push_back(id);
    }
    int last = *taken.rbegin();
    for (const std::string& id : others) out[id] = ++last;
    return out;
}

void insertParticipants(SQLite::Database& database, const std::map<std::string, int>& number_of) {
    SQLite::Statement insert(
        database,
        "INSERT INTO participants SELECT ?, ?, 'en', 'active', NULL, coalesce(min(started_utc_s), 0.0) "
        "FROM before_3_sessions WHERE participant = ?");
    for (const auto& [id, number] : number_of) {
        insert.tryReset();
        insert.bind(1, id);
        insert.bind(2, number);
        insert.bind(3, id);
        insert.exec();
    }
}

Vec3 vec3(const nlohmann::json& position) {
    return {position.at(0).get<double>(), position.at(1).get<double>(), position.at(2).get<double>()};
}

/// Throws nlohmann::json::exception where the text is no plan of version 2.
studies::StudyPlan convertedPlan(const std::string& text, int number) {
    const auto old = nlohmann::json::parse(text);
    studies::StudyPlan plan;
    plan.participant = old.at("participant").get<std::string>();
    plan.number = number;
    plan.study_name = old.at("study").get<std::string>();
    plan.study_hash = old.at("study_hash").get<std::string>();
    plan.seed = old.at("seed").get<std::uint64_t>();
    for (const auto& from : old.at("trials")) {
        const bool game = from.at("stage").get<std::string>() == "game";
        studies::Trial trial;
        trial.index = from.at("index").get<int>();
        trial.kind = game ? studies::StageKind::game : studies::StageKind::rating;
        trial.practice = from.at("practice").get<bool>();
        trial.stage = std::string(game ? "game" : "naturalness") + (trial.practice ? "-practice" : "");
        trial.stimuli = {{from.at("system").get<std::string>(), from.at("target_id").get<std::string>()}};
        trial.layout = from.at("layout").get<std::string>();
        trial.target = vec3(from.at("target"));
        if (game) {
            for (const auto& distractor : from.at("distractors"))
                trial.distractors.push_back(vec3(distractor));
            trial.ball_order = from.at("ball_order").get<std::vector<int>>();
        }
        if (plan.stages.empty() || plan.stages.back() != trial.stage) plan.stages.push_back(trial.stage);
        plan.trials.push_back(std::move(trial));
    }
    return plan;
}

Result<void> convertPlans(SQLite::Database& database, const std::map<std::string, int>& number_of,
                          const std::filesystem::path& path) {
    SQLite::Statement row(database,
                          "SELECT participant, seed, json FROM before_3_plans ORDER BY participant");
    SQLite::Statement insert(database, "INSERT INTO plans VALUES (?, ?, ?, ?)");
    while (row.executeStep()) {
        const std::string participant = row.getColumn(0).getString();
        std::string json;
        try {
            json = studies::planJson(convertedPlan(row.getColumn(2).getString(), number_of.at(participant)));
        } catch (const nlohmann::json::exception& problem) {
            return fail(path.string(),
                        fmt::format("the stored plan of participant {} cannot be read: {}", participant,
                                    problem.what()),
                        "The database was changed by another program; use a copy from before that");
        }
        insert.tryReset();
        insert.bind(1, participant);
        insert.bind(2, row.getColumn(1).getString());
        insert.bind(3, sha256Hex(json));
        insert.bind(4, json);
        insert.exec();
    }
    return {};
}

studies::TrackedPose poseAt(const SQLite::Statement& row, int first) {
    constexpr int position_valid = 1, orientation_valid = 2, tracked = 4;
    const auto number = [&](int column) { return row.getColumn(first + column).getDouble(); };
    const int validity = row.getColumn(first).getInt();
    return {{{number(1), number(2), number(3)}, Quat(number(4), number(5), number(6), number(7))},
            (validity & position_valid) != 0,
            (validity & orientation_valid) != 0,
            (validity & tracked) != 0};
}

/// In the order of version 2's columns: see docs of that version, or schema_2.cpp.
TrackedFrame frameOf(const SQLite::Statement& row) {
    constexpr int head = 9, columns_of_pose = 8;
    TrackedFrame out;
    out.trial_index = row.getColumn(2).isNull() ? -1 : row.getColumn(2).getInt();
    studies::TrackingSample& sample = out.sample;
    sample.frame = static_cast<std::uint64_t>(row.getColumn(1).getInt64());
    sample.display_time_s = row.getColumn(3).getDouble();
    sample.begun_s = row.getColumn(4).getDouble();
    sample.submitted_s = row.getColumn(5).getDouble();
    sample.dropped_frames = row.getColumn(6).getInt();
    sample.rendered = row.getColumn(7).getInt() != 0;
    sample.off_place_m = row.getColumn(8).getDouble();
    sample.head = poseAt(row, head);
    sample.aim = {poseAt(row, head + columns_of_pose), poseAt(row, head + 2 * columns_of_pose)};
    sample.grip = {poseAt(row, head + 3 * columns_of_pose), poseAt(row, head + 4 * columns_of_pose)};
    constexpr int gaze = head + 5 * columns_of_pose;
    if (!row.getColumn(gaze).isNull()) sample.gaze = poseAt(row, gaze);
    return out;
}

void packFrames(SQLite::Database& database) {
    SQLite::Statement row(database, "SELECT * FROM before_3_tracking ORDER BY session, frame");
    TrackingWriter writer(database);
    std::vector<TrackedFrame> frames;
    std::int64_t session = 0;
    const auto write = [&] {
        writer.insert(session, frames);
        frames.clear();
    };
    while (row.executeStep()) {
        TrackedFrame frame = frameOf(row);
        const std::int64_t its_session = row.getColumn(0).getInt64();
        const bool goes_on = its_session == session && frames.size() < most_frames_in_block &&
                             (frames.empty() || frames.back().trial_index == frame.trial_index);
        if (!goes_on) write();
        session = its_session;
        frames.push_back(std::move(frame));
    }
    write();
}

}  // namespace

Result<void> migrateTo3(SQLite::Database& database, const std::filesystem::path& path) {
    // Renaming must leave alone what refers to the tables: the new ones take their places.
    database.exec(
        "PRAGMA legacy_alter_table = ON; DROP VIEW IF EXISTS responses_flat; DROP INDEX events_of_session; "
        "DROP INDEX tracking_of_trial");
    for (const char* table : old_tables)
        database.exec(fmt::format("ALTER TABLE {} RENAME TO before_3_{}", table, table));
    database.exec("PRAGMA legacy_alter_table = OFF");
    database.exec(newest_tables);
    database.exec(copy_rows);
    const auto number_of = numbers(database);
    insertParticipants(database, number_of);
    if (auto done = convertPlans(database, number_of, path); !done) return done;
    packFrames(database);
    for (const char* table : old_tables) database.exec(fmt::format("DROP TABLE before_3_{}", table));
    return {};
}

}  // namespace deixis::results
