#include "results/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "fixtures.hpp"

using namespace deixis;
using results::Durability;
using results::ParticipantLock;
using results::Store;

namespace {

/// Opens that must fail; gives the message.
std::string refusal(const std::filesystem::path& path) {
    const auto store = Store::open(path, Durability::each_answer);
    REQUIRE_FALSE(store.has_value());
    CHECK(store.error().where == path.string());
    CHECK_FALSE(store.error().mend.empty());
    return store.error().message;
}

bool contains(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_SUITE("results/store") {
    TEST_CASE("A response is kept with everything that was shown and done") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct", "stiff"});
        const auto plan = fixtures::plan(study, "P01", 1);
        {
            Store store = fixtures::open(folder / "a.sqlite");
            REQUIRE(store.storePlan(study, plan));
            store.beginSession(fixtures::session("P01", true));
            store.record(studies::Note{"stage_start", -1, {1.0, 1.7e9 + 1.0}, "game"}, plan,
                         fixtures::clips(plan));
            auto response = fixtures::answer(plan.trials[1], 4);
            response.replays = 1;
            response.input = "key";
            store.record(response, plan, fixtures::clips(plan));
            auto choice = fixtures::answer(plan.trials[4], 0);
            choice.pauses = 2;
            choice.paused_s = 7.5;
            store.record(choice, plan, fixtures::clips(plan));
            store.endSession("quit", 1.7e9 + 99.0);
        }
        SQLite::Database database((folder / "a.sqlite").string());
        SQLite::Statement row(database, "SELECT * FROM responses_flat");
        REQUIRE(row.executeStep());
        CHECK(row.getColumn("participant").getString() == "P01");
        CHECK(row.getColumn("trial_index").getInt() == 1);
        CHECK(row.getColumn("stage").getString() == "naturalness");
        CHECK(row.getColumn("system").getString() == "direct");
        CHECK(row.getColumn("rating").getInt() == 4);
        CHECK(row.getColumn("correct").isNull());
        CHECK(row.getColumn("balls").isNull());
        CHECK(row.getColumn("replays").getInt() == 1);
        CHECK(row.getColumn("input").getString() == "key");
        CHECK(row.getColumn("ray_x_m").isNull());
        CHECK(row.getColumn("synthetic").getInt() == 1);
        REQUIRE(row.executeStep());
        CHECK(row.getColumn("stage").getString() == "game");
        CHECK(row.getColumn("system").getString() == "stiff");
        CHECK(row.getColumn("layout").getString() == "across");
        CHECK(row.getColumn("viewer_z_m").getDouble() == 2.0);
        CHECK(row.getColumn("rating").isNull());
        CHECK(row.getColumn("chosen_place").getInt() == 2);
        CHECK(row.getColumn("target_place").getInt() == 1);
        CHECK(row.getColumn("correct").getInt() == 0);
        CHECK(row.getColumn("pauses").getInt() == 2);
        CHECK(row.getColumn("paused_s").getDouble() == 7.5);
        CHECK(row.getColumn("dropped_frames").isNull());  // nothing was tracked
        CHECK(row.getColumn("target_y_m").getDouble() == 1.25);
        CHECK(row.getColumn("distractors").getString() == "[[0.3,1.5,0.5],[-0.3,1,0.5]]");
        // Shown in the order 2, 0, 1: the second distractor, the target, the first distractor.
        CHECK(row.getColumn("balls").getString() == "[[-0.3,1,0.5],[0,1.25,0.75],[0.3,1.5,0.5]]");
        CHECK(row.getColumn("clip_file").getString() == "stiff-T000.bvh");
        CHECK(row.getColumn("clip_hash").getString() == std::string(64, 'c'));
        CHECK(row.getColumn("onset_s").getDouble() == 40.0);
        CHECK(row.getColumn("motion_end_s").getDouble() == 43.0);
        CHECK(row.getColumn("answered_s").getDouble() == 44.25);
        CHECK(row.getColumn("answered_utc").getString() == "2023-11-14T22:14:04.250Z");
        CHECK(row.getColumn("response_time_s").getDouble() == 1.25);
        CHECK(row.getColumn("head_y_m").getDouble() == 1.65);
        CHECK(row.getColumn("head_qw").getDouble() == 1.0);
        CHECK(row.getColumn("ray_dz").getDouble() == -1.0);
        CHECK_FALSE(row.executeStep());
        CHECK(database.execAndGet("SELECT kind || ' ' || detail FROM events").getString() ==
              "stage_start game");
        CHECK(database.execAndGet("SELECT trial_index IS NULL FROM events").getInt() == 1);
        CHECK(database.execAndGet("SELECT outcome FROM sessions").getString() == "quit");
        CHECK(database.execAndGet("SELECT seed FROM plans").getString() == "18446744073709551615");
        CHECK(database.execAndGet("PRAGMA journal_mode").getString() == "wal");
        CHECK(database.execAndGet("SELECT count(*) FROM pragma_foreign_key_check").getInt() == 0);
        CHECK(database.execAndGet("PRAGMA integrity_check").getString() == "ok");
    }

    TEST_CASE("The stored plan comes back as it was, and storing it again changes nothing") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct", "stiff"});
        const auto plan = fixtures::plan(study, "P01", 2);
        Store store = fixtures::open(folder / "a.sqlite");
        CHECK_FALSE(store.plan("P01").has_value());
        REQUIRE(store.storePlan(study, plan));
        REQUIRE(store.storePlan(study, plan));
        const auto back = store.plan("P01");
        REQUIRE(back.has_value());
        CHECK(studies::planJson(*back) == studies::planJson(plan));
        CHECK(store.participants() == std::vector<std::string>{"P01"});
    }

