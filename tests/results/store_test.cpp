#include "results/store/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>
#include <vector>

#include "fixtures.hpp"
#include "results/store/participant_lock.hpp"
#include "skipping.hpp"
#include "text.hpp"

using namespace deixis;
using deixis::tests::contains;
using results::Durability;
using results::ParticipantLock;
using results::Store;

namespace {

/// Opens that must fail; gives the message.
std::string rejectionToOpen(const std::filesystem::path& path) {
    const auto store = Store::open(path, Durability::each_answer, std::chrono::milliseconds(100));
    REQUIRE_FALSE(store.has_value());
    CHECK(store.error().where == path.string());
    CHECK_FALSE(store.error().hint.empty());
    return store.error().message;
}

std::set<int> answered(const Store& store, const std::string& participant) {
    std::set<int> out;
    for (const auto& [trial, _] : store.resume(participant, 0.0).answered) out.insert(trial);
    return out;
}

}  // namespace

TEST_SUITE("results/store") {
    TEST_CASE("No trial can be answered twice, in the same session or a later one") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        const auto plan = fixtures::plan(study, "P01", 1);
        const auto first = fixtures::answer(plan.trials[1], 5);
        const auto second = fixtures::answer(plan.trials[1], 1);
        Store store = fixtures::open(folder / "a.sqlite");
        fixtures::store(store, study, plan);
        store.beginSession(fixtures::session("P01", false));
        store.record(first, study, plan, fixtures::clips(plan));
        CHECK_THROWS_AS(store.record(second, study, plan, fixtures::clips(plan)), SQLite::Exception);
        // A rejected answer leaves the store usable.
        store.record(fixtures::answer(plan.trials[2], 1), study, plan, fixtures::clips(plan));
        store.endSession(studies::SessionOutcome::quit, 1.7e9 + 9.0);
        store.beginSession(fixtures::session("P01", false));
        CHECK_THROWS_AS(store.record(second, study, plan, fixtures::clips(plan)), SQLite::Exception);
        CHECK(answered(store, "P01") == std::set<int>{1, 2});
        CHECK(answered(store, "P02").empty());
        SQLite::Database reader((folder / "a.sqlite").string());
        CHECK(reader.execAndGet("SELECT value FROM responses_flat WHERE trial_index = 1").getInt() == 5);
    }

    TEST_CASE("A session takes no other participant's records") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        const auto mine = fixtures::plan(study, "P01", 1);
        const auto theirs = fixtures::plan(study, "P02", 1);
        Store store = fixtures::open(folder / "a.sqlite");
        fixtures::store(store, study, mine);
        fixtures::store(store, study, theirs);
        const auto response = fixtures::answer(mine.trials[1], 3);
        CHECK_THROWS_AS(store.record(response, study, mine, fixtures::clips(mine)), std::logic_error);
        store.beginSession(fixtures::session("P01", false));
        CHECK_THROWS_AS(store.record(response, study, theirs, fixtures::clips(theirs)), std::logic_error);
        CHECK(answered(store, "P02").empty());
    }

    TEST_CASE("A whole run is kept by its commit, and nothing of it without one") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        const auto plan = fixtures::plan(study, "P01", 1);
        for (const bool commit : {false, true}) {
            Store store = fixtures::open(folder / "a.sqlite", Durability::whole_run);
            fixtures::store(store, study, plan);
            store.beginSession(fixtures::session("P01", true));
            store.record(fixtures::answer(plan.trials[1], 5), study, plan, fixtures::clips(plan));
            store.endSession(studies::SessionOutcome::finished, 1.7e9 + 9.0);
            if (commit) store.commit();
            if (!commit) {
                store = fixtures::open(folder / "b.sqlite");
                CHECK(fixtures::open(folder / "a.sqlite").participants().empty());
            }
        }
        CHECK(answered(fixtures::open(folder / "a.sqlite"), "P01") == std::set<int>{1});
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
            if (!store.storePlan(study, fixtures::registration(plan), plan)) ::_exit(1);
            store.beginSession(fixtures::session("P01", false));
            store.record(fixtures::answer(plan.trials[1], 5), study, plan, fixtures::clips(plan));
            store.record(fixtures::answer(plan.trials[2], 2), study, plan, fixtures::clips(plan));
            store.record(studies::Note{studies::NoteKind::stimulus_onset, 3, {30.0, 1.7e9}, ""}, study, plan,
                         fixtures::clips(plan));
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
        CHECK(answered(store, "P01") == std::set<int>{1, 2});
        CHECK(store.plan("P01").has_value());
        fixtures::store(store, study, plan);
        store.beginSession(fixtures::session("P01", false));
        store.record(fixtures::answer(plan.trials[3], 3), study, plan, fixtures::clips(plan));
        SQLite::Database reader(path.string());
        CHECK(reader.execAndGet("SELECT count(*) FROM events").getInt() == 1);
        CHECK(reader.execAndGet("SELECT count(*) FROM sessions WHERE outcome IS NULL").getInt() == 2);
        CHECK(reader.execAndGet("PRAGMA integrity_check").getString() == "ok");
    }

    TEST_CASE("A second run of the same participant is rejected until the first is gone, even killed") {
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
        const auto rejected = ParticipantLock::take(path, "P/01");
        REQUIRE_FALSE(rejected);
        CHECK(rejected.error().where == path.string());
        CHECK(contains(rejected.error().message, "participant P/01"));
        CHECK(ParticipantLock::take(path, "P02").has_value());
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        auto lock = ParticipantLock::take(path, "P/01");
        REQUIRE(lock);
        auto moved = std::move(*lock);
        CHECK_FALSE(ParticipantLock::take(path, "P/01"));
        CHECK_FALSE(ParticipantLock::tryTake(path, "P/01").value().has_value());
    }

    TEST_CASE("No lock's file is left behind, and among many who want a lock one at a time has it") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        { const auto lock = ParticipantLock::take(path, "P01"); }
        CHECK(std::filesystem::is_empty(folder / ""));
        std::atomic<int> holders{0}, max{0}, taken{0};
        std::vector<std::thread> threads;
        for (int i = 0; i < 8; ++i)
            threads.emplace_back([&] {
                for (int turn = 0; turn < 300; ++turn) {
                    const auto lock = ParticipantLock::tryTake(path, "P01");
                    if (!lock || !*lock) continue;
                    ++taken;
                    max = std::max(max.load(), ++holders);
                    --holders;
                }
            });
        for (std::thread& thread : threads) thread.join();
        CHECK(max == 1);
        CHECK(taken > 0);
        CHECK(std::filesystem::is_empty(folder / ""));
    }
}

