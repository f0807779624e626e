#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>

#include "core/files.hpp"
#include "fixtures.hpp"
#include "results/answers/response_table.hpp"
#include "results/copies/data_export.hpp"
#include "results/copies/merge.hpp"
#include "results/participants/participants.hpp"
#include "results/store/recording.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;

namespace {

/// Each participant with all answers, in one session, with tracked frames.
void station(const std::filesystem::path& path, const studies::Study& study,
             const std::vector<std::string>& ids, double rating = 3.0) {
    Store store = fixtures::open(path);
    for (const auto& id : ids) {
        const auto plan = fixtures::plan(study, id, 1);
        fixtures::store(store, study, plan);
        store.beginSession(fixtures::session(id, false));
        store.record(studies::Note{studies::NoteKind::session_start, -1, {1.0, 1.7e9}, id}, study, plan,
                     fixtures::clips(plan));
        for (const auto& trial : plan.trials)
            store.record(fixtures::answer(
                             trial, trial.kind == studies::StageKind::game ? 1 : static_cast<int>(rating)),
                         study, plan, fixtures::clips(plan));
        std::vector<TrackedFrame> frames;
        for (std::uint64_t i = 1; i <= 10; ++i) frames.push_back({fixtures::frame(i), 1});
        store.recordTracking(frames, {});
        store.endSession(studies::SessionOutcome::finished, 1.7e9 + 60.0);
    }
}

std::string list(const std::vector<Error>& errors) {
    std::string out;
    for (const Error& error : errors) out += error.text() + "\n";
    return out;
}

}  // namespace

