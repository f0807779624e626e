// Version 2 knew one kind of study: naturalness ratings, then the referential game, each after some practice.
// Its two stages become up to four (practice is a stage of its own), a rating becomes an answer, a clip shown
// becomes a stimulus, and tracked frames are packed into blocks. Only tables of versions 2 and 3 are known
// here.
#include "migration_3.hpp"

#include <fmt/core.h>

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <vector>

#include "core/hash.hpp"
#include "results/database/schema.hpp"
#include "results/database/tracking_blocks.hpp"
#include "studies/station/station.hpp"

namespace deixis::results {

namespace {

constexpr std::array old_tables{
    "study",    "systems",     "layouts",       "participants", "plans",
    "trials",   "sessions",    "responses",     "events",       "session_properties",
    "tracking", "hand_joints", "trial_tracking"};

/// Up to six digits at the end of an id.
std::optional<int> numberAtEnd(const std::string& participant) {
    constexpr std::size_t max_digits = 6;
    const auto last_other = participant.find_last_not_of("0123456789");
    const std::string digits = participant.substr(last_other == std::string::npos ? 0 : last_other + 1);
    if (digits.empty() || digits.size() > max_digits) return std::nullopt;
    const int number = std::stoi(digits);
    return number > 0 ? std::optional(number) : std::nullopt;
}

/// Numbers of the participants, which version 2 did not have: what the id ends in, where nobody else has it.
std::map<std::string, int> numbers(SQLite::Database& database) {
    std::map<std::string, int> out;
    std::set<int> taken{0};
    std::vector<std::string> others;
    SQLite::Statement row(database, "SELECT id FROM before_3_participants ORDER BY id");
    while (row.executeStep()) {
        const std::string id = row.getColumn(0).getString();
        const auto number = numberAtEnd(id);
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

using Json = nlohmann::ordered_json;

Json position(const Json& old) {
    return {old.at(0).get<double>(), old.at(1).get<double>(), old.at(2).get<double>()};
}

Json convertedTrial(const Json& old) {
    const bool game = old.at("stage").get<std::string>() == "game";
    const bool practice = old.at("practice").get<bool>();
    Json distractors = Json::array();
    Json ball_order = Json::array();
    if (game) {
        for (const Json& distractor : old.at("distractors")) distractors.push_back(position(distractor));
        for (const Json& ball : old.at("ball_order")) ball_order.push_back(ball.get<int>());
    }
    const Json stimulus{{"system", old.at("system").get<std::string>()},
                        {"item", old.at("target_id").get<std::string>()}};
    return {{"index", old.at("index").get<int>()},
            {"stage", std::string(game ? "game" : "naturalness") + (practice ? "-practice" : "")},
            {"kind", game ? "referential-game" : "rating"},
            {"practice", practice},
            {"attempt", 0},
            {"page", 0},
            {"stimuli", Json::array({stimulus})},
            {"layout", old.at("layout").get<std::string>()},
            {"distance", ""},
            {"target", position(old.at("target"))},
            {"distractors", distractors},
            {"ball_order", ball_order},
            {"check", nullptr}};
}

/// The plan as version 3 wrote it. Throws nlohmann::json::exception where the text is no plan of version 2.
std::string convertedPlan(const std::string& text, int number) {
    const Json old = Json::parse(text);
    Json stages = Json::array();
    std::string trials;
    for (const Json& from : old.at("trials")) {
        const Json trial = convertedTrial(from);
        if (stages.empty() || stages.back() != trial.at("stage")) stages.push_back(trial.at("stage"));
        trials += (trials.empty() ? "\n    " : ",\n    ") + trial.dump();
    }
    return fmt::format(
        "{{\n  \"participant\": {},\n  \"number\": {},\n  \"study\": {},\n  \"study_hash\": {},\n  "
        "\"seed\": {},\n  \"groups\": {{}},\n  \"stages\": {},\n  \"trials\": [{}\n  ]\n}}\n",
        Json(old.at("participant").get<std::string>()).dump(), number,
        Json(old.at("study").get<std::string>()).dump(), Json(old.at("study_hash").get<std::string>()).dump(),
        old.at("seed").get<std::uint64_t>(), stages.dump(), trials);
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
            json = convertedPlan(row.getColumn(2).getString(), number_of.at(participant));
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

/// In the order of version 2's columns: see results/database/schema/step_2.sql.
studies::TrackingSample frameOf(const SQLite::Statement& row) {
    constexpr int head = 9, columns_of_pose = 8;
    studies::TrackingSample sample;
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
    return sample;
}

/// Blocks of up to 64 frames of one trial, or of none. Which form the bytes have they say
/// themselves.
void packFrames(SQLite::Database& database) {
    constexpr std::size_t max_frames = 64;
    SQLite::Statement row(database, "SELECT * FROM before_3_tracking ORDER BY session, frame");
    SQLite::Statement insert(
        database,
        "INSERT INTO tracking_blocks (session, trial_index, first_frame, frames, first_display_time_s, "
        "last_display_time_s, data) VALUES (?, ?, ?, ?, ?, ?, ?)");
    std::vector<studies::TrackingSample> frames;
    std::int64_t session = 0;
    std::optional<int> trial;
    const auto write = [&] {
        if (frames.empty()) return;
        insert.tryReset();
        insert.clearBindings();
        insert.bind(1, session);
        if (trial) insert.bind(2, *trial);
        insert.bind(3, static_cast<std::int64_t>(frames.front().frame));
        insert.bind(4, static_cast<std::int64_t>(frames.size()));
        insert.bind(5, frames.front().display_time_s);
        insert.bind(6, frames.back().display_time_s);
        const std::string data = packTracking(frames);
        insert.bind(7, data.data(), static_cast<int>(data.size()));
        insert.exec();
        frames.clear();
    };
    while (row.executeStep()) {
        const std::int64_t its_session = row.getColumn(0).getInt64();
        const auto its_trial =
            row.getColumn(2).isNull() ? std::nullopt : std::optional(row.getColumn(2).getInt());
        if (its_session != session || its_trial != trial || frames.size() == max_frames) write();
        session = its_session;
        trial = its_trial;
        frames.push_back(frameOf(row));
    }
    write();
}

}  // namespace

Result<void> migrateTo3(SQLite::Database& database, const std::filesystem::path& path) {
    // Renaming must leave alone what refers to the tables: the new ones take their places.
    database.exec(
        "PRAGMA legacy_alter_table = ON; DROP INDEX events_of_session; DROP INDEX tracking_of_trial");
    for (const char* table : old_tables)
        database.exec(fmt::format("ALTER TABLE {} RENAME TO before_3_{}", table, table));
    database.exec("PRAGMA legacy_alter_table = OFF");
    database.exec(step_3_tables);
    database.exec(step_3_rows);
    const auto number_of = numbers(database);
    insertParticipants(database, number_of);
    if (auto done = convertPlans(database, number_of, path); !done) return done;
    packFrames(database);
    for (const char* table : old_tables) database.exec(fmt::format("DROP TABLE before_3_{}", table));
    return {};
}

}  // namespace deixis::results
