// Damaged databases: what is wrong is found before anything is read or written.
#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/random.hpp"
#include "fixtures.hpp"
#include "results/analysis/analysis.hpp"
#include "results/answers/response_table.hpp"
#include "results/copies/data_export.hpp"
#include "results/copies/merge.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/participants/participants.hpp"
#include "text.hpp"

using namespace deixis;
using deixis::tests::contains;
using results::Durability;
using results::Store;

namespace fs = std::filesystem;

namespace {

std::string bytesOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write(const fs::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

/// Every number of a report, in order; but not when sessions began and ended, which no hash covers.
void addNumbers(const nlohmann::json& json, std::vector<double>& out) {
    if (json.is_number()) out.push_back(json.get<double>());
    if (json.is_boolean()) out.push_back(json.get<bool>() ? 1.0 : 0.0);
    for (const auto& part : json)
        if (json.is_structured()) addNumbers(part, out);
}

Result<std::vector<double>> numbersOf(const fs::path& database) {
    const auto table = results::loadResponses(database);
    if (!table) return tl::unexpected(table.error());
    std::vector<double> out;
    auto report = nlohmann::json::parse(results::analysisJson(results::analyse(*table)));
    report.erase("session_times");
    addNumbers(report, out);
    return out;
}

/// Eight participants of a small study, all trials answered; one file, no log.
void makeDatabase(const fs::path& path) {
    const auto study = fixtures::study({"direct", "stiff", "drifting"});
    fixtures::fill(path, study, 8, 2, false, {0.9, 0.6, 0.3}, {4.0, 3.0, 2.0}, fixtures::everything);
}

std::string rejection(const fs::path& path) {
    const auto read = results::loadResponses(path);
    const auto written = Store::open(path, Durability::each_answer);
    REQUIRE_FALSE(read);
    REQUIRE_FALSE(written);
    CHECK(read.error().where == path.string());
    CHECK(read.error().text() == written.error().text());
    return read.error().message;
}

}  // namespace

TEST_SUITE("results/database check") {
    TEST_CASE("Of 300 files with random bytes changed each is rejected, or its report has the same numbers") {
        const fixtures::Folder folder;
        makeDatabase(folder / "whole.sqlite");
        const std::string whole = bytesOf(folder / "whole.sqlite");
        const auto expected = numbersOf(folder / "whole.sqlite");
        REQUIRE(expected);
        REQUIRE(expected->size() > 100);
        const fs::path path = folder / "damaged.sqlite";
        int rejected = 0, by_hash = 0;
        for (int i = 0; i < 300; ++i) {
            Random random(static_cast<std::uint64_t>(i), "damage");
            std::string bytes = whole;
            const auto changes = 1 + random.below(8);
            for (std::uint64_t k = 0; k < changes; ++k)
                bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
            write(path, bytes);
            const auto found = numbersOf(path);
            if (!found) {
                ++rejected;
                by_hash += contains(found.error().message, "not as it was written") ? 1 : 0;
                CHECK(found.error().where == path.string());
            } else if (*found != *expected) {
                FAIL_CHECK("other numbers after damage " << i);
            }
        }
        CHECK(rejected > 100);
        CHECK(by_hash > 20);  // which integrity_check cannot see
        MESSAGE(rejected << " of 300 rejected, " << by_hash << " of them by an answer's hash");
    }

    TEST_CASE("A value changed behind the program's back is rejected with its table and row, if it counts") {
        const fixtures::Folder folder;
        makeDatabase(folder / "whole.sqlite");
        const std::string whole = bytesOf(folder / "whole.sqlite");
        const fs::path path = folder / "changed.sqlite";
        for (const char* change :
             {"UPDATE answers SET value = value + 1 WHERE response = 3",
              "DELETE FROM answers WHERE response = 3",
              "INSERT INTO answers VALUES (3, 9, 'rating', 0, 5.0, NULL)",
              "UPDATE response_values SET value = 1 - value WHERE response = 9 AND name = 'correct'",
              "UPDATE responses SET response_time_s = response_time_s + 0.001 WHERE id = 3",
              "UPDATE responses SET superseded = 'x', superseded_utc_s = 1.0 WHERE id = 3",
              "UPDATE responses SET status = 'skipped' WHERE id = 3",
              "UPDATE trial_stimuli SET system = 'stiff' WHERE system = 'direct'",
              "UPDATE trial_stimuli SET scored = 0 WHERE participant = 'P02'",
              "UPDATE trials SET practice = 1 WHERE participant = 'P02' AND trial_index = 4",
              "UPDATE trials SET layout = 'across' WHERE layout = 'side-by-side'",
              "UPDATE response_stimuli SET clip_hash = 'x' WHERE response = 3",
              "UPDATE sessions SET synthetic = 1 WHERE participant = 'P01'",
              "UPDATE stages SET scale_high = 7 WHERE scale_high = 5", "UPDATE study SET alpha = 0.05"}) {
            INFO(change);
            write(path, whole);
            SQLite::Database(path.string(), SQLite::OPEN_READWRITE).exec(change);
            const std::string said = rejection(path);
            INFO(said);
            CHECK(contains(said, "table responses, row "));
            CHECK(contains(said, "participant P0"));
            for (const auto& also : {results::listParticipants(path).has_value(),
                                     results::excludeParticipant(path, "P01", "x").has_value(),
                                     results::mergeDatabases({path}, folder / "merged.sqlite").has_value()})
                CHECK_FALSE(also);
        }
        // Meant and said so: the answer counts again.
        write(path, whole);
        SQLite::Database(path.string(), SQLite::OPEN_READWRITE)
            .exec(
                "UPDATE answers SET value = 1 WHERE response = 3; UPDATE responses SET hash = NULL WHERE id "
                "= 3");
        CHECK(results::loadResponses(path).has_value());
        // What no answer hangs on may change.
        SQLite::Database(path.string(), SQLite::OPEN_READWRITE)
            .exec("UPDATE study SET title = 'Ein anderer Titel'; DELETE FROM events");
        CHECK(results::loadResponses(path).has_value());
    }

    TEST_CASE("A row that refers to one that is not there is rejected with its table and row") {
        const fixtures::Folder folder;
        const auto path = folder / "a.sqlite";
        makeDatabase(path);
        SQLite::Database(path.string(), SQLite::OPEN_READWRITE)
            .exec(
                "PRAGMA foreign_keys = OFF; UPDATE events SET session = 99 WHERE id = 1;"
                "INSERT INTO events VALUES (7777, 99, 'pause', NULL, 0.0, 0.0, '')");
        CHECK(contains(rejection(path), "table events, row 7777 refers to a row of sessions"));
    }

    TEST_CASE("What is superseded, merged or withdrawn stays as it was written") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        const auto path = folder / "a.sqlite";
        const auto plan = fixtures::plan(study, "P01", 2);
        const auto other = fixtures::plan(study, "P02", 2);
        {
            Store store = fixtures::open(path);
            for (const auto& each : {plan, other}) {
                fixtures::store(store, study, each);
                store.beginSession(fixtures::session(each.participant, false));
                for (std::size_t trial = 0; trial < 4; ++trial)
                    store.record(fixtures::answer(each.trials[trial], 1), study, each, fixtures::clips(each));
                store.record(studies::Superseded{3, "a phone rang", {60.0, 1.7e9 + 60.0}}, study, each,
                             fixtures::clips(each));
                store.record(fixtures::answer(each.trials[3], 0), study, each, fixtures::clips(each));
                store.endSession(studies::SessionOutcome::quit, 1.7e9 + 60.0);
            }
        }
        const auto hashes = [&](const fs::path& database) {
            SQLite::Database open(database.string());
            return open
                .execAndGet(
                    "SELECT group_concat(hash, ' ') FROM (SELECT hash FROM responses WHERE "
                    "participant = 'P02' ORDER BY id)")
                .getString();
        };
        CHECK(hashes(path).size() == 5 * 65 - 1);
        CHECK(results::loadResponses(path).has_value());
        REQUIRE(results::excludeParticipant(path, "P01", "x"));
        CHECK(results::loadResponses(path).has_value());
        const auto before = hashes(path);
        REQUIRE(results::withdrawParticipant(path, "P01", 1.8e9));
        CHECK(results::loadResponses(path).has_value());
        CHECK(hashes(path) == before);
        REQUIRE(results::mergeDatabases({path}, folder / "merged.sqlite"));
        CHECK(hashes(folder / "merged.sqlite") == before);
        CHECK(results::loadResponses(folder / "merged.sqlite").has_value());
        CHECK(SQLite::Database((folder / "merged.sqlite").string())
                  .execAndGet("SELECT min(id) FROM responses")
                  .getInt() == 1);  // counted again
    }
}
