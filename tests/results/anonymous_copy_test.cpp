// The copy of a database that is given away.
#include "results/copies/anonymous_copy.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "fixtures.hpp"
#include "results/answers/response_table.hpp"
#include "results/database/tracking_blocks.hpp"
#include "results/participants/participants.hpp"
#include "text.hpp"
#include "withdrawal_fixture.hpp"

using namespace deixis;
using deixis::tests::contains;
using results::AnonymousOptions;
using results::copyAnonymously;

namespace {

const std::string remark_typed = "I work with Doctor Lindqvist";

/// Three who took part, one of them excluded, one who then declined consent, and one who withdrew.
void fillForCopy(const std::filesystem::path& path) {
    const auto study = fixtures::wideStudy();
    {
        results::Store store = fixtures::open(path);
        for (const char* who : {"Anna-Berg-7", "Bo_Ek-12", "Cleo-Dahl-5", "Disa-Falk-9", "Eva-Gran-3"}) {
            fixtures::withdrawal::takePart(store, study, who, remark_typed, 70);
            store.endSession(studies::SessionOutcome::finished, 1.7e9 + 600.0);
        }
        const auto plan = fixtures::widePlan(study, "Disa-Falk-9");
        store.beginSession(fixtures::session("Disa-Falk-9", false));
        auto rejection = fixtures::response(plan.trials[0]);
        rejection.trial_index = 0;
        SQLite::Database(path.string(), SQLite::OPEN_READWRITE, 1000)
            .exec(
                "INSERT INTO consents (participant, stage, session, agreed, utc_s, language, text) SELECT "
                "participant, 'consent', max(id), 0, 1.7e9 + 700.0, 'sv', 'I take part.' FROM sessions WHERE "
                "participant = 'Disa-Falk-9'");
    }
    REQUIRE(results::excludeParticipant(path, "Bo_Ek-12", "slept, says Karin"));
    REQUIRE(results::withdrawParticipant(path, "Eva-Gran-3", 1.7e9 + 800.0));
    SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
    database.exec(
        "INSERT INTO session_properties SELECT id, 'operating_system', 'Debian 12, Linux karins-pc' FROM "
        "sessions");
    database.exec(
        "INSERT INTO locked_changes (utc_s, what, reason) VALUES (1.7e9, '{\"changes\": "
        "[\"clips/karin/x.bvh was changed\"]}', 'Karin found a slip')");
    database.exec("UPDATE study SET source = 'avatar = \"/home/karin/avatars/ours.vrm\"'");
}

std::vector<std::string> namesOf(SQLite::Database& database, const std::string& query) {
    std::vector<std::string> out;
    SQLite::Statement rows(database, query);
    while (rows.executeStep()) out.push_back(rows.getColumn(0).getString());
    return out;
}

/// Numbers of the answers, whoever gave them.
std::vector<std::string> answersOf(const std::filesystem::path& path, const std::string& where) {
    SQLite::Database database(path.string(), SQLite::OPEN_READONLY);
    return namesOf(
        database,
        "SELECT printf('%d %s %s %s %.17g %.17g', r.trial_index, r.status, coalesce(a.question, ''), "
        "coalesce(a.value, ''), r.response_time_s, r.answered_s - r.onset_s) AS one FROM responses AS r "
        "LEFT JOIN answers AS a ON a.response = r.id WHERE " +
            where + " ORDER BY 1");
}

}  // namespace