    TEST_CASE("Another plan for the participant and another study are refused by name") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct", "stiff"});
        Store store = fixtures::open(folder / "a.sqlite");
        REQUIRE(store.storePlan(study, fixtures::plan(study, "P01", 1)));
        const auto other_plan = store.storePlan(study, fixtures::plan(study, "P01", 2));
        REQUIRE_FALSE(other_plan);
        CHECK(contains(other_plan.error().message, "another plan for participant P01"));
        auto other = study;
        other.name = "other";
        other.hash = std::string(64, 'b');
        const auto other_study = store.storePlan(other, fixtures::plan(other, "P02", 1));
        REQUIRE_FALSE(other_study);
        CHECK(contains(other_study.error().message, "study 'small' (hash aaaaaaaaaaaa)"));
        CHECK(contains(other_study.error().message, "'other' (hash bbbbbbbbbbbb)"));
        CHECK(store.participants() == std::vector<std::string>{"P01"});
    }

    TEST_CASE("No trial can be answered twice, in the same session or a later one") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        const auto plan = fixtures::plan(study, "P01", 1);
        const auto first = fixtures::answer(plan.trials[1], 5);
        const auto second = fixtures::answer(plan.trials[1], 1);
        Store store = fixtures::open(folder / "a.sqlite");
        REQUIRE(store.storePlan(study, plan));
        store.beginSession(fixtures::session("P01", false));
        store.record(first, plan, fixtures::clips(plan));
        CHECK_THROWS_AS(store.record(second, plan, fixtures::clips(plan)), SQLite::Exception);
        // A refused answer leaves the store usable.
        store.record(fixtures::answer(plan.trials[2], 1), plan, fixtures::clips(plan));
        store.endSession("quit", 1.7e9 + 9.0);
        store.beginSession(fixtures::session("P01", false));
        CHECK_THROWS_AS(store.record(second, plan, fixtures::clips(plan)), SQLite::Exception);
        CHECK(store.answeredTrials("P01") == std::set<int>{1, 2});
        CHECK(store.answeredTrials("P02").empty());
        SQLite::Database reader((folder / "a.sqlite").string());
        CHECK(reader.execAndGet("SELECT rating FROM responses WHERE trial_index = 1").getInt() == 5);
    }

    TEST_CASE("A session takes no other participant's records") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        const auto mine = fixtures::plan(study, "P01", 1);
        const auto theirs = fixtures::plan(study, "P02", 1);
        Store store = fixtures::open(folder / "a.sqlite");
        REQUIRE(store.storePlan(study, mine));
        REQUIRE(store.storePlan(study, theirs));
        const auto response = fixtures::answer(mine.trials[1], 3);
        CHECK_THROWS_AS(store.record(response, mine, fixtures::clips(mine)), std::logic_error);
        store.beginSession(fixtures::session("P01", false));
        CHECK_THROWS_AS(store.record(response, theirs, fixtures::clips(theirs)), std::logic_error);
        CHECK(store.answeredTrials("P02").empty());
    }

    TEST_CASE("A whole run is kept by its commit, and nothing of it without one") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        const auto plan = fixtures::plan(study, "P01", 1);
        for (const bool commit : {false, true}) {
            Store store = fixtures::open(folder / "a.sqlite", Durability::whole_run);
            REQUIRE(store.storePlan(study, plan));
            store.beginSession(fixtures::session("P01", true));
            store.record(fixtures::answer(plan.trials[1], 5), plan, fixtures::clips(plan));
            store.endSession("finished", 1.7e9 + 9.0);
            if (commit) store.commit();
            if (!commit) {
                store = fixtures::open(folder / "b.sqlite");
                CHECK(fixtures::open(folder / "a.sqlite").participants().empty());
            }
        }
        CHECK(fixtures::open(folder / "a.sqlite").answeredTrials("P01") == std::set<int>{1});
        CHECK_FALSE(std::filesystem::exists(folder / "a.sqlite-wal"));
    }
}

