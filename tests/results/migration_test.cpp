// Databases of earlier versions.
#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>

#include <cmath>

#include "core/files.hpp"
#include "fixtures.hpp"
#include "results/participants.hpp"
#include "results/tracking_blocks.hpp"

using namespace deixis;
using results::Durability;
using results::Store;

namespace {

/// Made by the program of that time; see the files' heads.
void makeVersion(int version, const std::filesystem::path& path) {
    const auto sql = readFile(std::filesystem::path(DEIXIS_SOURCE_DIR) /
                              fmt::format("tests/results/reference/database_version_{}.sql", version));
    REQUIRE(sql);
    SQLite::Database(path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(*sql);
}

/// All rows of a query, each value with its type.
std::string rows(SQLite::Database& database, const std::string& query) {
    SQLite::Statement row(database, query);
    std::string out;
    while (row.executeStep()) {
        for (int i = 0; i < row.getColumnCount(); ++i) {
            const auto value = row.getColumn(i);
            out += fmt::format("{}{}", i > 0 ? "|" : "", value.isNull() ? "NULL" : value.getString());
        }
        out += "\n";
    }
    return out;
}

std::string rows(const std::filesystem::path& path, const std::string& query) {
    SQLite::Database database(path.string(), SQLite::OPEN_READONLY, 1000);
    return rows(database, query);
}

std::string schema(const std::filesystem::path& path) {
    return rows(path, "SELECT type, name, sql FROM sqlite_schema ORDER BY type, name");
}

/// What version 2 (or 1, but for paused_s) says in its words, and version 4 in its own.
struct Told {
    const char* what;
    const char* old_words;
    const char* new_words;
};

constexpr const char* same = nullptr;
const Told told[]{
    {"study", "SELECT id, name, title, hash, source, alpha FROM study", same},
    {"steps of the scale", "SELECT rating_steps FROM study",
     "SELECT scale_high - scale_low + 1 FROM stages WHERE name = 'naturalness'"},
    {"systems", "SELECT position, name, generator, manifest FROM systems ORDER BY position", same},
    {"layouts", "SELECT * FROM layouts ORDER BY position", same},
    {"participants", "SELECT id FROM participants ORDER BY id", same},
    {"seeds", "SELECT participant, seed FROM plans ORDER BY participant", same},
    {"trials",
     "SELECT participant, trial_index, stage || iif(practice, '-practice', ''), practice, system, target_id, "
     "layout, target_x_m, target_y_m, target_z_m, iif(stage = 'game', distractors, NULL), balls, "
     "target_place FROM trials ORDER BY 1, 2",
     "SELECT t.participant, t.trial_index, stage, practice, s.system, target_id, layout, target_x_m, "
     "target_y_m, target_z_m, distractors, balls, target_place FROM trials AS t JOIN trial_stimuli AS s "
     "USING "
     "(participant, trial_index) ORDER BY 1, 2"},
    {"sessions", "SELECT * FROM sessions ORDER BY id", same},
    {"responses",
     "SELECT id, participant, trial_index, session, chosen_place, correct, onset_s, onset_utc_s, "
     "motion_end_s, motion_end_utc_s, answered_s, answered_utc_s, response_time_s, replays, pauses, input, "
     "head_x_m, head_y_m, head_z_m, head_qw, head_qx, head_qy, head_qz, ray_x_m, ray_y_m, ray_z_m, ray_dx, "
     "ray_dy, ray_dz FROM responses ORDER BY id",
     same},
    {"ratings", "SELECT id, 'rating', 1.0 * rating FROM responses WHERE rating IS NOT NULL ORDER BY id",
     "SELECT response, question, value FROM answers ORDER BY response"},
    {"clips", "SELECT id, clip_file, clip_hash, replays + 1 FROM responses ORDER BY id",
     "SELECT response, clip_file, clip_hash, plays FROM response_stimuli ORDER BY response"},
    {"events", "SELECT * FROM events ORDER BY id", same},
};
const Told told_of_2[]{
    {"pauses", "SELECT id, paused_s FROM responses ORDER BY id", same},
    {"properties", "SELECT * FROM session_properties ORDER BY 1, 2", same},
    {"joints", "SELECT session, frame, hand, hex(joints), hex(flags) FROM hand_joints ORDER BY 1, 2", same},
    {"tallies", "SELECT * FROM trial_tracking ORDER BY 1, 2", same},
};

/// Brings a copy up to date and compares.
template <typename What>
void checkTold(const std::filesystem::path& old, const std::filesystem::path& fresh, const What& what) {
    for (const Told& one : what) {
        INFO(one.what);
        const std::string before = rows(old, one.old_words);
        CHECK_FALSE(before.empty());
        CHECK(rows(fresh, one.new_words == same ? one.old_words : one.new_words) == before);
    }
}

}  // namespace

TEST_SUITE("results/migration") {
    TEST_CASE("Databases of versions 1 and 2 are brought to version 4 with all that they hold") {
        for (const int version : {1, 2}) {
            INFO("version " << version);
            const fixtures::Folder folder;
            makeVersion(version, folder / "old.sqlite");
            makeVersion(version, folder / "a.sqlite");
            REQUIRE(rows(folder / "old.sqlite", "PRAGMA user_version") == fmt::format("{}\n", version));
            { Store store = fixtures::open(folder / "a.sqlite"); }
            { Store fresh = fixtures::open(folder / "b.sqlite"); }
            checkTold(folder / "old.sqlite", folder / "a.sqlite", told);
            if (version == 2) checkTold(folder / "old.sqlite", folder / "a.sqlite", told_of_2);
            const auto path = folder / "a.sqlite";
            CHECK(rows(path, "PRAGMA user_version") == "4\n");
            CHECK(rows(path, "PRAGMA application_id") == fmt::format("{}\n", 0x44584953));
            CHECK(rows(path, "PRAGMA integrity_check") == "ok\n");
            CHECK(rows(path, "SELECT count(*) FROM pragma_foreign_key_check") == "0\n");
            CHECK(rows(path,
                       "SELECT name, kind, practice_of, measure, scale_low, scale_high FROM stages "
                       "ORDER BY position") ==
                  "naturalness-practice|rating|naturalness|naturalness|1|5\n"
                  "naturalness|rating|NULL|naturalness|1|5\n"
                  "game-practice|referential-game|game|NULL|NULL|NULL\n"
                  "game|referential-game|NULL|NULL|NULL|NULL\n");
            CHECK(rows(path, "SELECT status, count(*) FROM responses GROUP BY status") ==
                  (version == 1 ? "answered|7\n" : "answered|16\n"));
            CHECK(schema(path) == schema(folder / "b.sqlite"));
        }
    }

    TEST_CASE("A database of version 3 keeps its withdrawals, and says of none of them whose it was") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        { Store store = fixtures::open(path); }
        const std::string columns = "SELECT * FROM pragma_table_info('withdrawals')";
        const std::string newest = rows(path, columns);
        SQLite::Database(path, SQLite::OPEN_READWRITE)
            .exec(
                "ALTER TABLE withdrawals DROP COLUMN participant_hash; INSERT INTO withdrawals VALUES (1, "
                "1.7e9);"
                "PRAGMA user_version = 3");
        CHECK(results::listParticipants(path)->withdrawn == 1);
        CHECK(rows(path, "PRAGMA user_version") == "3\n");
        { Store store = fixtures::open(path); }
        CHECK(rows(path, "PRAGMA user_version") == "4\n");
        CHECK(rows(path, columns) == newest);
        CHECK(rows(path, "SELECT utc_s, participant_hash IS NULL FROM withdrawals") == "1700000000.0|1\n");
    }

