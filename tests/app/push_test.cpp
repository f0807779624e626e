// deixis push and deixis report against a real PostgreSQL server.
#include "pushed_files.hpp"

using namespace deixis::tests;

TEST_SUITE("app/push") {
    TEST_CASE(
        "What two stations push is what their files hold, told by the same report, and a second push is "
        "nothing") {
        PostgresServer* server = PostgresServer::get();
        if (server == nullptr) return;
        const Stations& files = stations();
        const std::string name = server->database();
        const std::string url = server->url(name);
        const auto first = push(files.a, url);
        REQUIRE_MESSAGE(first.status == 0, first.err);
        CHECK(first.out.find("3 participants, 3 sessions and ") != std::string::npos);
        pushed(files.b, url);
        checkCounts(*server, name, files.both);
        // Every number to its last digit, every text; sessions' and responses' numbers are the server's own.
        CHECK(onServer(*server, name, answers_sql) == inFile(files.both, answers_sql));
        const std::string bytes =
            "SELECT s.participant, encode(t.data, 'hex') FROM tracking_blocks AS t JOIN sessions AS s ON "
            "s.id = "
            "t.session ORDER BY 1";
        CHECK(onServer(*server, name, bytes) == "S004|00ff275c0a\nS005|00ff275c0a\nS006|00ff275c0a\n");
        const std::string joints =
            " FROM hand_joints AS h JOIN sessions AS s ON s.id = h.session WHERE participant = 'S005' AND "
            "frame = 1234";
        CHECK(onServer(*server, name, "SELECT encode(joints, 'hex'), encode(flags, 'hex')" + joints) ==
              inFile(files.b, "SELECT lower(hex(joints)), lower(hex(flags))" + joints));

        for (const std::string& file : {files.a, files.b, files.both}) {
            const auto again = push(file, url);
            REQUIRE_MESSAGE(again.status == 0, again.err);
            CHECK(again.out.rfind("nothing new", 0) == 0);
        }
        checkCounts(*server, name, files.both);

        const Scratch scratch;
        for (const auto& [data, to] :
             {std::pair{files.both, scratch / "files"}, {"'" + url + "'", scratch / "server"}}) {
            const auto report = program("report " + data + " --without-clips --resamples 200 -o " + to +
                                        ".html --json " + to + ".json");
            REQUIRE_MESSAGE(report.status == 0, report.err);
        }
        CHECK(slurp(scratch / "server.json") ==
              replaced(slurp(scratch / "files.json"), "\"both.sqlite\"", "\"" + url + "\""));
        CHECK(slurp(scratch / "server.html") ==
              replaced(slurp(scratch / "files.html"), "both.sqlite", replaced(url, "&", "&amp;")));
    }

    TEST_CASE(
        "What goes on, is excluded or withdrawn at a station is so on the server after the next push, for "
        "good") {
        PostgresServer* server = PostgresServer::get();
        if (server == nullptr) return;
        const Scratch scratch;
        const std::string name = server->database();
        const std::string url = server->url(name);
        const std::string file = scratch / "a.sqlite";
        const std::string early = scratch / "early.sqlite";
        fs::copy_file(stations().a, file);
        fs::copy_file(file, early);
        // As it was while S003 took part, and S002 had no token yet.
        change(early,
               "UPDATE participants SET token = NULL WHERE id = 'S002';"
               "CREATE TEMP TABLE later AS SELECT id FROM responses WHERE participant = 'S003' AND "
               "trial_index > 20;"
               "DELETE FROM answers WHERE response IN later; DELETE FROM response_stimuli WHERE response IN "
               "later; DELETE FROM response_values WHERE response IN later;"
               "DELETE FROM responses WHERE id IN later;"
               "DELETE FROM events WHERE session = 3 AND id >= (SELECT min(id) FROM events WHERE session = 3 "
               "AND "
               "trial_index > 20);"
               "UPDATE sessions SET ended_utc_s = NULL, outcome = NULL WHERE participant = 'S003'");
        const std::string responses = "SELECT count(*) FROM responses";
        pushed(early, url);
        CHECK(onServer(*server, name, responses) == inFile(early, responses));
        pushed(file, url);
        checkCounts(*server, name, file);
        CHECK(onServer(*server, name, answers_sql) == inFile(file, answers_sql));
        const std::string tokens = "SELECT id, token FROM participants ORDER BY 1";
        CHECK(onServer(*server, name, tokens) == inFile(file, tokens));
        const std::string sessions = "SELECT participant, outcome, ended_utc_s FROM sessions ORDER BY 1";
        CHECK(onServer(*server, name, sessions) == inFile(file, sessions));

        // The early copy has nothing to say any more.
        const auto stale = push(early, url);
        CHECK(stale.out.find("more of them than this file: S003") != std::string::npos);
        CHECK(onServer(*server, name, sessions) == inFile(file, sessions));
        CHECK(onServer(*server, name, tokens) == inFile(file, tokens));
        change(early, "UPDATE participants SET token = '0123456789abcdef' WHERE id = 'S002'");
        CHECK_FAILS_SAYING(push(early, url), "participant S002", "token is not what", "never altered");

        REQUIRE(program("participants exclude " + file + " S002 --reason 'heard the answers'").status == 0);
        const auto excluded = push(file, url);
        CHECK(excluded.out.find("1 rows changed") != std::string::npos);
        const std::string status = "SELECT id, status, reason FROM participants ORDER BY id";
        CHECK(onServer(*server, name, status) ==
              "S001|active|\\N\nS002|excluded|heard the answers\nS003|active|\\N\n");

        REQUIRE(program("participants withdraw " + file + " S001 --yes").status == 0);
        const auto erased = push(file, url);
        CHECK(erased.out.find("erased because withdrawn: S001") != std::string::npos);
        checkCounts(*server, name, file);
        CHECK(server->sql(name, "SELECT count(*) FROM " + schemaIn(*server, name) + ".withdrawals") == "1\n");
        // An older copy does not bring them back, and is told so.
        const auto older = push(stations().a, url);
        CHECK(older.status == 0);
        CHECK(older.out.find("not pushed because withdrawn after they took part: S001") != std::string::npos);
        CHECK(onServer(*server, name, "SELECT count(*) FROM participants") == "2\n");
        CHECK(onServer(*server, name, "SELECT count(*) FROM withdrawals") == "1\n");
    }

    TEST_CASE(
        "An answer that is another on the server, or another person's number, is rejected and nothing is "
        "written") {
        PostgresServer* server = PostgresServer::get();
        if (server == nullptr) return;
        const Scratch scratch;
        const std::string name = server->database();
        const std::string url = server->url(name);
        const std::string other = scratch / "other.sqlite";
        pushed(stations().a, url);
        const auto before = onServer(*server, name, answers_sql);
        fs::copy_file(stations().both, other);
        change(
            other,
            "UPDATE responses SET hash = NULL WHERE participant = 'S002';"
            "UPDATE response_values SET value = (value + 1) % 3 WHERE name = 'chosen_place' AND response = "
            "(SELECT max(response) FROM game_choices WHERE participant = 'S002' AND chosen_place IS NOT "
            "NULL)");
        CHECK_FAILS_SAYING(push(other, url), "other.sqlite",
                           "table response_values, participant S002, response ",
                           "name chosen_place: value is not what", "never altered");
        fs::remove(other);
        fs::copy_file(stations().b, other);
        change(other, "UPDATE participants SET number = 2 WHERE id = 'S005'");
        CHECK_FAILS_SAYING(push(other, url), "participant S005 has the number 2, which S002 has");
        CHECK(onServer(*server, name, answers_sql) == before);
        CHECK(onServer(*server, name, "SELECT count(*) FROM participants") == "3\n");
    }

    TEST_CASE(
        "A push that is killed leaves nothing of itself, whenever it is, and pushing again brings all") {
        PostgresServer* server = PostgresServer::get();
        if (server == nullptr) return;
        const Stations& files = stations();
        const std::string name = server->database();
        const std::string url = server->url(name);
        pushed(files.a, url);
        const std::string schema = schemaIn(*server, name);
        {
            // Stopped for sure in the middle: its participants are written, its responses wait for this lock.
            Background holder(server->psql(name) + " -c 'BEGIN; LOCK TABLE " + schema +
                              ".responses IN ACCESS EXCLUSIVE MODE; SELECT pg_sleep(300)' >/dev/null 2>&1");
            const std::string held =
                "SELECT count(*) FROM pg_locks WHERE granted AND mode = 'AccessExclusiveLock' AND relation "
                "= '" +
                schema + ".responses'::regclass";
            REQUIRE(eventually(60, [&] { return server->sql(name, held) == "1\n"; }));
            Background pushing(programFile() + " push " + files.b + " '" + url + "' >/dev/null 2>&1");
            REQUIRE(eventually(60, [&] {
                return server->sql(
                           name,
                           "SELECT count(*) FROM pg_stat_activity WHERE application_name = 'deixis' AND "
                           "wait_event_type = 'Lock'") == "1\n";
            }));
            pushing.kill(SIGKILL);
            server->sql(name,
                        "SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE query LIKE "
                        "'%pg_sleep(300)%' AND "
                        "pid <> pg_backend_pid()");
        }
        REQUIRE(eventually(60, [&] {
            return server->sql(name,
                               "SELECT count(*) FROM pg_stat_activity WHERE application_name = 'deixis'") ==
                   "0\n";
        }));
        checkCounts(*server, name, files.a);

        int killed = 0;
        for (int i = 0; i < 8; ++i) {
            Background pushing(programFile() + " push " + files.b + " '" + url + "' >/dev/null 2>&1");
            std::this_thread::sleep_for(std::chrono::milliseconds(30 + 60 * i));
            if (!pushing.running()) break;
            pushing.kill(SIGKILL);
            ++killed;
            const std::string people = onServer(*server, name, "SELECT count(*) FROM participants");
            // Its last message to the server may have been that all is to be kept.
            if (people == "6\n") break;
            CHECK(people == "3\n");
        }
        CHECK(killed > 0);
        pushed(files.b, url);
        checkCounts(*server, name, files.both);
        CHECK(onServer(*server, name, answers_sql) == inFile(files.both, answers_sql));
    }

    TEST_CASE("Stations that push at the same time, the study's first time too, do not disturb each other") {
        PostgresServer* server = PostgresServer::get();
        if (server == nullptr) return;
        const Stations& files = stations();
        const std::string name = server->database();
        const std::string url = server->url(name);
        {
            std::vector<std::unique_ptr<Background>> all;
            for (const std::string& file : {files.a, files.b, files.both, files.b, files.a})
                all.push_back(std::make_unique<Background>(programFile() + " push " + file + " '" + url +
                                                           "' >/dev/null"));
            for (const auto& one : all) CHECK(one->wait() == 0);
        }
        checkCounts(*server, name, files.both);
        CHECK(onServer(*server, name, answers_sql) == inFile(files.both, answers_sql));
    }
}