TEST_SUITE("results/anonymous copy") {
    TEST_CASE("Nothing in the copy tells who, when or where; every answer is there, and the copy is sound") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        const auto copy = folder / "copy.sqlite";
        fillForCopy(path);
        const auto counts = copyAnonymously(path, copy, {});
        REQUIRE_MESSAGE(counts, counts.error().text());
        CHECK(counts->participants == 4);
        CHECK(counts->declined == 1);
        CHECK(counts->free_texts == 3);
        CHECK(counts->frames == 3 * 70);
        SQLite::Database original(path.string(), SQLite::OPEN_READONLY);
        SQLite::Database reader(copy.string(), SQLite::OPEN_READONLY);

        std::vector<std::string> secrets{"Anna",     "Berg",  "Bo_Ek",       "Cleo",      "Disa",
                                         "Eva-Gran", "Karin", "karin",       "Lindqvist", "made by a",
                                         "glasses",  "slept", "ours.vrm\"\""};
        for (const std::string& token : namesOf(original, "SELECT token FROM participants"))
            secrets.push_back(token);
        for (const std::string& token : namesOf(original, "SELECT token FROM withdrawals"))
            secrets.push_back(token);
        REQUIRE(secrets.size() == 13 + 5);
        const std::string bytes = readFile(copy).value();
        for (const std::string& secret : secrets) CHECK_MESSAGE(!contains(bytes, secret), secret);
        CHECK(contains(bytes, "avatar = \"ours.vrm\""));

        // No table is without rows, so that a column of which nothing was decided would have stopped the
        // copy; no number is a time of day.
        for (const std::string& table : namesOf(
                 reader, "SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite%'")) {
            CHECK_MESSAGE(reader.execAndGet("SELECT count(*) FROM " + table).getInt() > 0, table);
            for (const std::string& column :
                 namesOf(reader, "SELECT name FROM pragma_table_info('" + table + "') WHERE type = 'REAL'"))
                CHECK_MESSAGE(
                    reader.execAndGet("SELECT coalesce(max(" + column + "), 0) FROM " + table).getDouble() <
                        1e6,
                    table << "." << column);
        }
        CHECK(namesOf(reader, "SELECT id FROM participants") ==
              std::vector<std::string>{"A001", "A002", "A003", "A004"});
        CHECK(namesOf(reader, "SELECT number FROM participants ORDER BY id") ==
              std::vector<std::string>{"1", "2", "3", "4"});
        CHECK(namesOf(reader,
                      "SELECT DISTINCT json_extract(json, '$.participant') = participant AND "
                      "json_extract(json, '$.number') = (SELECT number FROM participants WHERE id = "
                      "participant) FROM plans") == std::vector<std::string>{"1"});
        CHECK(namesOf(reader, "SELECT coalesce(reason, '-') FROM participants ORDER BY status, 1") ==
              std::vector<std::string>{"-", "-", "-", "by the experimenter"});
        CHECK(namesOf(reader, "SELECT DISTINCT value FROM session_properties") ==
              std::vector<std::string>{"Debian 12"});
        CHECK(reader.execAndGet("SELECT count(*) FROM withdrawals").getInt() == 1);

        // Who refused has no answer; everybody else has all, with the same numbers.
        const std::string others = "participant <> 'Disa-Falk-9'";
        CHECK(answersOf(copy, "1") == answersOf(path, others));
        CHECK(reader.execAndGet("SELECT count(*) FROM responses WHERE hash IS NOT NULL").getInt() ==
              original.execAndGet("SELECT count(*) FROM responses WHERE " + others).getInt());
        const auto table = results::loadResponses(copy);  // every answer's hash fits, or this fails
        REQUIRE_MESSAGE(table, table.error().text());
        const auto before = results::loadResponses(path);
        REQUIRE(before);
        CHECK(table->rows.size() == before->rows.size());
        CHECK(table->withdrawn == 1);
        CHECK(table->left_out.size() == 2);
    }

    TEST_CASE("Tracked frames keep all but the clock's beginning; without them none is there") {
        const fixtures::Folder folder;
        fillForCopy(folder / "a.sqlite");
        SQLite::Database(  // the station's clock ran for a day
            (folder / "a.sqlite").string(), SQLite::OPEN_READWRITE)
            .exec("UPDATE events SET time_s = time_s - 40.0");
        REQUIRE(copyAnonymously(folder / "a.sqlite", folder / "copy.sqlite", {}));
        const auto framesIn = [&](const char* file) {
            SQLite::Database database((folder / file).string(), SQLite::OPEN_READONLY);
            SQLite::Statement row(database, "SELECT data FROM tracking_blocks ORDER BY id LIMIT 1");
            REQUIRE(row.executeStep());
            return results::unpackTracking(row.getColumn(0).getString()).value();
        };
        const auto before = framesIn("a.sqlite");
        const auto after = framesIn("copy.sqlite");
        REQUIRE(after.size() == before.size());
        for (std::size_t i = 0; i < after.size(); ++i) {
            // The sessions' first event stands at 10 s.
            CHECK(after[i].display_time_s == doctest::Approx(before[i].display_time_s - 10.0).epsilon(1e-9));
            CHECK(after[i].begun_s - after[i].display_time_s ==
                  doctest::Approx(before[i].begun_s - before[i].display_time_s));
            CHECK(after[i].head.stage_from_device.position == before[i].head.stage_from_device.position);
            CHECK(after[i].frame == before[i].frame);
        }
        AnonymousOptions without;
        without.tracking = false;
        REQUIRE(copyAnonymously(folder / "a.sqlite", folder / "less.sqlite", without));
        SQLite::Database less((folder / "less.sqlite").string(), SQLite::OPEN_READONLY);
        for (const char* table : {"tracking_blocks", "hand_joints", "trial_tracking"})
            CHECK(less.execAndGet(std::string("SELECT count(*) FROM ") + table).getInt() == 0);
    }

    TEST_CASE("What was typed is kept where that is asked for; the same database gives the same bytes") {
        const fixtures::Folder folder;
        fillForCopy(folder / "a.sqlite");
        AnonymousOptions options;
        options.free_text = true;
        const auto counts = copyAnonymously(folder / "a.sqlite", folder / "one.sqlite", options);
        REQUIRE(counts);
        CHECK(counts->free_texts == 0);
        REQUIRE(copyAnonymously(folder / "a.sqlite", folder / "two.sqlite", options));
        const std::string bytes = readFile(folder / "one.sqlite").value();
        CHECK(contains(bytes, remark_typed));
        CHECK(bytes == readFile(folder / "two.sqlite").value());
    }

    TEST_CASE("Nobody is given an id that another one had") {
        const fixtures::Folder folder;
        {
            const auto study = fixtures::wideStudy();
            results::Store store = fixtures::open(folder / "a.sqlite");
            for (const char* who : {"A002", "a1"}) {
                fixtures::withdrawal::takePart(store, study, who, "nothing", 2);
                store.endSession(studies::SessionOutcome::finished, 1.7e9 + 600.0);
            }
        }
        REQUIRE(copyAnonymously(folder / "a.sqlite", folder / "copy.sqlite", {}));
        SQLite::Database reader((folder / "copy.sqlite").string(), SQLite::OPEN_READONLY);
        CHECK(namesOf(reader, "SELECT id FROM participants ORDER BY 1") ==
              std::vector<std::string>{"B001", "B002"});
    }

    TEST_CASE("Of paths that are written whole the file's name is left; other texts stay as they are") {
        using results::withoutWholePaths;
        CHECK(withoutWholePaths("manifest = \"/home/karin/clips/manifest.csv\" # ours") ==
              "manifest = \"manifest.csv\" # ours");
        CHECK(withoutWholePaths("avatar = 'C:\\Users\\karin\\our avatar.vrm'") ==
              "avatar = 'our avatar.vrm'");
        CHECK(withoutWholePaths("x = [\"~/a/b\", \"/d/e/f\"]") == "x = [\"b\", \"f\"]");
        for (const char* same : {"manifest = \"clips/manifest.csv\"", "text = \"/ or not?\"",
                                 "a = \"../b/c\"", "see = \"https://x.org/y/z\"", "a = 1 / 2"})
            CHECK(withoutWholePaths(same) == same);
    }
}