    TEST_CASE("Every tracked frame of version 2 is there afterwards, in blocks of one trial") {
        const fixtures::Folder folder;
        makeVersion(2, folder / "old.sqlite");
        makeVersion(2, folder / "a.sqlite");
        { Store store = fixtures::open(folder / "a.sqlite"); }
        SQLite::Database old((folder / "old.sqlite").string());
        SQLite::Database database((folder / "a.sqlite").string());
        // 150 frames: 10 of no trial, 110 of trial 3 (7 are missing after the 80th), 30 of trial 4.
        CHECK(rows(database,
                   "SELECT session, trial_index, first_frame, frames FROM tracking_blocks ORDER BY "
                   "first_frame") == "3|NULL|1000|10\n3|3|1010|64\n3|3|1074|46\n3|4|1127|30\n");
        SQLite::Statement frame(old, "SELECT * FROM tracking ORDER BY frame");
        SQLite::Statement block(database, "SELECT data FROM tracking_blocks ORDER BY first_frame");
        int frames = 0;
        const char* poses[]{"head", "left_aim", "right_aim", "left_grip", "right_grip", "gaze"};
        while (block.executeStep()) {
            const auto samples = results::unpackTracking(block.getColumn(0).getString());
            REQUIRE(samples);
            for (const auto& sample : *samples) {
                REQUIRE(frame.executeStep());
                ++frames;
                const auto number = [&](const std::string& column) {
                    return frame.getColumn(column.c_str()).getDouble();
                };
                CHECK(static_cast<double>(sample.frame) == number("frame"));
                CHECK(std::abs(sample.display_time_s - number("display_time_s")) < 0.6e-6);
                CHECK(std::abs(sample.begun_s - number("begun_s")) < 0.6e-6);
                CHECK(std::abs(sample.submitted_s - number("submitted_s")) < 0.6e-6);
                CHECK(sample.dropped_frames == static_cast<int>(number("dropped_frames")));
                CHECK(sample.rendered == (number("rendered") == 1.0));
                CHECK(std::abs(sample.off_place_m - number("off_place_m")) < 0.6 / 65536.0);
                const studies::TrackedPose nothing;
                const studies::TrackedPose* got[]{&sample.head,    &sample.aim[0],  &sample.aim[1],
                                                  &sample.grip[0], &sample.grip[1], nullptr};
                got[5] = sample.gaze ? &*sample.gaze : &nothing;
                CHECK(sample.gaze.has_value() == !frame.getColumn("gaze_validity").isNull());
                for (std::size_t i = 0; i < 6; ++i) {
                    const std::string name = poses[i];
                    const auto& pose = got[i]->stage_from_device;
                    const int validity = (got[i]->position_valid ? 1 : 0) +
                                         (got[i]->orientation_valid ? 2 : 0) + (got[i]->tracked ? 4 : 0);
                    CHECK(validity == static_cast<int>(number(name + "_validity")));
                    if (got[i]->position_valid)
                        CHECK(std::abs(pose.position.y - number(name + "_y_m")) < 0.6 / 65536.0);
                    if (got[i]->orientation_valid)
                        CHECK(std::abs(pose.orientation.z - number(name + "_qz")) < 0.6 / 32768.0);
                }
            }
        }
        CHECK(frames == 150);
        CHECK_FALSE(frame.executeStep());
    }

