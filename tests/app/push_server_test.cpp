// The server that stations push to: studies beside each other, tables of older versions, what is wrong with
// it.
#include "pushed_files.hpp"
#include "text.hpp"

using namespace deixis::tests;

namespace {

/// Takes away what versions 5 and 6 added, in a file or on a server.
constexpr const char* back_to_4 =
    "DROP VIEW responses_flat; DROP VIEW IF EXISTS game_trials; DROP VIEW IF EXISTS game_choices;"
    "DROP VIEW IF EXISTS placements; DROP VIEW IF EXISTS authored; ALTER TABLE trials ADD COLUMN distractors "
    "TEXT;"
    "ALTER TABLE trials ADD COLUMN balls TEXT; ALTER TABLE trials ADD COLUMN target_place INTEGER;"
    "ALTER TABLE responses ADD COLUMN chosen_place INTEGER; ALTER TABLE responses ADD COLUMN correct INTEGER;"
    "UPDATE trials SET distractors = (SELECT v.text FROM trial_values AS v WHERE v.participant = "
    "trials.participant AND v.trial_index = trials.trial_index AND v.name = 'distractors'), balls = (SELECT "
    "v.text FROM trial_values AS v WHERE v.participant = trials.participant AND v.trial_index = "
    "trials.trial_index AND v.name = 'balls'), target_place = (SELECT CAST(v.value AS INTEGER) FROM "
    "trial_values AS v WHERE v.participant = trials.participant AND v.trial_index = trials.trial_index AND "
    "v.name = 'target_place');"
    "UPDATE responses SET chosen_place = (SELECT CAST(v.value AS INTEGER) FROM response_values AS v WHERE "
    "v.response = responses.id AND v.name = 'chosen_place'), correct = (SELECT CAST(v.value AS INTEGER) FROM "
    "response_values AS v WHERE v.response = responses.id AND v.name = 'correct');"
    "DROP TABLE trial_values; DROP TABLE response_values;"
    "ALTER TABLE questions DROP COLUMN labels; ALTER TABLE study DROP COLUMN "
    "locked_hash; ALTER TABLE study DROP COLUMN "
    "analysis;"
    "ALTER TABLE plans DROP COLUMN locked_hash; DROP INDEX sessions_of_participant;"
    "DROP INDEX responses_of_participant;"
    "ALTER TABLE participants DROP COLUMN token; ALTER TABLE trials DROP COLUMN visibility;"
    "ALTER TABLE trials DROP COLUMN angles; ALTER TABLE trial_stimuli DROP COLUMN clip;"
    "ALTER TABLE response_stimuli DROP COLUMN author; ALTER TABLE response_stimuli DROP COLUMN author_trial;"
    "ALTER TABLE responses DROP COLUMN viewer_x_m; ALTER TABLE responses DROP COLUMN viewer_z_m;"
    "ALTER TABLE responses DROP COLUMN viewer_heading_deg; ALTER TABLE responses DROP COLUMN hash;"
    "DROP TABLE locked_changes; ALTER TABLE withdrawals DROP COLUMN token;"
    "ALTER TABLE withdrawals DROP COLUMN cleared;"
    "ALTER TABLE withdrawals ADD COLUMN participant_hash TEXT;";

}  // namespace

TEST_SUITE("app/push server") {
    TEST_CASE("Several studies lie beside each other; a report names them until it is told which") {
        PostgresServer* server = PostgresServer::get();
        if (server == nullptr) return;
        const Scratch scratch;
        const std::string name = server->database();
        const std::string url = server->url(name);
        const std::string report = "report '" + url + "' --resamples 200 -o " + (scratch / "r.html");
        CHECK_FAILS_SAYING(program(report), "there is no study yet");
        spill(scratch / "other.toml",
              replaced(shippedStudy(), "name = \"pointing2023-stand-ins\"", "name = \"another\""));
        REQUIRE(program("simulate " + (scratch / "other.toml") + " --participants 2 --db " +
                        (scratch / "o.sqlite"))
                    .status == 0);
        pushed(stations().a, url);
        CHECK(program(report).status == 0);
        pushed(scratch / "o.sqlite", url);
        CHECK_FAILS_SAYING(program(report), "several studies are there", "pointing2023-stand-ins (",
                           "another (", "--study");
        CHECK_FAILS_SAYING(program(report + " --study nothing"), "no study 'nothing'",
                           "pointing2023-stand-ins (", "another (");
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

        // A push that is rejected further on leaves them as they were.
        const std::string clash = scratch / "clash.sqlite";
        fs::copy_file(b, clash);
        change(clash, "UPDATE participants SET number = 2 WHERE id = 'S005'");
        CHECK_FAILS_SAYING(push(clash, url), "has the number 2");
        CHECK(server->sql(name, version) == "3\n");

        const auto done = push(b, url);
        INFO(done.err);
        REQUIRE(done.status == 0);
        CHECK(done.out.find("upgraded: the server's tables of the study, which were of version 3") !=
              std::string::npos);
        CHECK(server->sql(name, version) == newest);
        CHECK(server->sql(name, columns) == newest_columns);
        checkCounts(*server, name, files.both);
        CHECK(onServer(*server, name, answers_sql) == inFile(files.both, answers_sql));
        CHECK(push(b, url).out.find("upgraded") == std::string::npos);
        CHECK(program(report).status == 0);
        fs::copy_file(a, scratch / "withdrawn.sqlite");
        REQUIRE(program("participants withdraw " + (scratch / "withdrawn.sqlite") + " S001 --yes").status ==
                0);
        CHECK(push(scratch / "withdrawn.sqlite", url).out.find("erased because withdrawn: S001") !=
              std::string::npos);

        server->sql(name, "UPDATE " + schema + ".deixis_schema SET version = 2");
        CHECK_FAILS_SAYING(push(files.a, url), schema, "has version 2", "cannot be upgraded", "Rename it");
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
        CHECK_FAILS_SAYING(run(to + "postgresql://lab:" + secret + "@x@127.0.0.1:1/x"), "ambiguous");
        CHECK_FAILS_SAYING(run(to + (scratch / "x")), "not the address of a PostgreSQL server");
        CHECK(run(to + "b.sqlite " + right).status == 2);
        // Taken for a file, an address would leave its password in a folder's name.
        for (const std::string& command : {"merge " + right + " " + right + " -o " + (scratch / "m.sqlite"),
                                           "export " + right, "simulate genea-pairwise --db=" + right}) {
            const auto rejected = run(command);
            CHECK(rejected.status == 2);
            CHECK(contains(rejected.err, "only report and push take one"));
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