TEST_SUITE("results/merge") {
    TEST_CASE("Two stations' databases become one that is read like any other, sources untouched") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct", "stiff"});
        station(folder / "a.sqlite", study, {"A01", "A02"});
        station(folder / "b.sqlite", study, {"B11", "B12", "B13"}, 5.0);
        const std::string before = readFile(folder / "b.sqlite").value();
        const auto merged = mergeDatabases({folder / "a.sqlite", folder / "b.sqlite"}, folder / "all.sqlite");
        REQUIRE_MESSAGE(merged, list(merged.error()));
        CHECK(readFile(folder / "b.sqlite").value() == before);
        const auto a = loadResponses(folder / "a.sqlite");
        const auto b = loadResponses(folder / "b.sqlite");
        const auto all = loadResponses(folder / "all.sqlite");
        REQUIRE(all);
        CHECK(all->rows.size() == a->rows.size() + b->rows.size());
        CHECK(all->planned_participants == 5);
        // Sessions, answers and tracked frames still belong together: each participant as in the source.
        for (const auto& [file, id] : {std::pair{"a.sqlite", "A02"}, {"b.sqlite", "B13"}}) {
            const auto there = loadRecording(folder / file, id);
            const auto here = loadRecording(folder / "all.sqlite", id);
            REQUIRE(here);
            REQUIRE(here->answers.size() == there->answers.size());
            CHECK_FALSE(here->answers.empty());
            for (std::size_t i = 0; i < here->answers.size(); ++i) {
                CHECK(here->answers[i].outcome == there->answers[i].outcome);
                CHECK(here->answers[i].trial.tracking.size() == there->answers[i].trial.tracking.size());
                CHECK(here->answers[i].clips.size() == 1);
            }
        }
        SQLite::Database database(folder / "all.sqlite", SQLite::OPEN_READONLY);
        CHECK(database.execAndGet("SELECT count(*) FROM pragma_foreign_key_check").getInt() == 0);
        CHECK(database.execAndGet("PRAGMA integrity_check").getString() == "ok");
        CHECK(database.execAndGet("SELECT count(*) FROM tracking_blocks").getInt() == 5);
        CHECK_FALSE(std::filesystem::exists(folder / "all.sqlite-wal"));
        // It can be added to.
        Store store = fixtures::open(folder / "all.sqlite");
        CHECK(store.firstFreeNumber() == 14);
    }

    TEST_CASE("Everything that stands against joining is told at once, and nothing is written") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        auto other = study;
        other.hash = std::string(64, 'b');
        other.name = "another";
        station(folder / "a.sqlite", study, {"P01", "P02", "P05"});
        station(folder / "b.sqlite", study, {"P02", "Q05"}, 5.0);
        station(folder / "c.sqlite", other, {"R09"});
        const auto merged = mergeDatabases(
            {folder / "a.sqlite", folder / "b.sqlite", folder / "c.sqlite", folder / "none.sqlite"},
            folder / "all.sqlite");
        REQUIRE_FALSE(merged);
        const std::string problems = list(merged.error());
        CAPTURE(problems);
        CHECK(merged.error().size() == 4);
        CHECK(contains(problems, "participant P02 is also in"));
        CHECK(contains(problems, "participant Q05 has the number 5, which P05"));
        CHECK(contains(problems, "has the study 'another'"));
        CHECK(contains(problems, "none.sqlite: no such file"));
        CHECK_FALSE(std::filesystem::exists(folder / "all.sqlite"));
        CHECK_FALSE(std::filesystem::exists(folder / "all.sqlite.partial"));
        station(folder / "d.sqlite", study, {"D20"});
        REQUIRE(writeFile(folder / "taken.sqlite", "something"));
        const auto over = mergeDatabases({folder / "a.sqlite", folder / "d.sqlite"}, folder / "taken.sqlite");
        REQUIRE_FALSE(over);
        CHECK(contains(list(over.error()), "exists already"));
        CHECK(readFile(folder / "taken.sqlite").value() == "something");
    }

    TEST_CASE("A participant whose rows are the same in both comes in once: a copy may be joined again") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        station(folder / "a.sqlite", study, {"P01"});
        std::filesystem::copy_file(folder / "a.sqlite", folder / "copy.sqlite");
        station(folder / "copy.sqlite", study, {"P02"});
        const auto merged =
            mergeDatabases({folder / "a.sqlite", folder / "copy.sqlite"}, folder / "all.sqlite");
        REQUIRE_MESSAGE(merged, list(merged.error()));
        CHECK(loadResponses(folder / "all.sqlite")->planned_participants == 2);
        CHECK(loadResponses(folder / "all.sqlite")->rows.size() ==
              loadResponses(folder / "copy.sqlite")->rows.size());
    }

    TEST_CASE(
        "Who is excluded in one copy only is so in the joined database, and all accepted changes are kept") {
        const fixtures::Folder folder;
        station(folder / "a.sqlite", fixtures::study({"direct"}), {"P01", "P02"});
        std::filesystem::copy_file(folder / "a.sqlite", folder / "b.sqlite");
        REQUIRE(excludeParticipant(folder / "b.sqlite", "P01", "looked away"));
        const auto accept = [&](const char* file, const char* rows) {
            SQLite::Database(folder / file, SQLite::OPEN_READWRITE)
                .exec(std::string("INSERT INTO locked_changes (utc_s, what, reason) VALUES ") + rows);
        };
        accept("a.sqlite", "(1.0, '{}', 'both'), (3.0, '{}', 'of a')");
        accept("b.sqlite", "(1.0, '{}', 'both'), (2.0, '{}', 'of b'), (3.0, '{}', NULL)");
        for (const bool swapped : {false, true}) {
            CAPTURE(swapped);
            const auto out = folder / (swapped ? "ba.sqlite" : "ab.sqlite");
            const auto merged = mergeDatabases(
                {folder / (swapped ? "b.sqlite" : "a.sqlite"), folder / (swapped ? "a.sqlite" : "b.sqlite")},
                out);
            REQUIRE_MESSAGE(merged, list(merged.error()));
            CHECK(merged->excluded_in_one == std::vector<std::string>{"P01"});
            SQLite::Database joined(out, SQLite::OPEN_READONLY);
            const auto one = [&](const char* query) { return joined.execAndGet(query).getString(); };
            CHECK(one("SELECT group_concat(id || ' ' || status || ' ' || coalesce(reason, '-')) FROM "
                      "(SELECT * FROM participants ORDER BY id)") == "P01 excluded looked away,P02 active -");
            CHECK(one("SELECT group_concat(utc_s || ' ' || coalesce(reason, '-')) FROM (SELECT * FROM "
                      "locked_changes ORDER BY id)") == "1.0 both,2.0 of b,3.0 -,3.0 of a");
        }
    }

    TEST_CASE("No database is made where answers of another one with its name are left") {
        const fixtures::Folder folder;
        station(folder / "a.sqlite", fixtures::study({"direct"}), {"P01"});
        station(folder / "b.sqlite", fixtures::study({"direct"}), {"P02"});
        REQUIRE(writeFile(folder / "all.recovered.sqlite", "x"));
        const auto merged = mergeDatabases({folder / "a.sqlite", folder / "b.sqlite"}, folder / "all.sqlite");
        REQUIRE_FALSE(merged);
        CHECK(contains(list(merged.error()), "all.recovered.sqlite"));
        CHECK_FALSE(std::filesystem::exists(folder / "all.sqlite"));
        const auto read = loadResponses(folder / "all.sqlite");
        REQUIRE_FALSE(read);
        CHECK(contains(read.error().text(), "all.recovered.sqlite"));
    }

    TEST_CASE("Who withdrew in one of the databases is left out, and counts once however often it is said") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        station(folder / "a.sqlite", study, {"P01", "P02"});
        for (const char* copy : {"b.sqlite", "c.sqlite"})
            std::filesystem::copy_file(folder / "a.sqlite", folder / copy);
        const auto done = withdrawParticipant(folder / "a.sqlite", "P01", 1.75e9);
        REQUIRE_MESSAGE(done, done.error().text());
        REQUIRE(withdrawParticipant(folder / "b.sqlite", "P01", 1.76e9));
        const std::vector<std::vector<std::filesystem::path>> orders{
            {folder / "a.sqlite", folder / "c.sqlite"},
            {folder / "c.sqlite", folder / "a.sqlite"},
            {folder / "a.sqlite", folder / "b.sqlite", folder / "c.sqlite"}};
        for (std::size_t i = 0; i < orders.size(); ++i) {
            INFO("order " << i);
            const auto to = folder / std::to_string(i).c_str();
            const auto merged = mergeDatabases(orders[i], to);
            REQUIRE_MESSAGE(merged, list(merged.error()));
            CHECK(merged->withdrawn == std::vector<std::string>{"P01"});
            const auto people = listParticipants(to);
            REQUIRE(people->rows.size() == 1);
            CHECK(people->rows[0].id == "P02");
            CHECK(people->withdrawn == 1);
            CHECK(people->uncleared == 0);
            CHECK(readFile(to)->find("P01") == std::string::npos);
        }
        // Who begins again is somebody new.
        station(folder / "a.sqlite", study, {"P01"}, 5.0);
        const auto merged =
            mergeDatabases({folder / "c.sqlite", folder / "a.sqlite"}, folder / "anew.sqlite");
        REQUIRE_MESSAGE(merged, list(merged.error()));
        CHECK(listParticipants(folder / "anew.sqlite")->rows.size() == 2);
        CHECK(loadResponses(folder / "anew.sqlite")->rows.size() ==
              loadResponses(folder / "a.sqlite")->rows.size());
    }
}
