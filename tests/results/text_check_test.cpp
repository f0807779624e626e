// Texts that a server cannot hold, in databases of earlier versions.
#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>

#include "fixtures.hpp"
#include "results/participants/participants.hpp"
#include "results/server/server.hpp"
#include "text.hpp"

using namespace deixis;
using deixis::tests::contains;

TEST_SUITE("results/texts") {
#ifdef DEIXIS_SERVER
    TEST_CASE("A push names file, table and row of a text that no server can hold, before it connects") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        const auto study = fixtures::study({"direct"});
        const auto plan = fixtures::plan(study, "P01", 1);
        {
            results::Store store = fixtures::open(path);
            fixtures::store(store, study, plan);
            store.beginSession(fixtures::session("P01", false));
            store.record(studies::Note{studies::NoteKind::operator_note, 3, {1.0, 1.7e9}, "a phone rang"},
                         study, plan, {});
            store.endSession(studies::SessionOutcome::quit, 1.7e9 + 9.0);
        }
        const char* const nowhere = "postgresql://nobody@127.0.0.1:1/x?connect_timeout=2";
        const auto unreached = results::pushDatabase(path, nowhere);
        REQUIRE_FALSE(unreached);
        CHECK(contains(unreached.error().message, "no server was reached"));
        SQLite::Database(path.string(), SQLite::OPEN_READWRITE)
            .exec("UPDATE events SET detail = CAST(x'5AFC72696368' AS TEXT) WHERE kind = 'operator_note'");
        const auto rejected = results::pushDatabase(path, nowhere);
        REQUIRE_FALSE(rejected);
        CHECK(rejected.error().where == path.string());
        CHECK(contains(rejected.error().message, "table events, row with id 1: the column detail"));
        CHECK(contains(rejected.error().message, "Z\xEF\xBF\xBDrich"));
    }

#else
    TEST_CASE("A program that was built without PostgreSQL says so, and shows no password") {
        const char* const address = "postgresql://ann:Sesam@h/d";
        for (const Error& error : {results::pushDatabase("a.sqlite", address).error(),
                                   results::loadServerResponses(address, "").error()}) {
            CHECK(contains(error.text(), "postgresql://ann@h/d: cannot be reached"));
            CHECK(contains(error.text(), "built without PostgreSQL"));
        }
    }
#endif

    TEST_CASE("What is no text of a person's is kept as well as can be; a reason is rejected") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        const auto study = fixtures::study({"direct"});
        const auto plan = fixtures::plan(study, "P01", 1);
        {
            results::Store store = fixtures::open(path);
            fixtures::store(store, study, plan);
            auto session = fixtures::session("P01", false);
            session.station.details =
                "driver \xFF"
                "7";
            store.beginSession(session);
        }
        CHECK(
            SQLite::Database(path.string()).execAndGet("SELECT station_details FROM sessions").getString() ==
            "driver \xEF\xBF\xBD"
            "7");
        const auto rejected = results::excludeParticipant(path, "P01", "Z\xFCrich");
        REQUIRE_FALSE(rejected);
        CHECK(contains(rejected.error().message, "UTF-8"));
    }
}