TEST_SUITE("results/store durability") {
    TEST_CASE("What was recorded before a kill -9 is there afterwards") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        const auto study = fixtures::study({"direct"});
        const auto plan = fixtures::plan(study, "P01", 2);
        int ready[2];
        REQUIRE(::pipe(ready) == 0);
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            Store store = fixtures::open(path);
            if (!store.storePlan(study, plan)) ::_exit(1);
            store.beginSession(fixtures::session("P01", false));
            store.record(fixtures::answer(plan.trials[1], 5), plan, fixtures::clips(plan));
            store.record(fixtures::answer(plan.trials[2], 2), plan, fixtures::clips(plan));
            store.record(studies::Note{"stimulus_onset", 3, {30.0, 1.7e9}, ""}, plan, fixtures::clips(plan));
            if (::write(ready[1], "x", 1) != 1) ::_exit(1);
            for (;;) ::pause();
        }
        ::close(ready[1]);
        char byte = 0;
        CHECK(::read(ready[0], &byte, 1) == 1);
        ::close(ready[0]);
        ::kill(child, SIGKILL);
        int status = 0;
        ::waitpid(child, &status, 0);
        REQUIRE(WIFSIGNALED(status));

        Store store = fixtures::open(path);
        CHECK(store.answeredTrials("P01") == std::set<int>{1, 2});
        CHECK(store.plan("P01").has_value());
        REQUIRE(store.storePlan(study, plan));
        store.beginSession(fixtures::session("P01", false));
        store.record(fixtures::answer(plan.trials[3], 3), plan, fixtures::clips(plan));
        SQLite::Database reader(path.string());
        CHECK(reader.execAndGet("SELECT count(*) FROM events").getInt() == 1);
        CHECK(reader.execAndGet("SELECT count(*) FROM sessions WHERE outcome IS NULL").getInt() == 2);
        CHECK(reader.execAndGet("PRAGMA integrity_check").getString() == "ok");
    }

    TEST_CASE("A second run of the same participant is refused until the first is gone, even killed") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        int ready[2];
        REQUIRE(::pipe(ready) == 0);
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            const auto lock = ParticipantLock::take(path, "P/01");
            if (!lock || ::write(ready[1], "x", 1) != 1) ::_exit(1);
            for (;;) ::pause();
        }
        ::close(ready[1]);
        char byte = 0;
        CHECK(::read(ready[0], &byte, 1) == 1);
        ::close(ready[0]);
        const auto refused = ParticipantLock::take(path, "P/01");
        REQUIRE_FALSE(refused);
        CHECK(refused.error().where == path.string());
        CHECK(contains(refused.error().message, "participant P/01"));
        CHECK(ParticipantLock::take(path, "P02").has_value());
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        auto lock = ParticipantLock::take(path, "P/01");
        REQUIRE(lock);
        auto moved = std::move(*lock);
        CHECK_FALSE(ParticipantLock::take(path, "P/01"));
    }
}

