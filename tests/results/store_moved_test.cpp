// A database whose file somebody renames, deletes or replaces while a session writes to it.
#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <functional>

#include "fixtures.hpp"
#include "results/answers/response_table.hpp"
#include "results/participants/participants.hpp"
#include "results/store/store.hpp"
#include "text.hpp"

using namespace deixis;
using deixis::tests::contains;
using results::Durability;
using results::Store;

namespace fs = std::filesystem;

namespace {

int answersIn(const fs::path& database) {
    return SQLite::Database(database.string()).execAndGet("SELECT count(*) FROM responses").getInt();
}

std::uintmax_t sizeOf(const fs::path& file) {
    std::error_code missing;
    const auto size = fs::file_size(file, missing);
    return missing ? 0 : size;
}

/// Three answers, then `act`, then one more; gives what the store said to that.
std::string afterThree(const fixtures::Folder& folder, const std::function<void()>& act) {
    const auto study = fixtures::study({"direct"});
    const auto plan = fixtures::plan(study, "P01", 4);
    Store store = fixtures::open(folder / "a.sqlite");
    fixtures::store(store, study, plan);
    store.beginSession(fixtures::session("P01", false));
    const auto answer = [&](std::size_t trial) {
        store.record(fixtures::answer(plan.trials[trial], 1), study, plan, fixtures::clips(plan));
    };
    for (const std::size_t trial : {0, 1, 2}) answer(trial);
    act();
    std::string said;
    try {
        answer(3);
    } catch (const results::DatabaseMoved& moved) {
        said = moved.what();
    }
    // Whatever comes after is rejected likewise, and makes no further copy.
    CHECK_THROWS_AS(answer(4), results::DatabaseMoved);
    CHECK_THROWS_AS(store.endSession(studies::SessionOutcome::quit, 1.7e9), results::DatabaseMoved);
    return said;
}

/// Nothing is in a log that has no database, and a new session can begin under the old name or the copy's.
void checkSafe(const fixtures::Folder& folder, const std::string& said) {
    INFO(said);
    CHECK(contains(said, (folder / "a.sqlite").string()));
    CHECK(contains(said, "renamed, moved, replaced or deleted"));
    const auto copy = folder / "a.recovered.sqlite";
    CHECK(contains(said, copy.string()));
    CHECK_FALSE(fs::exists(folder / "a.recovered-2.sqlite"));
    CHECK(sizeOf(folder / "a.recovered.sqlite-wal") == 0);
    CHECK(answersIn(copy) == 4);
    CHECK(sizeOf(folder / "a.sqlite-wal") == 0);
    CHECK(fixtures::open(copy).resume("P01", 0.0).answered.size() == 4);
}

/// What a session leaves that dies in its midst: a log full of answers beside the database.
void dieInSession(const fs::path& path) {
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        const auto study = fixtures::study({"direct"});
        const auto plan = fixtures::plan(study, "P01", 4);
        Store store = fixtures::open(path);
        fixtures::store(store, study, plan);
        store.beginSession(fixtures::session("P01", false));
        for (const std::size_t trial : {0, 1, 2})
            store.record(fixtures::answer(plan.trials[trial], 1), study, plan, fixtures::clips(plan));
        ::raise(SIGKILL);
    }
    REQUIRE(::waitpid(child, nullptr, 0) == child);
}

