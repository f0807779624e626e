// Withdrawal: no byte of the person is left.
#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <set>

#include "core/files.hpp"
#include "fixtures.hpp"
#include "old_databases.hpp"
#include "results/participants/participants.hpp"
#include "results/store/participant_lock.hpp"
#include "withdrawal_fixture.hpp"

using namespace deixis;
using results::Durability;
using results::Store;
using studies::SessionOutcome;

using namespace fixtures::withdrawal;

TEST_SUITE("results/withdraw") {
    TEST_CASE("Nothing of the person is left in any file, and the count stays") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        auto study = fixtures::wideStudy();
        {
            Store store = fixtures::open(path);
            for (const char* who : {"P01", "P02"}) {
                takePart(store, study, who, "nothing to add");
                store.endSession(SessionOutcome::finished, 1.7e9 + 600.0);
            }
            study.stages[1].text = consent_text;
            const auto lock = results::ParticipantLock::take(path, id);
            takePart(store, study, id, typed);
            store.endSession(SessionOutcome::quit, 1.7e9 + 600.0);
            takePart(store, study, "P03", "nor this");
            store.endSession(SessionOutcome::finished, 1.7e9 + 600.0);
        }
        const std::string token = SQLite::Database(path.string())
                                      .execAndGet("SELECT token FROM participants WHERE id = '" + id + "'")
                                      .getString();
        REQUIRE(traces(path, {id, typed}).size() >= 2);
        study.stages[1].text = fixtures::wideStudy().stages[1].text;
        // Others agreed to these words too.
        SQLite::Database(path.string(), SQLite::OPEN_READWRITE)
            .exec("UPDATE consents SET text = 'other words' WHERE participant = 'P03'");

        REQUIRE(results::withdrawParticipant(path, id, 1.75e9));

        CHECK(traces(path, {id, typed, consent_text, note + " (" + id}).empty());
        const auto list = results::listParticipants(path);
        REQUIRE(list);
        CHECK(list->withdrawn == 1);
        REQUIRE(list->rows.size() == 3);
        for (const auto& row : list->rows) {
            CHECK(row.answered == 3);
            CHECK(row.sessions == 1);
        }
        {
            SQLite::Database database(path.string());
            CHECK(database.execAndGet("SELECT utc_s FROM withdrawals").getDouble() == 1.75e9);
            CHECK(database.execAndGet("SELECT token FROM withdrawals").getString() == token);
            CHECK(database.execAndGet("SELECT sum(frames) FROM tracking_blocks").getInt() == 1500);
            CHECK(database.execAndGet("SELECT count(*) FROM hand_joints").getInt() == 1500);
            CHECK(database.execAndGet("SELECT count(DISTINCT session) FROM events").getInt() == 3);
            CHECK(database.execAndGet("SELECT count(*) FROM pragma_foreign_key_check").getInt() == 0);
            CHECK(database.execAndGet("PRAGMA integrity_check").getString() == "ok");
            CHECK(database.execAndGet("PRAGMA journal_mode").getString() == "wal");
        }
        CHECK(results::withdrawParticipant(path, "P02", 1.75e9 + 1.0));
        CHECK(results::listParticipants(path)->withdrawn == 2);
    }

    TEST_CASE(
        "Nothing is left either where the last session was killed and its log lies beside the database") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        const auto study = fixtures::wideStudy();
        int ready[2];
        REQUIRE(::pipe(ready) == 0);
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            const auto lock = results::ParticipantLock::take(path, id);
            Store store = fixtures::open(path);
            takePart(store, study, id, typed);
            if (::write(ready[1], "x", 1) != 1) ::_exit(1);
            for (;;) ::pause();
        }
        ::close(ready[1]);
        char byte = 0;
        CHECK(::read(ready[0], &byte, 1) == 1);
        ::close(ready[0]);
        const auto running = results::withdrawParticipant(path, id, 1.75e9);
        REQUIRE_FALSE(running);
        CHECK(running.error().message.find("already being run") != std::string::npos);
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        REQUIRE(std::filesystem::file_size(folder / "a.sqlite-wal") > 0);
        REQUIRE_FALSE(traces(path, {typed}).empty());

        REQUIRE(results::withdrawParticipant(path, id, 1.75e9));
        CHECK(traces(path, {id, typed, note}).empty());
        CHECK(results::listParticipants(path)->withdrawn == 1);
        CHECK(fixtures::open(path).participants().empty());
    }

    TEST_CASE("Tokens are drawn again for everybody: an id tells nothing of who withdrew") {
        const fixtures::Folder folder;
        const auto study = fixtures::wideStudy();
        std::set<std::string> tokens;
        for (const char* name : {"a.sqlite", "b.sqlite"}) {
            {
                Store store = fixtures::open(folder / name);
                for (const char* who : {"P01", "P02"}) {
                    const auto plan = fixtures::widePlan(study, who);
                    REQUIRE(store.storePlan(study, fixtures::registration(plan, "sv"), plan));
                }
            }
            SQLite::Database database((folder / name).string());
            SQLite::Statement row(database, "SELECT token FROM participants");
            while (row.executeStep()) tokens.insert(row.getColumn(0).getString());
        }
        CHECK(tokens.size() == 4);
        for (const std::string& token : tokens) {
            CHECK(token.size() == 32);
            CHECK(token.find_first_not_of("0123456789abcdef") == std::string::npos);
        }
    }

    TEST_CASE("A database of an older version is brought up to date by the way") {
        for (const int version : {1, 2, 3, 4, 5}) {
            INFO("version " << version);
            const fixtures::Folder folder;
            fixtures::makeVersion(version, folder / "a.sqlite");
            const auto done = results::withdrawParticipant(folder / "a.sqlite", "S001", 1.75e9);
            REQUIRE_MESSAGE(done, done.error().text());
            const auto list = results::listParticipants(folder / "a.sqlite");
            CHECK(list->withdrawn == (version > 2 ? 2 : 1));
            CHECK(list->rows.size() == (version > 1 ? 1 : 0));
        }
    }

    TEST_CASE("While another program has the database open nothing is erased") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        const auto study = fixtures::wideStudy();
        {
            Store store = fixtures::open(path);
            takePart(store, study, id, typed);
            store.endSession(SessionOutcome::quit, 1.7e9 + 600.0);
            const auto rejected = results::withdrawParticipant(path, id, 1.75e9);
            REQUIRE_FALSE(rejected);
            CHECK(rejected.error().message.find("locked by another program") != std::string::npos);
            CHECK(store.participants() == std::vector<std::string>{id});
        }
        CHECK(results::listParticipants(path)->withdrawn == 0);
        CHECK(results::withdrawParticipant(path, id, 1.75e9));
        CHECK(traces(path, {id, typed, note}).empty());
    }
}
