// deixis push and deixis report against a real PostgreSQL server.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <map>
#include <memory>

#include "postgres_server.hpp"
#include "text.hpp"

using namespace deixis::tests;

namespace {

void change(const std::string& database, const std::string& sql) {
    SQLite::Database(database, SQLite::OPEN_READWRITE).exec(sql);
}

constexpr const char* tables_of_sessions[]{"events",         "tracking_blocks",    "hand_joints",
                                           "trial_tracking", "session_properties", "consents"};
constexpr const char* tables_of_people[]{"trial_stimuli",      "trials",  "plans", "participant_fields",
                                         "participant_groups", "sessions"};

/// Leaves out people, as if they had never been there.
void leaveOut(const std::string& database, const std::string& ids) {
    const std::string who = " IN (" + ids + ")";
    std::string sql;
    for (const char* table : {"answers", "response_stimuli"})
        sql += std::string("DELETE FROM ") + table +
               " WHERE response IN (SELECT id FROM responses WHERE participant" + who + ");";
    sql += "DELETE FROM responses WHERE participant" + who + ";";
    for (const char* table : tables_of_sessions)
        sql += std::string("DELETE FROM ") + table +
               " WHERE session IN (SELECT id FROM sessions WHERE participant" + who + ");";
    for (const char* table : tables_of_people)
        sql += std::string("DELETE FROM ") + table + " WHERE participant" + who + ";";
    change(database, sql + "DELETE FROM participants WHERE id" + who);
}

/// Two stations' files of one study, three simulated participants each, the second with tracked frames of 8
/// MB.
struct Stations {
    Scratch folder{WithSharedStimuli{}};
    std::string a = folder / "a.sqlite";
    std::string b = folder / "b.sqlite";
    std::string both = folder / "both.sqlite";