    TEST_CASE("The paused time that version 1 took off a response time is found again") {
        const fixtures::Folder folder;
        makeVersion(1, folder / "a.sqlite");
        { Store store = fixtures::open(folder / "a.sqlite"); }
        CHECK(rows(folder / "a.sqlite", "SELECT pauses, paused_s, count(*) FROM responses GROUP BY 1, 2") ==
              "0|0.0|6\n1|0.5|1\n");
    }

    TEST_CASE("Plans of earlier versions become plans of today, and what was answered is known") {
        const fixtures::Folder folder;
        makeVersion(1, folder / "a.sqlite");
        Store store = fixtures::open(folder / "a.sqlite");
        const auto plan = store.plan("S001");
        REQUIRE(plan);
        CHECK(plan->number == 1);
        CHECK(plan->stages ==
              std::vector<std::string>{"naturalness-practice", "naturalness", "game-practice", "game"});
        REQUIRE(plan->trials.size() == 10);
        CHECK(plan->trials[0].practice);
        CHECK(plan->trials[0].stimuli[0] == studies::Stimulus{"direct", "T071"});
        CHECK(plan->trials[0].target == Vec3(-1.3272, 0.5871, 1.7329));
        CHECK(plan->trials[9].kind == studies::StageKind::game);
        CHECK(plan->trials[9].distractors.size() == 2);
        CHECK(plan->trials[9].ball_order.size() == 3);
        const auto resume = store.resume("S001", 1.8e9);
        std::set<int> answered;
        for (const auto& [trial, _] : resume.answered) answered.insert(trial);
        CHECK(answered == std::set<int>{1, 2, 3, 4, 6, 7, 8});
        CHECK(resume.begun.contains(9));
        CHECK(store.registration("S001")->language == "en");

        // And a session of it can go on.
        studies::Study study;
        for (const auto& name : plan->stages) {
            study.stages.push_back(fixtures::stage(
                name, name.starts_with("game") ? studies::StageKind::game : studies::StageKind::rating));
        }
        store.beginSession(fixtures::session("S001", true));
        store.record(fixtures::answer(plan->trials[9], 1), study, *plan, fixtures::clips(*plan));
        store.recordTracking(std::vector<results::TrackedFrame>{{fixtures::frame(1), 9}}, {});
        CHECK(rows(folder / "a.sqlite", "SELECT count(*) FROM responses_flat") == "8\n");
    }