TEST_SUITE("results/store opening") {
    TEST_CASE("A file that is no database is rejected and left as it was") {
        const fixtures::Folder folder;
        std::ofstream(folder / "notes.txt") << "Dear diary, this file is certainly longer than a header.";
        CHECK(contains(rejectionToOpen(folder / "notes.txt"), "not a SQLite database"));
        CHECK(std::filesystem::file_size(folder / "notes.txt") == 56);
    }

    TEST_CASE("Another program's database is rejected and left as it was") {
        const fixtures::Folder folder;
        SQLite::Database(folder / "b.sqlite", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
            .exec("CREATE TABLE photos (id)");
        CHECK(contains(rejectionToOpen(folder / "b.sqlite"), "another program"));
        SQLite::Database reader((folder / "b.sqlite").string());
        CHECK(reader.execAndGet("PRAGMA journal_mode").getString() == "delete");
        CHECK(reader.execAndGet("SELECT count(*) FROM sqlite_schema").getInt() == 1);
    }

    TEST_CASE("A newer database is rejected with both versions named") {
        const fixtures::Folder folder;
        { Store store = fixtures::open(folder / "a.sqlite"); }
        SQLite::Database(folder / "a.sqlite", SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 7");
        const auto message = rejectionToOpen(folder / "a.sqlite");
        CHECK(contains(message, "version 7"));
        CHECK(contains(message, "up to 6"));
    }

    TEST_CASE("A database locked by another program is rejected") {
        const fixtures::Folder folder;
        { Store store = fixtures::open(folder / "a.sqlite"); }
        SQLite::Database other((folder / "a.sqlite").string(), SQLite::OPEN_READWRITE);
        other.exec("PRAGMA locking_mode = EXCLUSIVE; BEGIN EXCLUSIVE");
        CHECK(contains(rejectionToOpen(folder / "a.sqlite"), "locked by another program"));
    }

    TEST_CASE("A database held by a writing run is rejected as locked") {
        const fixtures::Folder folder;
        const Store run = fixtures::open(folder / "a.sqlite", Durability::whole_run);
        CHECK(contains(rejectionToOpen(folder / "a.sqlite"), "locked by another program"));
    }

    TEST_CASE("Missing and unwritable folders, and folders in place of files, are rejected") {
        const fixtures::Folder folder;
        CHECK(contains(rejectionToOpen(folder / "nowhere/a.sqlite"), "does not exist"));
        CHECK(contains(rejectionToOpen(folder / ""), "found a folder"));
        // Not even root can make a file here.
        CHECK(contains(rejectionToOpen("/proc/a.sqlite"), "cannot be opened or created"));
    }

    TEST_CASE("Read-only files and folders are rejected") {
        using std::filesystem::perms;
        const fixtures::Folder folder;
        { Store store = fixtures::open(folder / "a.sqlite"); }
        std::filesystem::permissions(folder / "a.sqlite",
                                     perms::owner_read | perms::group_read | perms::others_read);
        // Permissions do not bind root, so root becomes nobody for a moment.
        const uid_t user = ::geteuid();
        const uid_t nobody = 65534;
        if (user == 0 && ::chown((folder / "").c_str(), nobody, nobody) + ::seteuid(nobody) != 0) {
            deixis::tests::tellSkipped("runs as root and cannot become another user");
            return;
        }
        const auto read_only_file = rejectionToOpen(folder / "a.sqlite");
        std::filesystem::permissions(folder / "", perms::owner_read | perms::owner_exec);
        const auto read_only_folder = rejectionToOpen(folder / "new.sqlite");
        std::filesystem::permissions(folder / "", perms::owner_all);
        CHECK(::seteuid(user) == 0);
        CHECK(contains(read_only_file, "can be read but not written"));
        CHECK(contains(read_only_folder, "cannot be opened or created"));
    }
}
