#include "results/answers/response_table.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "core/files.hpp"
#include "fixtures.hpp"
#include "results/copies/data_export.hpp"
#include "text.hpp"

using namespace deixis;
using deixis::tests::contains;
using results::loadResponses;
using results::Store;

namespace {

std::string rejectionToLoad(const std::filesystem::path& path) {
    const auto table = loadResponses(path);
    REQUIRE_FALSE(table.has_value());
    CHECK(table.error().where == path.string());
    return table.error().message;
}

}  // namespace

TEST_SUITE("results/response_table") {
    TEST_CASE("Nobody counts whose latest consent was rejected, whatever the status says") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        const auto study = fixtures::wideStudy();
        {
            Store store = fixtures::open(path);
            for (const char* id : {"P01", "P02"}) {
                const auto plan = fixtures::widePlan(study, id);
                fixtures::store(store, study, plan);
                store.beginSession(fixtures::session(id, false));
                for (const int trial : {0, 5, 9}) {
                    auto response = fixtures::answer(plan.trials[trial], 1);
                    if (trial == 0)
                        response.answers = {{"consent", -1, id == std::string("P01") ? 1.0 : 0.0}};
                    if (trial == 9) response.answers = {{"effort", -1, 12.0}, {"calm", -1, 4.0}};
                    store.record(response, study, plan, fixtures::clips(plan));
                }
                store.endSession(studies::SessionOutcome::finished, 1.7e9 + 60.0);
            }
        }
        const auto tables = [&] {
            const auto table = loadResponses(path);
            REQUIRE(table);
            CHECK(table->rows.size() == 1);
            CHECK(table->rows[0].participant == "P01");
            CHECK(table->choices.size() == 1);
            CHECK(table->scores.size() == 1);
            CHECK(table->planned_participants == 1);
            CHECK(table->measures[0].planned == 1);
            CHECK(table->left_out_rows.empty());
            REQUIRE(table->left_out.size() == 1);
            CHECK(table->left_out[0].participant == "P02");
            CHECK(table->left_out[0].dropped);
            CHECK(table->left_out[0].reason == "consent was declined");
            // The view and the exported tables say the same.
            const std::string statuses =
                "SELECT group_concat(status) FROM (SELECT DISTINCT participant, "
                "participant_status AS status FROM responses_flat ORDER BY 1)";
            CHECK(SQLite::Database(path.string()).execAndGet(statuses).getString() == "active,dropped");
            REQUIRE(results::exportCsv(path, folder / "tables", {}));
            for (const char* name : {"tables/participants.csv", "tables/responses.csv"}) {
                const std::string csv = *readFile(folder / name);
                CHECK(csv.find("active") != std::string::npos);
                CHECK_MESSAGE(csv.find("active", csv.find("\nP02,")) == std::string::npos, csv);
            }
        };
        tables();
        SQLite::Database(path.string(), SQLite::OPEN_READWRITE)
            .exec("UPDATE participants SET status = 'active', reason = NULL WHERE id = 'P02'");
        tables();
    }

    TEST_CASE("What was answered comes back in order, practice left out, with what was planned") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"stiff", "direct"});
        const auto plan = fixtures::plan(study, "P02", 1);
        {
            Store store = fixtures::open(folder / "a%20?.sqlite");
            fixtures::store(store, study, plan);
            fixtures::store(store, study, fixtures::plan(study, "P01", 1));
            store.beginSession(fixtures::session("P02", false));
            for (const auto& [trial, value] : {std::pair{6, 1}, {0, 1}, {2, 4}})
                store.record(fixtures::answer(plan.trials[static_cast<std::size_t>(trial)], value), study,
                             plan, fixtures::clips(plan));
        }
        const auto table = loadResponses(folder / "a%20?.sqlite");
        REQUIRE(table);
        CHECK(table->database == "a%20?.sqlite");
        CHECK(table->study_title == study.title);
        CHECK(table->study_hash == study.hash);
        CHECK(table->alpha == 0.01);
        REQUIRE(table->measures.size() == 2);
        CHECK(table->measures[0].name == "accuracy");
        CHECK(table->measures[0].balls == 3);
        CHECK(table->measures[0].planned == 8);
        CHECK(table->measures[1].name == "naturalness");
        CHECK(table->measures[1].low == 1.0);
        CHECK(table->measures[1].high == 5.0);
        CHECK(table->measures[1].planned == 4);
        CHECK(table->systems == std::vector<std::string>{"stiff", "direct"});
        CHECK(table->layouts == std::vector<std::string>{"across", "side-by-side"});
        CHECK(table->planned_participants == 2);
        REQUIRE(table->stations.size() == 1);
        CHECK(table->stations[0].kind == "desktop");
        CHECK(table->stations[0].sessions == 1);
        REQUIRE(table->rows.size() == 2);
        CHECK(table->rows[0].measure == "accuracy");
        CHECK(table->rows[0].layout == "side-by-side");
        CHECK(table->rows[0].distance == "near");
        CHECK(table->rows[0].target_id == "T001");
        CHECK(table->rows[0].value == 1.0);
        CHECK_FALSE(table->rows[0].synthetic);
        CHECK(table->rows[0].response_time_s == 1.25);
        CHECK(table->rows[1].measure == "naturalness");
        CHECK(table->rows[1].system == "direct");
        CHECK(table->rows[1].value == 4.0);
    }

    TEST_CASE(
        "Every kind of answer is read, and what is a check or excluded is left out, with what was counted") {
        const fixtures::Folder folder;
        const auto study = fixtures::wideStudy();
        {
            Store store = fixtures::open(folder / "a.sqlite");
            for (const char* id : {"P01", "P02"}) {
                const auto plan = fixtures::widePlan(study, id);
                fixtures::store(store, study, plan);
                store.beginSession(fixtures::session(id, false));
                const auto record = [&](std::size_t trial, const studies::Response& response) {
                    REQUIRE(response.trial_index == static_cast<int>(trial));
                    store.record(response, study, plan, fixtures::clips(plan));
                };
                auto ratings = fixtures::response(plan.trials[3]);
                ratings.answers = {{"rating", 0, 30.0}, {"rating", 1, 80.0}};
                record(3, ratings);
                auto pair = fixtures::response(plan.trials[4]);
                pair.answers = {{"preference", -1, -2.0}, {"reasons", -1, {}, "speed;arm"}};
                record(4, pair);
                auto choice = fixtures::answer(plan.trials[5], 1);
                choice.answers = {{"confidence", -1, 6.0}};
                record(5, choice);
                auto caught = fixtures::answer(plan.trials[6], 0);
                caught.check_passed = false;
                record(6, caught);
                auto number = fixtures::response(plan.trials[7]);
                number.answers = {{"rating", 0, 50.0}, {"rating", 1, 4.0}};
                number.check_passed = true;
                record(7, number);
                auto load = fixtures::response(plan.trials[9]);
                load.answers = {{"effort", -1, 12.0}, {"calm", -1, 4.0}};
                record(9, load);
                if (std::string(id) == "P02")
                    store.record(studies::Exclusion{"attention check failed", {1.0, 1.7e9}}, study, plan,
                                 fixtures::clips(plan));
                store.endSession(studies::SessionOutcome::quit, 1.7e9 + 60.0);
            }
        }
        const auto table = loadResponses(folder / "a.sqlite");
        REQUIRE(table);
        const auto values = [&](const std::string& measure) {
            std::vector<double> out;
            for (const auto& row : table->rows)
                if (row.measure == measure) out.push_back(row.value);
            return out;
        };
        CHECK(values("appeal") == std::vector<double>{30.0, 80.0, 50.0});
        CHECK(values("preference") == std::vector<double>{-2.0});
        CHECK(values("accuracy") == std::vector<double>{1.0});
        CHECK(values("confidence") == std::vector<double>{6.0});
        REQUIRE(table->left_out.size() == 1);
        CHECK(table->left_out[0].participant == "P02");
        CHECK_FALSE(table->left_out[0].dropped);
        CHECK(table->left_out[0].reason == "attention check failed");
        REQUIRE(table->checks.size() == 2);
        CHECK(table->checks[0].kind == "number");
        CHECK(table->checks[0].passed == 2);
        CHECK(table->checks[1].kind == "catch");
        CHECK(table->checks[1].failed == 2);
        // (12 + (0 + 20 - 4)) / 2 x 5, by hand.
        REQUIRE(table->scores.size() == 1);  // P02 is excluded
        CHECK(table->scores[0].value == 70.0);
        REQUIRE(table->between.size() == 1);
        CHECK(table->between[0].name == "style");
        CHECK(table->left_out_rows.size() == 6);  // as many as of P01
        CHECK(table->planned_participants == 1);
    }

    TEST_CASE("Reading leaves nothing behind, and sees the answers of a session that runs or was killed") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        const auto study = fixtures::study({"direct"});
        const auto plan = fixtures::plan(study, "P01", 1);
        std::string bytes;
        {
            Store store = fixtures::open(path);
            fixtures::store(store, study, plan);
            store.beginSession(fixtures::session("P01", false));
            store.record(fixtures::answer(plan.trials[1], 2), study, plan, fixtures::clips(plan));
        }
        bytes = readFile(path).value();
        CHECK(loadResponses(path)->rows.size() == 1);
        CHECK(readFile(path).value() == bytes);
        CHECK_FALSE(std::filesystem::exists(folder / "a.sqlite-wal"));
        CHECK_FALSE(std::filesystem::exists(folder / "a.sqlite-shm"));

        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            Store store = fixtures::open(path);
            store.beginSession(fixtures::session("P01", false));
            store.record(fixtures::answer(plan.trials[2], 1), study, plan, fixtures::clips(plan));
            ::kill(::getpid(), SIGKILL);
        }
        ::waitpid(child, nullptr, 0);
        REQUIRE(std::filesystem::exists(folder / "a.sqlite-wal"));
        CHECK(loadResponses(path)->rows.size() == 2);

        Store running = fixtures::open(path);
        running.beginSession(fixtures::session("P01", false));
        running.record(fixtures::answer(plan.trials[3], 1), study, plan, fixtures::clips(plan));
        CHECK(loadResponses(path)->rows.size() == 3);
    }

    TEST_CASE("Files that hold no answers are rejected with what they are") {
        const fixtures::Folder folder;
        CHECK(contains(rejectionToLoad(folder / "missing.sqlite"), "no such file"));
        CHECK(contains(rejectionToLoad(folder / ""), "no such file"));
        std::ofstream(folder / "notes.txt") << "Dear diary, this file is certainly longer than a header.";
        CHECK(contains(rejectionToLoad(folder / "notes.txt"), "not a SQLite database"));
        SQLite::Database(folder / "b.sqlite", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
            .exec("CREATE TABLE photos (id)");
        CHECK(contains(rejectionToLoad(folder / "b.sqlite"), "another program"));
        std::ofstream(folder / "empty.sqlite").flush();
        CHECK(contains(rejectionToLoad(folder / "empty.sqlite"), "no study yet"));
        const auto study = fixtures::study({"direct"});
        {
            Store store = fixtures::open(folder / "a.sqlite");
            CHECK(contains(rejectionToLoad(folder / "a.sqlite"), "no study yet"));
            fixtures::store(store, study, fixtures::plan(study, "P01", 1));
        }
        CHECK(contains(rejectionToLoad(folder / "a.sqlite"), "no answers yet"));
        SQLite::Database(folder / "a.sqlite", SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 7");
        CHECK(contains(rejectionToLoad(folder / "a.sqlite"), "version 7"));
    }
}