    TEST_CASE("Participants get the number that their id ends in, or the next one that is free") {
        const fixtures::Folder folder;
        makeVersion(2, folder / "a.sqlite");
        SQLite::Database(folder / "a.sqlite", SQLite::OPEN_READWRITE)
            .exec("INSERT INTO participants VALUES ('X2'), ('anna'), ('P40')");
        { Store store = fixtures::open(folder / "a.sqlite"); }
        CHECK(rows(folder / "a.sqlite", "SELECT id, number FROM participants ORDER BY id") ==
              "P40|40\nS001|1\nS002|2\nX2|41\nanna|42\n");
    }

    TEST_CASE("Whoever only reads an old database leaves it as it is") {
        const fixtures::Folder folder;
        makeVersion(2, folder / "a.sqlite");
        const auto bytes = readFile(folder / "a.sqlite").value();
        const auto list = results::listParticipants(folder / "a.sqlite");
        REQUIRE(list);
        REQUIRE(list->rows.size() == 2);
        CHECK(list->rows[1].id == "S002");
        CHECK(list->rows[1].sessions == 2);
        CHECK(list->rows[1].answered == 8);
        CHECK(readFile(folder / "a.sqlite").value() == bytes);
        CHECK_FALSE(std::filesystem::exists(folder / "a.sqlite-wal"));
    }

    TEST_CASE("A migration that fails leaves the database as it was") {
        const char* in_the_way[]{"CREATE TABLE stages (mine)", "UPDATE plans SET json = 'no plan'",
                                 "PRAGMA foreign_keys = OFF; UPDATE events SET session = 99 WHERE id = 1"};
        for (const char* sql : in_the_way) {
            INFO(sql);
            const fixtures::Folder folder;
            makeVersion(2, folder / "a.sqlite");
            SQLite::Database(folder / "a.sqlite", SQLite::OPEN_READWRITE).exec(sql);
            const auto before = schema(folder / "a.sqlite");
            const auto refused = Store::open(folder / "a.sqlite", Durability::each_answer);
            REQUIRE_FALSE(refused);
            CHECK(refused.error().where == (folder / "a.sqlite").string());
            CHECK_FALSE(results::listParticipants(folder / "a.sqlite"));
            CHECK(rows(folder / "a.sqlite", "PRAGMA user_version") == "2\n");
            CHECK(schema(folder / "a.sqlite") == before);
            CHECK(rows(folder / "a.sqlite", "SELECT count(*) FROM responses") == "16\n");
        }
    }
}
