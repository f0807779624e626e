// Databases of earlier versions.
#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>

#include <map>

#include "core/files.hpp"
#include "fixtures.hpp"
#include "results/response_table.hpp"

using namespace deixis;
using results::Durability;
using results::Store;

namespace {

/// Made by the program of that time; see the file's head.
void makeVersion1(const std::filesystem::path& path) {
    const auto sql =
        readFile(std::filesystem::path(DEIXIS_SOURCE_DIR) / "tests/results/reference/database_version_1.sql");
    REQUIRE(sql);
    SQLite::Database(path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(*sql);
}

/// Table -> its columns, separated by commas.
std::map<std::string, std::string> columns(SQLite::Database& database) {
    std::map<std::string, std::string> out;
    SQLite::Statement row(database,
                          "SELECT t.name, group_concat(c.name, ', ') FROM sqlite_schema AS t, "
                          "pragma_table_info(t.name) AS c WHERE t.type = 'table' GROUP BY t.name");
    while (row.executeStep()) out[row.getColumn(0).getString()] = row.getColumn(1).getString();
    return out;
}

/// All that stands in these columns, each value with its type.
std::string contents(SQLite::Database& database, const std::map<std::string, std::string>& of) {
    std::string out;
    for (const auto& [table, names] : of) {
        SQLite::Statement row(database, "SELECT " + names + " FROM " + table + " ORDER BY " + names);
        while (row.executeStep()) {
            out += table;
            for (int i = 0; i < row.getColumnCount(); ++i) {
                const auto value = row.getColumn(i);
                out += "|" + std::to_string(value.getType()) + ":" + value.getString();
            }
            out += "\n";
        }
    }
    return out;
}

std::string schema(const std::filesystem::path& path) {
    SQLite::Database database(path.string());
    SQLite::Statement row(database, "SELECT type, name, sql FROM sqlite_schema ORDER BY type, name");
    std::string out;
    while (row.executeStep())
        out += row.getColumn(0).getString() + " " + row.getColumn(1).getString() + " " +
               row.getColumn(2).getString() + "\n";
    return out;
}

}  // namespace

TEST_SUITE("results/migration") {
    TEST_CASE("A database of version 1 is brought to version 2 with all that it holds") {
        const fixtures::Folder folder;
        makeVersion1(folder / "a.sqlite");
        std::map<std::string, std::string> old_columns;
        std::string before;
        {
            SQLite::Database old((folder / "a.sqlite").string());
            REQUIRE(old.execAndGet("PRAGMA user_version").getInt() == 1);
            old_columns = columns(old);
            before = contents(old, old_columns);
        }
        CHECK(old_columns.size() == 9);
        { Store store = fixtures::open(folder / "a.sqlite"); }
        { Store fresh = fixtures::open(folder / "b.sqlite"); }
        SQLite::Database database((folder / "a.sqlite").string());
        CHECK(contents(database, old_columns) == before);
        CHECK(database.execAndGet("PRAGMA user_version").getInt() == 2);
        CHECK(database.execAndGet("PRAGMA application_id").getInt() == 0x44584953);
        CHECK(database.execAndGet("PRAGMA integrity_check").getString() == "ok");
        CHECK(database.execAndGet("SELECT count(*) FROM pragma_foreign_key_check").getInt() == 0);
        CHECK(schema(folder / "a.sqlite") == schema(folder / "b.sqlite"));
    }

    TEST_CASE("The paused time that version 1 took off a response time is found again") {
        const fixtures::Folder folder;
        makeVersion1(folder / "a.sqlite");
        { Store store = fixtures::open(folder / "a.sqlite"); }
        SQLite::Database database((folder / "a.sqlite").string());
        SQLite::Statement row(database, "SELECT pauses, paused_s, dropped_frames FROM responses_flat");
        int rows = 0;
        int paused = 0;
        while (row.executeStep()) {
            ++rows;
            paused += row.getColumn(0).getInt();
            CHECK(row.getColumn(1).getDouble() == (row.getColumn(0).getInt() == 1 ? 0.5 : 0.0));
            CHECK(row.getColumn(2).isNull());
        }
        CHECK(rows == 7);
        CHECK(paused == 1);
    }

    TEST_CASE("A session begun with version 1 goes on") {
        const fixtures::Folder folder;
        makeVersion1(folder / "a.sqlite");
        Store store = fixtures::open(folder / "a.sqlite");
        const auto plan = store.plan("S001");
        REQUIRE(plan);
        CHECK(store.answeredTrials("S001") == std::set<int>{1, 2, 3, 4, 6, 7, 8});
        store.beginSession(fixtures::session("S001", true));
        auto answer = fixtures::answer(plan->trials[9], 1);
        answer.paused_s = 1.5;
        store.record(answer, *plan, fixtures::clips(*plan));
        store.recordTracking(std::vector<results::TrackedFrame>{{fixtures::frame(1), 9}}, {});
        SQLite::Database database((folder / "a.sqlite").string());
        CHECK(database.execAndGet("SELECT paused_s FROM responses WHERE trial_index = 9").getDouble() == 1.5);
        CHECK(database.execAndGet("SELECT count(*) FROM responses_flat").getInt() == 8);
    }

    TEST_CASE("A report reads version 1 as it is, and finds the same in version 2") {
        const fixtures::Folder folder;
        makeVersion1(folder / "a.sqlite");
        const auto bytes = readFile(folder / "a.sqlite");
        const auto before = results::loadResponses(folder / "a.sqlite");
        REQUIRE(before);
        CHECK(readFile(folder / "a.sqlite").value() == bytes.value());
        { Store store = fixtures::open(folder / "a.sqlite"); }
        CHECK(readFile(folder / "a.sqlite").value() != bytes.value());
        const auto after = results::loadResponses(folder / "a.sqlite");
        REQUIRE(after);
        REQUIRE(before->rows.size() == 7);
        REQUIRE(after->rows.size() == 7);
        for (std::size_t i = 0; i < 7; ++i) {
            CHECK(before->rows[i].target_id == after->rows[i].target_id);
            CHECK(before->rows[i].response_time_s == after->rows[i].response_time_s);
            CHECK(before->rows[i].rating == after->rows[i].rating);
            CHECK(before->rows[i].correct == after->rows[i].correct);
        }
    }

    TEST_CASE("A migration that fails leaves the database as it was") {
        const fixtures::Folder folder;
        makeVersion1(folder / "a.sqlite");
        // In the way of the new table of that name.
        SQLite::Database(folder / "a.sqlite", SQLite::OPEN_READWRITE).exec("CREATE TABLE hand_joints (mine)");
        const auto before = schema(folder / "a.sqlite");
        CHECK_FALSE(Store::open(folder / "a.sqlite", Durability::each_answer));
        SQLite::Database database((folder / "a.sqlite").string());
        CHECK(database.execAndGet("PRAGMA user_version").getInt() == 1);
        CHECK(schema(folder / "a.sqlite") == before);
        CHECK(database.execAndGet("SELECT count(*) FROM responses_flat").getInt() == 7);
    }
}