    Stations() {
        const auto made = program("simulate pointing2023 --participants 6 --db " + a);
        REQUIRE_MESSAGE(made.status == 0, made.err);
        const std::string rest = folder / "rest.sqlite";
        fs::copy_file(a, rest);
        fs::copy_file(a, folder / "same.sqlite");
        leaveOut(a, "'S004', 'S005', 'S006'");
        leaveOut(rest, "'S001', 'S002', 'S003'");
        change(
            rest,
            "INSERT INTO tracking_blocks SELECT NULL, id, 1, 1, 3, 0.25, 1.5, x'00ff275c0a' FROM sessions;"
            "INSERT INTO trial_tracking SELECT id, 1, 3, 0, 0, 0.1, 0, 0.25, 1.5 FROM sessions;"
            "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 3000) "
            "INSERT INTO hand_joints SELECT id, i, 'left', randomblob(832), randomblob(26) FROM sessions, n");
        // Joined with itself it counts its sessions and responses from 1, as a station's file does.
        fs::copy_file(rest, folder / "copy.sqlite");
        for (const auto& [from, to] :
             {std::pair{rest + " " + (folder / "copy.sqlite"), b}, {a + " " + b, both}}) {
            const auto joined = program("merge " + from + " -o " + to);
            REQUIRE_MESSAGE(joined.status == 0, joined.err);
        }
    }
};

/// Takes away what version 5 added, in a file or on a server.
constexpr const char* back_to_4 =
    "DROP VIEW responses_flat; ALTER TABLE study DROP COLUMN locked_hash;"
    "ALTER TABLE plans DROP COLUMN locked_hash; DROP INDEX sessions_of_participant;"
    "DROP INDEX responses_of_participant;"
    "ALTER TABLE participants DROP COLUMN token; ALTER TABLE trials DROP COLUMN visibility;"
    "ALTER TABLE responses DROP COLUMN viewer_x_m; ALTER TABLE responses DROP COLUMN viewer_z_m;"
    "ALTER TABLE responses DROP COLUMN viewer_heading_deg; ALTER TABLE responses DROP COLUMN hash;"
    "DROP TABLE locked_changes; ALTER TABLE withdrawals DROP COLUMN token;"
    "ALTER TABLE withdrawals DROP COLUMN cleared;"
    "ALTER TABLE withdrawals ADD COLUMN participant_hash TEXT;";

const Stations& stations() {
    static const Stations made;
    return made;
}

Finished push(const std::string& database, const std::string& url) {
    return program("push " + database + " '" + url + "'");
}

void pushed(const std::string& database, const std::string& url) {
    const auto done = push(database, url);
    REQUIRE_MESSAGE(done.status == 0, done.err);
}

std::string schemaIn(const PostgresServer& server, const std::string& database) {
    std::string name = server.sql(database, "SELECT nspname FROM pg_namespace WHERE nspname LIKE 'deixis%'");
    return name.substr(0, name.find('\n'));
}

constexpr const char* answers_sql =
    "SELECT participant, trial_index, system, item, chosen_place, correct, text, answered_utc, value, "
    "response_time_s, head_qw FROM responses_flat ORDER BY 1, 2, 3, 4, 9";

std::string onServer(const PostgresServer& server, const std::string& database, const std::string& sql) {
    return server.sql(database, "SET search_path = " + schemaIn(server, database) + "; " + sql);
}

std::string inFile(const std::string& database, const std::string& sql) {
    SQLite::Database open(database, SQLite::OPEN_READONLY);
    SQLite::Statement rows(open, sql);
    std::string out;
    while (rows.executeStep())
        for (int i = 0; i < rows.getColumnCount(); ++i) {
            const auto value = rows.getColumn(i);
            out += value.isNull()    ? "\\N"
                   : value.isFloat() ? fmt::format("{}", value.getDouble())
                                     : value.getString();
            out += i + 1 < rows.getColumnCount() ? "|" : "\n";
        }
    return out;
}

/// What there is of every table of the file, but for those that describe the study.
std::map<std::string, std::string> counts(const std::string& database) {
    std::map<std::string, std::string> out;
    for (const char* table : {"participants", "plans", "trials", "trial_stimuli", "sessions", "responses",
                              "answers", "response_stimuli", "events", "hand_joints", "tracking_blocks",
                              "trial_tracking", "stages", "systems", "layouts", "questions"})
        out[table] = inFile(database, std::string("SELECT count(*) FROM ") + table);
    return out;
}

void checkCounts(const PostgresServer& server, const std::string& database, const std::string& file) {
    for (const auto& counted : counts(file)) {
        INFO(counted.first);
        CHECK(onServer(server, database, "SELECT count(*) FROM " + counted.first) == counted.second);
    }
}

}  // namespace

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
            const auto report =
                program("report " + data + " --resamples 200 -o " + to + ".html --json " + to + ".json");
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
        // As it was while S003 took part.
        change(early,
               "CREATE TEMP TABLE later AS SELECT id FROM responses WHERE participant = 'S003' AND "
               "trial_index > 20;"
               "DELETE FROM answers WHERE response IN later; DELETE FROM response_stimuli WHERE response IN "
               "later;"
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
        const std::string sessions = "SELECT participant, outcome, ended_utc_s FROM sessions ORDER BY 1";
        CHECK(onServer(*server, name, sessions) == inFile(file, sessions));

        // The early copy has nothing to say any more.
        const auto stale = push(early, url);
        CHECK(stale.out.find("more of them than this file: S003") != std::string::npos);
        CHECK(onServer(*server, name, sessions) == inFile(file, sessions));

        REQUIRE(program("participants exclude " + file + " S002 --reason 'heard the answers'").status == 0);
        const auto excluded = push(file, url);
        CHECK(excluded.out.find("1 rows changed") != std::string::npos);
        const std::string status = "SELECT id, status, reason FROM participants ORDER BY id";
        CHECK(onServer(*server, name, status) ==
              "S001|active|\\N\nS002|excluded|heard the answers\nS003|active|\\N\n");

        REQUIRE(program("participants withdraw " + file + " S001 --yes").status == 0);
        const auto erased = push(file, url);
        CHECK(erased.out.find("erased, since withdrawn: S001") != std::string::npos);
        checkCounts(*server, name, file);
        CHECK(server->sql(name, "SELECT count(*) FROM " + schemaIn(*server, name) + ".withdrawals") == "1\n");
        // An older copy does not bring them back, and is told so.
        const auto older = push(stations().a, url);
        CHECK(older.status == 0);
        CHECK(older.out.find("not pushed, since withdrawn after they took part: S001") != std::string::npos);
        CHECK(onServer(*server, name, "SELECT count(*) FROM participants") == "2\n");
        CHECK(onServer(*server, name, "SELECT count(*) FROM withdrawals") == "1\n");
    }

    TEST_CASE(
        "An answer that is another on the server, or another person's number, is refused and nothing is "
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
        change(other,
               "UPDATE responses SET hash = NULL, chosen_place = (chosen_place + 1) % 3 WHERE participant = "
               "'S002' AND "
               "chosen_place "
               "IS NOT NULL AND trial_index = (SELECT max(trial_index) FROM responses WHERE participant = "
               "'S002' AND "
               "chosen_place IS NOT NULL)");
        CHECK_FAILS_SAYING(push(other, url), "other.sqlite", "table responses, participant S002, id ",
                           "chosen_place", "never altered");
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
            Background pushing(std::string(DEIXIS_PROGRAM) + " push " + files.b + " '" + url +
                               "' >/dev/null 2>&1");
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
            Background pushing(std::string(DEIXIS_PROGRAM) + " push " + files.b + " '" + url +
                               "' >/dev/null 2>&1");
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
                all.push_back(std::make_unique<Background>(std::string(DEIXIS_PROGRAM) + " push " + file +
                                                           " '" + url + "' >/dev/null"));
            for (const auto& one : all) CHECK(one->wait() == 0);
        }
        checkCounts(*server, name, files.both);
        CHECK(onServer(*server, name, answers_sql) == inFile(files.both, answers_sql));
    }

    TEST_CASE("Several studies lie beside each other; a report names them until it is told which") {
        PostgresServer* server = PostgresServer::get();
        if (server == nullptr) return;
        const Scratch scratch;
        const std::string name = server->database();
        const std::string url = server->url(name);
        const std::string report = "report '" + url + "' --resamples 200 -o " + (scratch / "r.html");
        CHECK_FAILS_SAYING(program(report), "there is no study yet");
        spill(scratch / "other.toml", replaced(shippedStudy(), "pointing2023", "another"));
        REQUIRE(program("simulate " + (scratch / "other.toml") + " --participants 2 --db " +
                        (scratch / "o.sqlite"))
                    .status == 0);
        pushed(stations().a, url);
        CHECK(program(report).status == 0);
        pushed(scratch / "o.sqlite", url);
        CHECK_FAILS_SAYING(program(report), "several studies are there", "pointing2023 (", "another (",
                           "--study");
        CHECK_FAILS_SAYING(program(report + " --study nothing"), "no study 'nothing'", "pointing2023 (",
                           "another (");
        REQUIRE(program(report + " --study another").status == 0);
        CHECK(slurp(scratch / "r.html").find("another") != std::string::npos);
        CHECK_FAILS_SAYING(program("report " + stations().a + " --study another"), "--study");
    }

    TEST_CASE("Tables of an older version are brought up to date by a push, whole or not at all") {
        PostgresServer* server = PostgresServer::get();
        if (server == nullptr) return;
        const Scratch scratch;
        const Stations& files = stations();
        // Files of version 4, too: their participants' tokens are made from the same rows as on the server.
        const std::string a = scratch / "a.sqlite", b = scratch / "b.sqlite";
        for (const auto& [from, to] : {std::pair{files.a, a}, {files.b, b}}) {
            fs::copy_file(from, to);
            change(to, std::string(back_to_4) + "PRAGMA user_version = 4");
        }
        const std::string name = server->database();
        const std::string url = server->url(name);
        pushed(a, url);
        const std::string schema = schemaIn(*server, name);
        const std::string version = "SELECT version FROM " + schema + ".deixis_schema";
        const std::string newest = server->sql(name, version);
        const std::string columns =
            "SELECT table_name, column_name, data_type FROM information_schema.columns WHERE table_schema = "
            "'" +
            schema + "' ORDER BY 1, ordinal_position";
        const std::string newest_columns = server->sql(name, columns);
        onServer(
            *server, name,
            std::string(back_to_4) +
                "ALTER TABLE withdrawals DROP COLUMN participant_hash; UPDATE deixis_schema SET version = 3");
        CHECK(server->sql(name, columns) != newest_columns);
        const std::string report = "report '" + url + "' --resamples 200 -o " + (scratch / "r.html");
        CHECK_FAILS_SAYING(program(report), "has version 3", "Push a station's file");

        // A push that is refused further on leaves them as they were.
        const std::string clash = scratch / "clash.sqlite";
        fs::copy_file(b, clash);
        change(clash, "UPDATE participants SET number = 2 WHERE id = 'S005'");
        CHECK_FAILS_SAYING(push(clash, url), "has the number 2");
        CHECK(server->sql(name, version) == "3\n");

        const auto done = push(b, url);
        INFO(done.err);
        REQUIRE(done.status == 0);
        CHECK(
            done.out.find("brought up to date: the server's tables of the study, which were of version 3") !=
            std::string::npos);
        CHECK(server->sql(name, version) == newest);
        CHECK(server->sql(name, columns) == newest_columns);
        checkCounts(*server, name, files.both);
        CHECK(onServer(*server, name, answers_sql) == inFile(files.both, answers_sql));
        CHECK(push(b, url).out.find("brought up to date") == std::string::npos);
        CHECK(program(report).status == 0);
        fs::copy_file(a, scratch / "withdrawn.sqlite");
        REQUIRE(program("participants withdraw " + (scratch / "withdrawn.sqlite") + " S001 --yes").status ==
                0);
        CHECK(push(scratch / "withdrawn.sqlite", url).out.find("erased, since withdrawn: S001") !=
              std::string::npos);

        server->sql(name, "UPDATE " + schema + ".deixis_schema SET version = 2");
        CHECK_FAILS_SAYING(push(files.a, url), schema, "has version 2", "no way leads", "Rename it");
    }

    TEST_CASE("What is wrong with server, user or schema is told in one line, and passwords appear nowhere") {
        PostgresServer* server = PostgresServer::get();
        if (server == nullptr) return;
        const std::string name = server->database();
        const Scratch scratch;
        const std::string secret = PostgresServer::password;
        std::string told;
        const auto run = [&](const std::string& arguments, const std::string& before = "") {
            const auto done =
                program(arguments, before + " PGCONNECT_TIMEOUT=120 HOME=" + scratch.path().string());
            told += done.out + done.err;
            return done;
        };
        const std::string to = "push " + stations().a + " ";
        const std::string right = server->networkUrl("lab:" + secret, name);
        CHECK_FAILS_SAYING(run(to + server->networkUrl("lab:wrong-horse", name)),
                           server->networkUrl("lab", name), "does not let this user in");
        CHECK_FAILS_SAYING(run(to + server->networkUrl("lab", name)), "does not let this user in",
                           "PGPASSWORD");
        CHECK_FAILS_SAYING(run(to + server->networkUrl("lab:" + secret, "nowhere")),
                           "\"nowhere\" does not exist");
        CHECK_FAILS_SAYING(run(to + "postgresql://lab:" + secret + "@127.0.0.1:1/x"),
                           "no server was reached");
        CHECK_FAILS_SAYING(run(to + "postgresql://lab:" + secret + "%zz@127.0.0.1:1/x"), "cannot be read");
        CHECK_FAILS_SAYING(run(to + "postgresql://lab:" + secret + "@x@127.0.0.1:1/x"), "without doubt");
        CHECK_FAILS_SAYING(run(to + (scratch / "x")), "not the address of a PostgreSQL server");
        CHECK(run(to + "b.sqlite " + right).status == 2);
        // Taken for a file, an address would leave its password in a folder's name.
        for (const std::string& command : {"merge " + right + " " + right + " -o " + (scratch / "m.sqlite"),
                                           "export " + right, "simulate genea-pairwise --db=" + right}) {
            const auto refused = run(command);
            CHECK(refused.status == 2);
            CHECK(contains(refused.err, "only report and push take one"));
        }
        CHECK_FALSE(std::filesystem::exists("postgresql:"));

        // The password in the address, in the environment, and in the file: all the ways in.
        CHECK(run(to + right).status == 0);
        CHECK(run(to + server->networkUrl("lab", name), "PGPASSWORD=" + secret).out.find("nothing new") !=
              std::string::npos);
        spill(scratch / ".pgpass", "127.0.0.1:*:*:lab:" + secret + "\n");
        fs::permissions(scratch / ".pgpass", fs::perms::owner_read | fs::perms::owner_write);
        CHECK(run(to + server->networkUrl("lab", name)).out.find("nothing new") != std::string::npos);
        CHECK(run("report '" + right + "' --resamples 200 -o " + (scratch / "r.html") + " --json " +
                  (scratch / "r.json"))
                  .status == 0);
        CHECK(slurp(scratch / "r.json").find(server->networkUrl("lab", name)) != std::string::npos);
        told += slurp(scratch / "r.html") + slurp(scratch / "r.json");

        const std::string schema = schemaIn(*server, name);
        server->sql(name, "UPDATE " + schema + ".deixis_schema SET version = 999");
        CHECK_FAILS_SAYING(run(to + right), schema, "has version 999", "newer deixis");
        CHECK_FAILS_SAYING(run("report " + right + " -o " + (scratch / "r.html")), "has version 999");
        server->sql(name, "DROP TABLE " + schema + ".deixis_schema");
        CHECK_FAILS_SAYING(run(to + right), schema, "was not made by deixis");
        // Tables of the same names elsewhere are no concern of ours, and who may not make a schema is told.
        server->sql(name, "DROP SCHEMA " + schema +
                              " CASCADE; CREATE TABLE participants (x INT); CREATE TABLE study (y INT)");
        server->sql(name, "CREATE ROLE guest LOGIN PASSWORD '" + secret + "'");
        CHECK_FAILS_SAYING(run(to + server->networkUrl("guest:" + secret, name)), "may not",
                           "CREATE on the database");
        CHECK(run(to + right).status == 0);
        CHECK(server->sql(name, "SELECT count(*) FROM public.participants") == "0\n");
        CHECK(told.find(secret) == std::string::npos);
        CHECK(told.find("wrong-horse") == std::string::npos);
    }
}
