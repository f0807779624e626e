// One participant's session: resumed, interrupted, twice at once.
#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>

#include "program.hpp"

using namespace deixis::tests;

namespace {

int answerCount(const std::string& database) {
    try {
        SQLite::Database db(database, SQLite::OPEN_READONLY, 1000);
        return db
            .execAndGet(
                "select count(*) from responses join trials using (participant, trial_index) where kind <> "
                "'questionnaire' and not "
                "practice")
            .getInt();
    } catch (const SQLite::Exception&) {
        return 0;  // not made yet
    }
}

std::string rows(const std::string& database, const std::string& query) {
    return shell("sqlite3 -readonly " + database + " \"" + query + "\"").out;
}

}  // namespace

TEST_SUITE("app/session") {
    TEST_CASE("a session killed at any moment goes on with no answered trial lost or asked twice") {
        const Scratch scratch;
        const std::string database = scratch / "study.sqlite";
        const std::string command = "run pointing2023-stand-ins --station simulated --participant P07 --db " +
                                    database + " >/dev/null 2>&1";
        std::string before;
        int kills = 0;
        // Three kills in the midst of answering, each from where the last left off.
        for (const int wanted : {5, 22, 40}) {
            Background session(programFile() + " " + command);
            eventually(120.0, [&] { return answerCount(database) >= wanted || !session.running(); });
            session.kill(SIGKILL);
            const std::string now = rows(database,
                                         "select trial_index, value, chosen_place, answered_s from "
                                         "responses_flat where not practice order by 1");
            REQUIRE(std::count(now.begin(), now.end(), '\n') >= wanted);
            // What was answered before stands unchanged.
            for (std::size_t at = 0; at < before.size();) {
                const std::size_t end = before.find('\n', at) + 1;
                CHECK(now.find(before.substr(at, end - at)) != std::string::npos);
                at = end;
            }
            before = now;
            ++kills;
        }
        CHECK(kills == 3);
        const int kept = answerCount(database);
        CHECK(kept >= 40);
        const auto last =
            program("run pointing2023-stand-ins --station simulated --participant P07 --db " + database);
        INFO(last.err);
        REQUIRE(last.status == 0);
        CHECK(answerCount(database) == 60);
        CHECK(rows(database,
                   "select count(distinct trial_index) from responses_flat where not practice and kind <> "
                   "'questionnaire'") == "60\n");
        CHECK(rows(database,
                   "select count(*) from responses_flat where not practice and correct is not null and "
                   "chosen_place >= 0") == "40\n");
    }

    TEST_CASE("a participant who has finished is not asked again") {
        const Scratch scratch{WithSharedStimuli{}};
        const std::string run =
            "run pointing2023-stand-ins --station simulated --participant P01 --db " + (scratch / "s.sqlite");
        const auto first = program(run);
        INFO(first.err);
        REQUIRE(first.status == 0);
        CHECK(first.out.find("database: " + (scratch / "s.sqlite")) != std::string::npos);
        CHECK(first.out.find("report:   " + (scratch / "s.html")) != std::string::npos);
        const auto again = program(run);
        CHECK(again.status == 0);
        CHECK(again.out.find("answered every trial already") != std::string::npos);
        CHECK(answerCount(scratch / "s.sqlite") == 60);
    }

    TEST_CASE("two runs of one participant at once are rejected, another participant is not") {
        const Scratch scratch{WithSharedStimuli{}};
        const std::string database = scratch / "study.sqlite";
        // Long, so that the first is still under way when the second comes.
        std::string study = replaced(shippedStudy(), "count = 100\n", "count = 140\n");
        study = replaced(study, "items = 5\n", "items = 60\n");
        study = replaced(study, "items = 10\n", "items = 60\n");
        spill(scratch / "study.toml", study);
        const std::string run =
            "run " + (scratch / "study.toml") + " --station simulated --db " + database + " --participant ";
        Background first(programFile() + " " + run + "P01 >/dev/null 2>&1");
        REQUIRE(eventually(60.0, [&] { return answerCount(database) >= 1; }));
        CHECK_FAILS_SAYING(program(run + "P01"), "P01", "study.sqlite");
        CHECK(first.running());
    }

    TEST_CASE("a simulated participant does not go on with a person's session") {
        const Scratch scratch{WithSharedStimuli{}};
        const std::string database = scratch / "study.sqlite";
        REQUIRE(program("simulate pointing2023-stand-ins --participants 1 --db " + database).status == 0);
        REQUIRE(
            shell(
                "sqlite3 " + database +
                " 'update sessions set synthetic = 0; delete from answers where response in (select id from "
                "responses where trial_index > 20); delete from response_stimuli where response in (select "
                "id from responses where trial_index > 20); delete from response_values where response in "
                "(select "
                "id from responses where trial_index > 20); delete from responses where trial_index > 20; "
                "update responses set hash = NULL'")
                .status == 0);
        const int before = answerCount(database);
        CHECK_FAILS_SAYING(
            program("run pointing2023-stand-ins --station simulated --participant S001 --db " + database),
            "S001", "person", "not mixed");
        CHECK(answerCount(database) == before);
    }

    TEST_CASE("the simulated participant answers the same drawn or not, here or in a whole study") {
        const Scratch scratch{WithSharedStimuli{}};
        REQUIRE(program("run pointing2023-stand-ins --station simulated --participant S002 --db " +
                        (scratch / "one.sqlite"))
                    .status == 0);
        REQUIRE(program("simulate pointing2023-stand-ins --participants 2 --db " + (scratch / "many.sqlite"))
                    .status == 0);
        const std::string query =
            "select trial_index, value, chosen_place from responses_flat where participant = 'S002' order by "
            "1";
        CHECK(rows(scratch / "one.sqlite", query) == rows(scratch / "many.sqlite", query));
        CHECK(rows(scratch / "one.sqlite", query).size() > 100);
    }
}
