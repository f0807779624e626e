// Databases of earlier versions.
#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>

#include <cmath>
#include <regex>
#include <set>

#include "core/files.hpp"
#include "core/hash.hpp"
#include "fixtures.hpp"
#include "old_databases.hpp"
#include "results/copies/data_export.hpp"
#include "results/copies/merge.hpp"
#include "results/database/tracking_blocks.hpp"
#include "results/participants/participants.hpp"

using namespace deixis;
using fixtures::makeVersion;
using results::Durability;
using results::Store;

namespace {

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

/// The same without comments, quotes and spaces, which tell only by which way the tables came about.
std::string plainSchema(const std::filesystem::path& path) {
    std::string out = std::regex_replace(schema(path), std::regex("--[^\n]*|\""), "");
    out = std::regex_replace(out, std::regex("\\s+"), " ");
    return std::regex_replace(out, std::regex(" ?([(),]) ?"), "$1");
}

/// What version 2 (or 1, but for paused_s) says in its words, and the newest version in its own.
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
     "USING (participant, trial_index) LEFT JOIN game_trials USING (participant, trial_index) ORDER BY 1, 2"},
    {"sessions", "SELECT * FROM sessions ORDER BY id", same},
    {"responses",
     "SELECT id, participant, trial_index, session, chosen_place, correct, onset_s, onset_utc_s, "
     "motion_end_s, motion_end_utc_s, answered_s, answered_utc_s, response_time_s, replays, pauses, input, "
     "head_x_m, head_y_m, head_z_m, head_qw, head_qx, head_qy, head_qz, ray_x_m, ray_y_m, ray_z_m, ray_dx, "
     "ray_dy, ray_dz FROM responses ORDER BY id",
     "SELECT id, r.participant, r.trial_index, session, chosen_place, correct, onset_s, onset_utc_s, "
     "motion_end_s, motion_end_utc_s, answered_s, answered_utc_s, response_time_s, replays, pauses, input, "
     "head_x_m, head_y_m, head_z_m, head_qw, head_qx, head_qy, head_qz, ray_x_m, ray_y_m, ray_z_m, ray_dx, "
     "ray_dy, ray_dz FROM responses AS r LEFT JOIN game_choices AS g ON g.response = r.id ORDER BY id"},
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
    TEST_CASE("From every version the tables become those of a new database") {
        const fixtures::Folder folder;
        { Store store = fixtures::open(folder / "new.sqlite"); }
        const std::string fresh = plainSchema(folder / "new.sqlite");
        for (const int version : {1, 2, 3, 4, 5}) {
            INFO("version " << version);
            const auto path = folder / fmt::format("{}.sqlite", version).c_str();
            makeVersion(version, path);
            REQUIRE(rows(path, "PRAGMA user_version") == fmt::format("{}\n", version));
            CHECK(plainSchema(path) != fresh);
            { Store store = fixtures::open(path); }
            CHECK(plainSchema(path) == fresh);
            for (const char* known : {"PRAGMA user_version", "PRAGMA application_id"})
                CHECK(rows(path, known) == rows(folder / "new.sqlite", known));
            CHECK(rows(path, "PRAGMA integrity_check") == "ok\n");
            CHECK(rows(path, "SELECT count(*) FROM pragma_foreign_key_check") == "0\n");
        }
    }

    TEST_CASE("What versions 3, 4 and 5 hold is there afterwards, each value in each column") {
        for (const int version : {3, 4, 5}) {
            const fixtures::Folder folder;
            makeVersion(version, folder / "old.sqlite");
            makeVersion(version, folder / "a.sqlite");
            { Store store = fixtures::open(folder / "a.sqlite"); }
            SQLite::Database old((folder / "old.sqlite").string());
            SQLite::Database now((folder / "a.sqlite").string());
            SQLite::Statement table(old, "SELECT name FROM sqlite_schema WHERE type = 'table'");
            int tables = 0;
            while (table.executeStep()) {
                const std::string name = table.getColumn(0).getString();
                INFO("version " << version << ", table " << name);
                std::string columns;
                SQLite::Statement column(old, "SELECT name FROM pragma_table_info(?)");
                column.bind(1, name);
                while (column.executeStep())
                    if (column.getColumn(0).getString() != "participant_hash")
                        columns += fmt::format("{}quote({})", columns.empty() ? "" : ", ",
                                               column.getColumn(0).getString());
                const auto query = [&](const char* of_game) {
                    return fmt::format("SELECT {0} FROM {1}{2} ORDER BY {0}", columns, name, of_game);
                };
                const std::string before = rows(old, query(""));
                CHECK_FALSE(before.empty());
                // What the game kept in these two stands as columns of its views.
                CHECK(before ==
                      rows(now, query(name == "trials" ? " LEFT JOIN game_trials USING (participant, "
                                                         "trial_index)"
                                      : name == "responses"
                                          ? " LEFT JOIN (SELECT response AS id, chosen_place, correct "
                                            "FROM game_choices) USING (id)"
                                          : "")));
                ++tables;
            }
            CHECK(tables == (version == 5 ? 25 : 24));
        }
    }

    TEST_CASE(
        "Answers of version 5 keep the hashes that they had, and a kept value that was changed is noticed") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        makeVersion(5, path);
        const std::string hashes = "SELECT id, hash FROM responses ORDER BY id";
        const std::string before = rows(path, hashes);
        { Store store = fixtures::open(path); }
        CHECK(rows(path, hashes) == before);
        // Opened once more they are all compared with what is stored: those of the game, too.
        REQUIRE(results::listParticipants(path));
        CHECK(rows(path,
                   "SELECT count(*) FROM responses AS r JOIN game_choices AS g ON g.response = r.id "
                   "WHERE r.hash IS NOT NULL AND g.correct IS NOT NULL") == "4\n");
        const char* changes[]{"UPDATE response_values SET value = 1 - value WHERE name = 'correct'",
                              "UPDATE response_values SET value = value + 0.25 WHERE name = 'chosen_place'",
                              "DELETE FROM response_values",
                              "INSERT INTO response_values SELECT id, 'more', NULL, 'x' FROM responses",
                              "UPDATE trial_values SET value = value + 1 WHERE name = 'target_place'",
                              "UPDATE trial_values SET text = '[]' WHERE name = 'balls'"};
        for (const char* change : changes) {
            INFO(change);
            const auto changed = folder / "changed.sqlite";
            std::filesystem::copy_file(path, changed, std::filesystem::copy_options::overwrite_existing);
            SQLite::Database(changed.string(), SQLite::OPEN_READWRITE).exec(change);
            const auto rejected = results::listParticipants(changed);
            REQUIRE_FALSE(rejected);
            CHECK(rejected.error().message.find("not as it was written") != std::string::npos);
        }
    }

    TEST_CASE("Plans of versions 1 and 2 become what the program of version 4 made of them, byte by byte") {
        const fixtures::Folder folder;
        const char* hashes[]{"1558f17b0555998929736e9ad13cc63e74212e1d182e88b0eafc47c20da01924\n",
                             "1558f17b0555998929736e9ad13cc63e74212e1d182e88b0eafc47c20da01924\n6843556d24de3"
                             "7db9a8ba4f568753bda11bb47ae759ae28d8f189fed1579f6de\n"};
        for (const int version : {1, 2}) {
            const auto path = folder / fmt::format("{}.sqlite", version).c_str();
            makeVersion(version, path);
            { Store store = fixtures::open(path); }
            CHECK(rows(path, "SELECT hash FROM plans ORDER BY participant") == hashes[version - 1]);
            SQLite::Database database(path.string());
            SQLite::Statement plan(database, "SELECT hash, json FROM plans");
            while (plan.executeStep())
                CHECK(plan.getColumn(0).getString() == sha256Hex(plan.getColumn(1).getString()));
        }
    }

    TEST_CASE("Copies of a database that are brought up to date one by one give a participant one token") {
        const std::string tokens = "SELECT id, token FROM participants ORDER BY id";
        for (const int version : {1, 2, 3, 4}) {
            INFO("version " << version);
            const fixtures::Folder folder;
            for (const char* name : {"a.sqlite", "b.sqlite"}) makeVersion(version, folder / name);
            // A copy made early in everybody's first session.
            std::string early =
                "PRAGMA foreign_keys = OFF; DELETE FROM responses; DELETE FROM events WHERE id NOT IN "
                "(SELECT min(e.id) FROM events AS e JOIN sessions AS s ON s.id = e.session GROUP BY "
                "participant);"
                "DELETE FROM sessions WHERE id NOT IN (SELECT min(id) FROM sessions GROUP BY participant);"
                "UPDATE sessions SET outcome = NULL, ended_utc_s = NULL;";
            if (version > 1)
                early +=
                    "DELETE FROM session_properties; DELETE FROM trial_tracking; DELETE FROM hand_joints;";
            if (version == 2) early += "DELETE FROM tracking;";
            if (version > 2)
                early += "DELETE FROM tracking_blocks; DELETE FROM answers; DELETE FROM response_stimuli;";
            SQLite::Database((folder / "b.sqlite").string(), SQLite::OPEN_READWRITE).exec(early);
            for (const char* name : {"a.sqlite", "b.sqlite"}) {
                Store store = fixtures::open(folder / name);
            }
            CHECK(rows(folder / "a.sqlite", tokens) == rows(folder / "b.sqlite", tokens));
            CHECK(rows(folder / "a.sqlite",
                       "SELECT count(*), count(DISTINCT token) = count(*), min(length(token)) FROM "
                       "participants") == (version == 1 ? "1|1|32\n" : "2|1|32\n"));
        }
        // Another first moment, another token: the id does not tell it.
        const fixtures::Folder folder;
        for (const char* name : {"a.sqlite", "b.sqlite"}) makeVersion(4, folder / name);
        SQLite::Database((folder / "b.sqlite").string(), SQLite::OPEN_READWRITE)
            .exec("UPDATE sessions SET started_utc_s = started_utc_s + 0.001");
        for (const char* name : {"a.sqlite", "b.sqlite"}) {
            Store store = fixtures::open(folder / name);
        }
        CHECK(rows(folder / "a.sqlite", tokens) != rows(folder / "b.sqlite", tokens));
    }

    TEST_CASE("Who was registered and never began gets a token that no id tells, with the first session") {
        const fixtures::Folder folder;
        const std::string token = "SELECT token FROM participants WHERE id = 'LATE-17'";
        std::set<std::string> drawn;
        for (const char* name : {"a.sqlite", "b.sqlite"}) {
            makeVersion(4, folder / name);
            SQLite::Database((folder / name).string(), SQLite::OPEN_READWRITE)
                .exec(
                    "INSERT INTO participants (id, number, language, registered_utc_s) VALUES "
                    "('LATE-17', 817, 'en', 0.0); INSERT INTO plans (participant, seed, hash, json) SELECT "
                    "'LATE-17', seed, hash, json FROM plans LIMIT 1");
            Store store = fixtures::open(folder / name);
            CHECK(rows(folder / name, token) == "NULL\n");
        }
        // Copies that were brought up to date one by one are still one person's.
        REQUIRE(results::mergeDatabases({folder / "a.sqlite", folder / "b.sqlite"}, folder / "both.sqlite"));
        CHECK(rows(folder / "both.sqlite", "SELECT count(*), count(DISTINCT token) FROM participants") ==
              "3|2\n");
        for (const char* name : {"a.sqlite", "b.sqlite"}) {
            Store store = fixtures::open(folder / name);
            store.beginSession(fixtures::session("LATE-17", false));
            drawn.insert(rows(folder / name, token));
            store.beginSession(fixtures::session("LATE-17", false));
            drawn.insert(rows(folder / name, token));  // the same: it stays
        }
        CHECK(drawn.size() == 2);
        CHECK(drawn.begin()->size() == 33);
        // Withdrawn before ever beginning, there is nothing that could be guessed.
        REQUIRE(results::withdrawParticipant(folder / "both.sqlite", "LATE-17", 1.8e9));
        CHECK(rows(folder / "both.sqlite", "SELECT token IS NULL FROM withdrawals WHERE utc_s = 1.8e9") ==
              "1\n");
    }

    TEST_CASE("The hash by which version 4 gave away who withdrew is gone, from the file's bytes too") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        makeVersion(4, path);
        const std::string hash = "8ba36146fd25ce218d9a79d500c2eb3b39947d7fbce6476fd4af6ec1568e1a25";
        REQUIRE(readFile(path)->find(hash) != std::string::npos);
        { Store store = fixtures::open(path); }
        CHECK(rows(path, "SELECT utc_s > 1.7e9, token IS NULL FROM withdrawals") == "1|1\n");
        for (const auto& file : std::filesystem::directory_iterator(folder / ""))
            CHECK(readFile(file.path())->find(hash) == std::string::npos);
    }

    TEST_CASE("Databases of versions 1 and 2 are brought to the newest one with all that they hold") {
        for (const int version : {1, 2}) {
            INFO("version " << version);
            const fixtures::Folder folder;
            makeVersion(version, folder / "old.sqlite");
            makeVersion(version, folder / "a.sqlite");
            { Store store = fixtures::open(folder / "a.sqlite"); }
            checkTold(folder / "old.sqlite", folder / "a.sqlite", told);
            if (version == 2) checkTold(folder / "old.sqlite", folder / "a.sqlite", told_of_2);
            const auto path = folder / "a.sqlite";
            CHECK(rows(path,
                       "SELECT name, kind, practice_of, measure, scale_low, scale_high FROM stages "
                       "ORDER BY position") ==
                  "naturalness-practice|rating|naturalness|naturalness|1|5\n"
                  "naturalness|rating|NULL|naturalness|1|5\n"
                  "game-practice|referential-game|game|NULL|NULL|NULL\n"
                  "game|referential-game|NULL|NULL|NULL|NULL\n");
            CHECK(rows(path, "SELECT status, count(*) FROM responses GROUP BY status") ==
                  (version == 1 ? "answered|7\n" : "answered|16\n"));
        }
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
            const auto rejected = Store::open(folder / "a.sqlite", Durability::each_answer);
            REQUIRE_FALSE(rejected);
            CHECK(rejected.error().where == (folder / "a.sqlite").string());
            CHECK_FALSE(results::listParticipants(folder / "a.sqlite"));
            CHECK(rows(folder / "a.sqlite", "PRAGMA user_version") == "2\n");
            CHECK(schema(folder / "a.sqlite") == before);
            CHECK(rows(folder / "a.sqlite", "SELECT count(*) FROM responses") == "16\n");
        }
    }
}
