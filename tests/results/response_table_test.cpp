#include "results/response_table.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "core/files.hpp"
#include "fixtures.hpp"

using namespace deixis;
using results::loadResponses;
using results::Store;

namespace {

std::string refusal(const std::filesystem::path& path) {
    const auto table = loadResponses(path);
    REQUIRE_FALSE(table.has_value());
    CHECK(table.error().where == path.string());
    return table.error().message;
}

bool contains(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_SUITE("results/response_table") {
    TEST_CASE("What was answered comes back in order, practice left out, with what was planned") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"stiff", "direct"});
        const auto plan = fixtures::plan(study, "P02", 1);
        {
            Store store = fixtures::open(folder / "a%20?.sqlite");
            REQUIRE(store.storePlan(study, plan));
            REQUIRE(store.storePlan(study, fixtures::plan(study, "P01", 1)));
            store.beginSession(fixtures::session("P02", false));
            for (const auto& [trial, value] : {std::pair{6, 1}, {0, 1}, {2, 4}})
                store.record(fixtures::answer(plan.trials[static_cast<std::size_t>(trial)], value), plan,
                             fixtures::clips(plan));
        }
        const auto table = loadResponses(folder / "a%20?.sqlite");
        REQUIRE(table);
        CHECK(table->database == "a%20?.sqlite");
        CHECK(table->study_title == study.title);
        CHECK(table->study_hash == study.hash);
        CHECK(table->alpha == 0.01);
        CHECK(table->rating_steps == 5);
        CHECK(table->balls == 3);
        CHECK(table->systems == std::vector<std::string>{"stiff", "direct"});
        CHECK(table->layouts == std::vector<std::string>{"across", "side-by-side"});
        CHECK(table->planned_participants == 2);
        CHECK(table->planned_ratings == 4);
        CHECK(table->planned_choices == 8);
        REQUIRE(table->stations.size() == 1);
        CHECK(table->stations[0].kind == "desktop");
        CHECK(table->stations[0].sessions == 1);
        REQUIRE(table->rows.size() == 2);
        CHECK(table->rows[0].stage == "naturalness");
        CHECK(table->rows[0].system == "direct");
        CHECK(table->rows[0].rating == 4.0);
        CHECK(table->rows[1].stage == "game");
        CHECK(table->rows[1].layout == "side-by-side");
        CHECK(table->rows[1].target_id == "T001");
        CHECK(table->rows[1].correct);
        CHECK_FALSE(table->rows[1].synthetic);
        CHECK(table->rows[1].response_time_s == 1.25);
    }

    TEST_CASE("Reading leaves nothing behind, and sees the answers of a session that runs or was killed") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        const auto study = fixtures::study({"direct"});
        const auto plan = fixtures::plan(study, "P01", 1);
        std::string bytes;
        {
            Store store = fixtures::open(path);
            REQUIRE(store.storePlan(study, plan));
            store.beginSession(fixtures::session("P01", false));
            store.record(fixtures::answer(plan.trials[1], 2), plan, fixtures::clips(plan));
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
            store.record(fixtures::answer(plan.trials[2], 1), plan, fixtures::clips(plan));
            ::kill(::getpid(), SIGKILL);
        }
        ::waitpid(child, nullptr, 0);
        REQUIRE(std::filesystem::exists(folder / "a.sqlite-wal"));
        CHECK(loadResponses(path)->rows.size() == 2);

        Store running = fixtures::open(path);
        running.beginSession(fixtures::session("P01", false));
        running.record(fixtures::answer(plan.trials[3], 1), plan, fixtures::clips(plan));
        CHECK(loadResponses(path)->rows.size() == 3);
    }

    TEST_CASE("Files that hold no answers are refused with what they are") {
        const fixtures::Folder folder;
        CHECK(contains(refusal(folder / "missing.sqlite"), "no such file"));
        CHECK(contains(refusal(folder / ""), "no such file"));
        std::ofstream(folder / "notes.txt") << "Dear diary, this file is certainly longer than a header.";
        CHECK(contains(refusal(folder / "notes.txt"), "not a SQLite database"));
        SQLite::Database(folder / "b.sqlite", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
            .exec("CREATE TABLE photos (id)");
        CHECK(contains(refusal(folder / "b.sqlite"), "another program"));
        std::ofstream(folder / "empty.sqlite").flush();
        CHECK(contains(refusal(folder / "empty.sqlite"), "no study yet"));
        const auto study = fixtures::study({"direct"});
        {
            Store store = fixtures::open(folder / "a.sqlite");
            CHECK(contains(refusal(folder / "a.sqlite"), "no study yet"));
            REQUIRE(store.storePlan(study, fixtures::plan(study, "P01", 1)));
        }
        CHECK(contains(refusal(folder / "a.sqlite"), "no answers yet"));
        SQLite::Database(folder / "a.sqlite", SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 7");
        CHECK(contains(refusal(folder / "a.sqlite"), "version 7"));
    }
}