std::string bytesOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_SUITE("results/store moved") {
    TEST_CASE("A renamed database stops the session at the next answer, with all answers in a copy") {
        const fixtures::Folder folder;
        const auto said =
            afterThree(folder, [&] { fs::rename(folder / "a.sqlite", folder / "elsewhere.sqlite"); });
        checkSafe(folder, said);
        CHECK(answersIn(folder / "elsewhere.sqlite") == 4);  // whole under its new name, too
        // Nothing is begun again beside the copy; elsewhere it is out of the way.
        const auto rejected = Store::open(folder / "a.sqlite", Durability::each_answer);
        REQUIRE_FALSE(rejected);
        CHECK(contains(rejected.error().message, "a.recovered.sqlite"));
        fs::create_directories(folder / "kept");
        fs::rename(folder / "a.recovered.sqlite", folder / "kept/a.recovered.sqlite");
        CHECK(fixtures::open(folder / "a.sqlite").participants().empty());
    }

    TEST_CASE("So does a deleted one") {
        const fixtures::Folder folder;
        checkSafe(folder, afterThree(folder, [&] { fs::remove(folder / "a.sqlite"); }));
    }

    TEST_CASE("So does one with another database under its name, which stays as it is") {
        const fixtures::Folder folder;
        std::string other;
        const auto said = afterThree(folder, [&] {
            { Store made = fixtures::open(folder / "b.sqlite"); }
            other = bytesOf(folder / "b.sqlite");
            fs::rename(folder / "b.sqlite", folder / "a.sqlite");
        });
        checkSafe(folder, said);
        CHECK(bytesOf(folder / "a.sqlite") == other);
    }

    TEST_CASE("So does one whose log was deleted or whose folder was renamed") {
        for (const bool folder_too : {false, true}) {
            const fixtures::Folder folder;
            if (!folder_too) {
                checkSafe(folder, afterThree(folder, [&] { fs::remove(folder / "a.sqlite-wal"); }));
                continue;
            }
            const auto inner = folder / "study";
            const auto study = fixtures::study({"direct"});
            const auto plan = fixtures::plan(study, "P01", 4);
            fs::create_directories(inner);
            const auto before = fs::current_path();
            fs::current_path(folder / "");
            Store store = fixtures::open(inner / "a.sqlite");
            fixtures::store(store, study, plan);
            store.beginSession(fixtures::session("P01", false));
            fs::rename(inner, folder / "renamed");
            CHECK_THROWS_AS(
                store.record(fixtures::answer(plan.trials[0], 1), study, plan, fixtures::clips(plan)),
                results::DatabaseMoved);
            fs::current_path(before);
            CHECK(answersIn(folder / "a.recovered.sqlite") == 1);
        }
    }

    TEST_CASE("An earlier copy is not written over") {
        const fixtures::Folder folder;
        const auto said = afterThree(folder, [&] {
            std::ofstream(folder / "a.recovered.sqlite") << "of another day";
            fs::remove(folder / "a.sqlite");
        });
        CHECK(contains(said, (folder / "a.recovered-2.sqlite").string()));
        CHECK(answersIn(folder / "a.recovered-2.sqlite") == 4);
        CHECK(bytesOf(folder / "a.recovered.sqlite") == "of another day");
    }
}

TEST_SUITE("results/store orphans") {
    TEST_CASE("Beside the log of a database that is not there nothing is made, and back it is read") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        dieInSession(path);
        REQUIRE(sizeOf(folder / "a.sqlite-wal") > 32);
        const std::string log = bytesOf(folder / "a.sqlite-wal");
        fs::rename(path, folder / "moved.sqlite");
        const auto rejected = [&] {
            for (const auto& error :
                 {Store::open(path, Durability::each_answer).error(), results::loadResponses(path).error(),
                  results::listParticipants(path).error()}) {
                INFO(error.text());
                CHECK(error.where == path.string());
                CHECK(contains(error.message, "a.sqlite-wal"));
                CHECK(contains(error.hint, "back its name"));
            }
            CHECK(bytesOf(folder / "a.sqlite-wal") == log);
        };
        SUBCASE("missing") {
            rejected();
            CHECK_FALSE(fs::exists(path));
        }
        SUBCASE("empty") {
            std::ofstream(path).flush();
            rejected();
            CHECK(fs::file_size(path) == 0);
        }
        SUBCASE("another file that keeps no log") {
            SQLite::Database(path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
                .exec("PRAGMA page_size = 4096; CREATE TABLE photos (id)");
            // SQLite itself has deleted nothing, as the journal's mode was never asked for.
            std::ofstream(folder / "a.sqlite-wal", std::ios::binary | std::ios::trunc) << log;
            rejected();
        }
        SUBCASE("another that is none") {
            std::ofstream(path) << std::string(5000, 'x');
            rejected();
        }
        fs::remove(path);
        fs::rename(folder / "moved.sqlite", path);
        CHECK(fixtures::open(path).resume("P01", 0.0).answered.size() == 3);
    }

    TEST_CASE("Beside the journal of a database that is not there nothing is made") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        { Store store = fixtures::open(path); }
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
            database.exec("PRAGMA journal_mode = DELETE");
            database.exec("PRAGMA cache_size = 1; PRAGMA cache_spill = 1; BEGIN IMMEDIATE");
            for (int i = 0; i < 300; ++i)
                database.exec("INSERT INTO withdrawals (utc_s) VALUES (" + std::to_string(i) + ")");
            database.exec("DROP TABLE events");
            ::raise(SIGKILL);
        }
        REQUIRE(::waitpid(child, nullptr, 0) == child);
        REQUIRE(sizeOf(folder / "a.sqlite-journal") > 512);
        const std::string journal = bytesOf(folder / "a.sqlite-journal");
        fs::rename(path, folder / "moved.sqlite");
        const auto rejected = Store::open(path, Durability::each_answer);
        REQUIRE_FALSE(rejected);
        CHECK(contains(rejected.error().message, "a.sqlite-journal"));
        CHECK_FALSE(fs::exists(path));
        CHECK(bytesOf(folder / "a.sqlite-journal") == journal);
    }

    TEST_CASE("A pipe or device is no database") {
        const auto rejected = Store::open("/dev/zero", Durability::each_answer);
        REQUIRE_FALSE(rejected);
        CHECK(contains(rejected.error().message, "device"));
    }
}