TEST_SUITE("results/store opening") {
    TEST_CASE("A file that is no database is refused and left as it was") {
        const fixtures::Folder folder;
        std::ofstream(folder / "notes.txt") << "Dear diary, this file is certainly longer than a header.";
        CHECK(contains(refusal(folder / "notes.txt"), "not a SQLite database"));
        CHECK(std::filesystem::file_size(folder / "notes.txt") == 56);
    }

    TEST_CASE("Another program's database is refused and left as it was") {
        const fixtures::Folder folder;
        SQLite::Database(folder / "b.sqlite", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
            .exec("CREATE TABLE photos (id)");
        CHECK(contains(refusal(folder / "b.sqlite"), "another program"));
        SQLite::Database reader((folder / "b.sqlite").string());
        CHECK(reader.execAndGet("PRAGMA journal_mode").getString() == "delete");
        CHECK(reader.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 1);
    }

    TEST_CASE("A newer database is refused with both versions named") {
        const fixtures::Folder folder;
        { Store store = fixtures::open(folder / "a.sqlite"); }
        SQLite::Database(folder / "a.sqlite", SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 7");
        const auto message = refusal(folder / "a.sqlite");
        CHECK(contains(message, "version 7"));
        CHECK(contains(message, "up to 2"));
    }

    TEST_CASE("A database locked by another program is refused") {
        const fixtures::Folder folder;
        { Store store = fixtures::open(folder / "a.sqlite"); }
        SQLite::Database other((folder / "a.sqlite").string(), SQLite::OPEN_READWRITE);
        other.exec("PRAGMA locking_mode = EXCLUSIVE; BEGIN EXCLUSIVE");
        CHECK(contains(refusal(folder / "a.sqlite"), "locked by another program"));
    }

    TEST_CASE("A database held by a writing run is refused as locked") {
        const fixtures::Folder folder;
        const Store run = fixtures::open(folder / "a.sqlite", Durability::whole_run);
        CHECK(contains(refusal(folder / "a.sqlite"), "locked by another program"));
    }

    TEST_CASE("Missing and unwritable folders, and folders in place of files, are refused") {
        const fixtures::Folder folder;
        CHECK(contains(refusal(folder / "nowhere/a.sqlite"), "does not exist"));
        CHECK(contains(refusal(folder / ""), "found a folder"));
        // Not even root can make a file here.
        CHECK(contains(refusal("/proc/a.sqlite"), "cannot be opened or created"));
    }

    TEST_CASE("Read-only files and folders are refused") {
        using std::filesystem::perms;
        const fixtures::Folder folder;
        { Store store = fixtures::open(folder / "a.sqlite"); }
        std::filesystem::permissions(folder / "a.sqlite",
                                     perms::owner_read | perms::group_read | perms::others_read);
        // Permissions do not bind root, so root becomes nobody for a moment.
        const uid_t user = ::geteuid();
        const uid_t nobody = 65534;
        if (user == 0 && ::chown((folder / "").c_str(), nobody, nobody) + ::seteuid(nobody) != 0) {
            MESSAGE("skipped: runs as root and cannot become another user");
            return;
        }
        const auto read_only_file = refusal(folder / "a.sqlite");
        std::filesystem::permissions(folder / "", perms::owner_read | perms::owner_exec);
        const auto read_only_folder = refusal(folder / "new.sqlite");
        std::filesystem::permissions(folder / "", perms::owner_all);
        CHECK(::seteuid(user) == 0);
        CHECK(contains(read_only_file, "can be read but not written"));
        CHECK(contains(read_only_folder, "cannot be opened or created"));
    }
}
