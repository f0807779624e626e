// Where a participant's answers lie while the program runs, and who may read what it writes.
#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>

#include "program.hpp"

using namespace deixis::tests;

namespace {

int countIn(const std::string& database, const std::string& table) {
    try {
        SQLite::Database open(database, SQLite::OPEN_READONLY, 1000);
        return open.execAndGet("SELECT count(*) FROM " + table).getInt();
    } catch (const SQLite::Exception&) {
        return 0;  // not made yet
    }
}

std::uintmax_t sizeOf(const fs::path& file) {
    std::error_code missing;
    const auto size = fs::file_size(file, missing);
    return missing ? 0 : size;
}

/// A simulated participant's session in the background, its output in files beside the database.
std::string sessionOf(const Scratch& scratch, const std::string& more) {
    return programFile() + " run pointing2023-stand-ins --station simulated --db " +
           (scratch / "study.sqlite") + " " + more;
}

}  // namespace

TEST_SUITE("app/storage") {
    TEST_CASE(
        "a database renamed, deleted or replaced in a session: it stops, and every answer is in a copy") {
        for (const std::string act : {"renamed", "deleted", "replaced"}) {
            INFO(act);
            const Scratch scratch{WithSharedStimuli{}};
            const std::string database = scratch / "study.sqlite";
            Background session(sessionOf(scratch, "--participant P01 >/dev/null 2>" + (scratch / "err")));
            REQUIRE(eventually(60.0, [&] { return countIn(database, "responses") >= 4; }));
            if (act == "renamed") fs::rename(database, scratch / "other.sqlite");
            if (act == "deleted") fs::remove(database);
            if (act == "replaced") {
                spill(scratch / "other.sqlite", "another file");
                fs::rename(scratch / "other.sqlite", database);
            }
            CHECK(session.wait() == 1);
            const std::string err = slurp(scratch / "err");
            INFO(err);
            const std::string copy = scratch / "study.recovered.sqlite";
            CHECK(err.find("renamed, moved, replaced or deleted") != std::string::npos);
            CHECK(err.find(copy) != std::string::npos);
            CHECK(err.find("--participant P01") != std::string::npos);
            const int kept = countIn(copy, "responses");
            CHECK(kept >= 4);
            CHECK(countIn(copy, "events") > 0);
            CHECK(sizeOf(scratch / "study.sqlite-wal") == 0);
            if (act == "replaced") CHECK(slurp(database) == "another file");
            if (act == "renamed") CHECK(countIn(scratch / "other.sqlite", "responses") == kept);

            // As the message says: under its old name the copy goes on.
            fs::rename(copy, database);
            const auto again =
                program("run pointing2023-stand-ins --station simulated --participant P01 --db " + database);
            INFO(again.err);
            CHECK(again.status == 0);
            CHECK(again.out.find(std::to_string(kept) + " trials and pages answered before") !=
                  std::string::npos);
        }
    }

    TEST_CASE("beside a dead session's log whose database is gone, no command makes or reads another") {
        const Scratch scratch{WithSharedStimuli{}};
        const std::string database = scratch / "study.sqlite";
        {
            Background session(sessionOf(scratch, "--participant P01 >/dev/null 2>&1"));
            REQUIRE(eventually(60.0, [&] { return countIn(database, "responses") >= 3; }));
            session.kill(SIGKILL);
        }
        const std::string log = slurp(database + "-wal");
        REQUIRE(log.size() > 32);
        fs::rename(database, scratch / "moved.sqlite");
        for (const std::string& arguments :
             {"run pointing2023-stand-ins --station simulated --db " + database, "report " + database,
              "participants list " + database, "export " + database + " -o " + (scratch / "out"),
              "participants exclude " + database + " P01 --reason x"})
            CHECK_FAILS_SAYING(program(arguments), "study.sqlite-wal", "back its name");
        CHECK_FALSE(fs::exists(database));
        CHECK(slurp(database + "-wal") == log);
        fs::rename(scratch / "moved.sqlite", database);
        const auto again =
            program("run pointing2023-stand-ins --station simulated --participant P01 --db " + database);
        INFO(again.err);
        CHECK(again.status == 0);
    }

    TEST_CASE("what is written is its owner's alone, whatever the umask") {
        const Scratch scratch;
        const std::string database = scratch / "study.sqlite";
        const std::string open = "umask 000; ";
        for (const std::string& arguments :
             {"run pointing2023-stand-ins --station simulated --participant P01 --db " + database +
                  " --trace " + (scratch / "trace.jsonl"),
              "report " + database + " -o " + (scratch / "new/report.html") + " --json " +
                  (scratch / "new/analysis.json") + " --csv " + (scratch / "tables") + " --r " +
                  (scratch / "r"),
              "export " + database + " -o " + (scratch / "export"),
              "simulate pointing2023-stand-ins --participants 1 --db " + (scratch / "simulated.sqlite"),
              "merge " + database + " " + database + " -o " + (scratch / "merged.sqlite"),
              "evaluate " + (scratch / "stimuli") + "/direct-*/manifest.csv -o " +
                  (scratch / "evaluation.html") + " --csv " + (scratch / "evaluation")}) {
            const auto done = program(arguments, open);
            INFO(done.err);
            CHECK(done.status == 0);
        }
        int files = 0;
        for (const auto& entry : fs::recursive_directory_iterator(scratch.path())) {
            ++files;
            const auto others = entry.status().permissions() & (fs::perms::group_all | fs::perms::others_all);
            CHECK_MESSAGE(others == fs::perms::none, entry.path().string());
        }
        CHECK(files > 20);
    }

    TEST_CASE("a mistyped participant leaves nothing behind, and a session no lock") {
        const Scratch scratch;
        const std::string run =
            "run pointing2023-stand-ins --station simulated --db " + (scratch / "study.sqlite");
        CHECK_FAILS_SAYING(program(run + " --participant 'Anna B.'"), "Anna B.", "P01");
        CHECK(fs::is_empty(scratch.path()));
        REQUIRE(program(run + " --participant P01").status == 0);
        for (const auto& entry : fs::directory_iterator(scratch.path()))
            CHECK(entry.path().extension() != ".lock");
    }

    TEST_CASE("two stations that start at once without an id get one each") {
        const Scratch scratch{WithSharedStimuli{}};
        const std::string database = scratch / "study.sqlite";
        Background one(sessionOf(scratch, ">" + (scratch / "one") + " 2>&1"));
        Background two(sessionOf(scratch, ">" + (scratch / "two") + " 2>&1"));
        INFO(slurp(scratch / "one") << slurp(scratch / "two"));
        CHECK(one.wait() == 0);
        CHECK(two.wait() == 0);
        CHECK(shell("sqlite3 -readonly " + database + " 'select id, number from participants order by id'")
                  .out == "P01|1\nP02|2\n");
    }

    TEST_CASE("text that no server could hold is rejected where it enters") {
        const Scratch scratch;
        const std::string latin = "\"$(printf 'Z\\374rich')\"";
        for (const std::string& arguments :
             {"participants exclude " + (scratch / "study.sqlite") + " P01 --reason " + latin,
              "run pointing2023-stand-ins --participant " + latin, "report " + latin}) {
            const auto rejected = program(arguments);
            CHECK(rejected.status == 2);
            CHECK(rejected.err.find("UTF-8") != std::string::npos);
        }
        spill(scratch / "study.toml", replaced(shippedStudy(), "title = \"", "title = \"A\\u0000B "));
        CHECK_FAILS_SAYING(program("plan " + (scratch / "study.toml") + " --participant P01"),
                           "study.toml:", "U+0000");
        // In Windows-1252, too, this byte is no letter.
        spill(scratch / "answers.csv", "participant,system,naturalness\nP01,Z\x81rich,3\n");
        CHECK_FAILS_SAYING(program("report " + (scratch / "answers.csv") + " -o " + (scratch / "r.html")),
                           "answers.csv:2", "UTF-8");
    }

    TEST_CASE("input that never ends is rejected in one message") {
        const Scratch scratch;
        // The address sanitizer reserves terabytes.
        const std::string limit =
            isSanitized() ? "ASAN_OPTIONS=hard_rss_limit_mb=2000" : "ulimit -v 4000000;";
        for (const std::string& arguments :
             {std::string("report /dev/zero -o r.html"), std::string("check /dev/zero"),
              std::string("stats wilcoxon /dev/zero --a x --b y"), std::string("clips info /dev/zero"),
              std::string("evaluate /dev/zero -o e.html"), std::string("replay /dev/zero --participant P01"),
              std::string("run pointing2023-stand-ins --station simulated --db /dev/zero"),
              std::string("fit /dev/zero"), std::string("generate direct --targets /dev/zero --out x")}) {
            const auto rejected = program(arguments, "cd " + scratch.path().string() + "; " + limit);
            INFO(arguments << ": " << rejected.err);
            CHECK(rejected.status > 0);
            CHECK(rejected.status < 128);
            CHECK(rejected.err.find("bad_alloc") == std::string::npos);
            CHECK(rejected.err.find("memory") == std::string::npos);
        }
    }

    TEST_CASE("a mistyped server's address never shows its password") {
        const Scratch scratch;
        for (const std::string address :
             {"Postgresql://ann:Sesam@h/d", "postgre://ann:Sesam@h/d", "ann:Sesam@h/d"})
            for (const std::string& arguments :
                 {"report " + address, "push " + (scratch / "a.sqlite") + " " + address, "run " + address,
                  "participants list " + address, "--db=" + address}) {
                const auto rejected = program(arguments);
                INFO(arguments << ": " << rejected.err);
                CHECK(rejected.status != 0);
                CHECK((rejected.out + rejected.err).find("Sesam") == std::string::npos);
            }
        CHECK_FAILS_SAYING(program("report Postgresql://ann:Sesam@h/d"), "lower case");
    }
}
