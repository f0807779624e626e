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
#include "results/participants.hpp"

using namespace deixis;
using results::Durability;
using results::Store;
using studies::SessionOutcome;

namespace {

const std::string typed = "my left shoulder aches since Thursday";
const std::string consent_text = "Jag deltar av egen fri vilja och har blivit informerad.";
const std::string note = "wore thick green glasses";
const std::string id = "WITHDRAWER-17";

/// Every file beside and including the database that holds one of the texts, or carries one in its name.
std::vector<std::string> traces(const std::filesystem::path& database,
                                const std::vector<std::string>& texts) {
    std::vector<std::string> out;
    for (const auto& entry : std::filesystem::directory_iterator(database.parent_path())) {
        const std::string bytes = readFile(entry.path()).value();
        const std::string name = entry.path().filename().string();
        for (const auto& text : texts)
            if (bytes.find(text) != std::string::npos || name.find(text) != std::string::npos)
                out.push_back(name + ": " + text);
    }
    return out;
}

void takePart(Store& store, const studies::Study& study, const std::string& who, const std::string& says) {
    const auto plan = fixtures::widePlan(study, who);
    if (!store.plan(who)) REQUIRE(store.storePlan(study, fixtures::registration(plan, "sv"), plan));
    auto info = fixtures::session(who, false);
    info.station.properties = {{"operator", "of " + who}};
    store.beginSession(info);
    const auto record = [&](const studies::SessionEvent& event) {
        store.record(event, study, plan, fixtures::clips(plan));
    };
    auto consent = fixtures::response(plan.trials[0]);
    consent.answers = {{"consent", -1, 1.0}};
    record(consent);
    auto remark = fixtures::response(plan.trials[2]);
    remark.answers = {{"remark", -1, {}, says}};
    record(remark);
    record(studies::Note{"operator_note", 5, {50.0, 1.7e9 + 50.0}, note + " (" + who + ")"});
    for (const std::size_t trial : {5U, 6U}) record(fixtures::answer(plan.trials[trial], 1));
    record(studies::Superseded{6, says, {60.0, 1.7e9 + 60.0}});
    std::vector<results::TrackedFrame> frames;
    for (std::uint64_t i = 1; i <= 500; ++i) {
        frames.push_back({fixtures::frame(i), i < 300 ? 5 : -1});
        frames.back().sample.joints[0].resize(26);
    }
    store.recordTracking(frames, std::vector<results::TrialTracking>{{5, 300}});
}

}  // namespace

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
        REQUIRE(traces(path, {id, typed}).size() >= 3);  // both in the database, the id also beside it
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

    TEST_CASE("Tokens are drawn anew for everybody: an id tells nothing of who withdrew") {
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
        for (const int version : {1, 2, 3, 4}) {
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
            const auto refused = results::withdrawParticipant(path, id, 1.75e9);
            REQUIRE_FALSE(refused);
            CHECK(refused.error().message.find("locked by another program") != std::string::npos);
            CHECK(store.participants() == std::vector<std::string>{id});
        }
        CHECK(results::listParticipants(path)->withdrawn == 0);
        CHECK(results::withdrawParticipant(path, id, 1.75e9));
        CHECK(traces(path, {id, typed, note}).empty());
    }
}
