// Which program it was: told by it, kept with sessions, written on what it makes.
#include <SQLiteCpp/SQLiteCpp.h>

#include <regex>

#include "program.hpp"
#include "text.hpp"
#include "xml.hpp"

using namespace deixis::tests;
using deixis::tests::contains;

namespace {

/// What cmake/commit.cmake finds out about a folder.
std::string commitSource(const std::string& folder, const std::string& output) {
    const auto made = shell("cmake -DSOURCE=" + folder + " -DOUTPUT=" + output + " -P " +
                            sourceDir().string() + "/cmake/commit.cmake");
    REQUIRE_MESSAGE(made.status == 0, made.err);
    return slurp(output);
}

std::string lineOf(const std::string& text, const std::string& name) {
    std::smatch found;
    return std::regex_search(text, found, std::regex(name + ": ([^\n]+)")) ? found[1].str() : "";
}

}  // namespace

TEST_SUITE("app/version") {
    TEST_CASE("--version tells commit, compiler, libraries, build type and system") {
        const auto told = program("--version");
        REQUIRE(told.status == 0);
        CHECK(std::regex_search(told.out,
                                std::regex("^deixis \\d+\\.\\d+\\.\\d+ \\(commit ([0-9a-f]{12}|unknown)")));
        CHECK(std::regex_match(lineOf(told.out, "commit"), std::regex("[0-9a-f]{40}|unknown")));
        CHECK(std::regex_match(lineOf(told.out, "uncommitted_changes"), std::regex("yes|no|unknown")));
        CHECK(std::regex_match(lineOf(told.out, "compiler"), std::regex("(GCC|Clang) \\d+\\.\\d+\\.\\d+")));
        CHECK(contains(lineOf(told.out, "libraries"),
                       std::string("SQLite ") +
                           SQLite::Database(":memory:").execAndGet("SELECT sqlite_version()").getString()));
        CHECK_FALSE(lineOf(told.out, "build_type").empty());
        CHECK(contains(lineOf(told.out, "operating_system"), replaced(shell("uname -sr").out, "\n", "")));
    }

    TEST_CASE("Sessions, reports and evaluations say so, too") {
        const Scratch scratch;
        const std::string told = program("--version").out;
        const std::string first_line = told.substr(0, told.find('\n'));
        const std::string database = scratch / "s.sqlite";
        REQUIRE(program("simulate genea-pairwise --participants 1 --db " + database + " --stimuli " +
                        sharedStimuli())
                    .status == 0);
        SQLite::Database db(database, SQLite::OPEN_READONLY);
        const auto property = [&](const std::string& name) {
            return db.execAndGet("SELECT value FROM session_properties WHERE name = '" + name + "'")
                .getString();
        };
        CHECK(db.execAndGet("SELECT program_version FROM sessions").getString() == first_line);
        for (const char* name :
             {"commit", "uncommitted_changes", "build_type", "compiler", "libraries", "built_on"})
            CHECK(property(std::string("program_") + name) == lineOf(told, name));
        CHECK(property("operating_system") == lineOf(told, "operating_system"));

        REQUIRE(
            program("report " + database + " -o " + (scratch / "r.html") + " --json " + (scratch / "r.json"))
                .status == 0);
        spill(scratch / "t.csv", "target_id,x,y,z\nA,1.2,1.0,1.6\nB,-1.0,0.4,1.8\nC,0.1,0.9,1.7\n");
        REQUIRE(program("generate direct --targets " + (scratch / "t.csv") + " --out " + (scratch / "clips"))
                    .status == 0);
        const auto evaluated = program("evaluate " + (scratch / "clips") + " -o " + (scratch / "e.html") +
                                       " --json " + (scratch / "e.json"));
        REQUIRE_MESSAGE(evaluated.status == 0, evaluated.err);
        const auto report = nlohmann::json::parse(slurp(scratch / "r.json"))["program"];
        CHECK(report["analysed_by"] == first_line);
        CHECK(report["recorded_by"][0] == first_line);
        CHECK(report["recorded_on"][0] == lineOf(told, "operating_system"));
        for (const auto& build :
             {report["build"], nlohmann::json::parse(slurp(scratch / "e.json"))["build"]}) {
            CHECK(build["commit"] == lineOf(told, "commit"));
            CHECK(build["compiler"] == lineOf(told, "compiler"));
            CHECK(build["libraries"] == lineOf(told, "libraries"));
        }
        for (const char* page : {"r.html", "e.html"})
            for (const std::string& compiler :
                 XmlDocument(slurp(scratch / page)).texts("//h:dt[.='Compiler']/following-sibling::h:dd[1]"))
                CHECK(compiler.starts_with(lineOf(told, "compiler")));
    }

    TEST_CASE(
        "The commit is found when the program is built, and its source is written only where it changes") {
        const Scratch scratch;
        const std::string folder = scratch / "tree";
        const std::string output = scratch / "commit.cpp";
        spill(folder + "/file", "one\n");
        CHECK(contains(commitSource(folder, output), "built_from_commit = \"unknown\""));
        if (shell("git --version").status != 0) {
            tellSkipped("git is not here");
            return;
        }
        const std::string git = "git -C " + folder + " -c user.name=x -c user.email=x@x ";
        REQUIRE(shell(git + "init -q && " + git + "add file && " + git + "commit -qm one").status == 0);
        const std::string head = replaced(shell(git + "rev-parse HEAD").out, "\n", "");
        const std::string clean = commitSource(folder, output);
        CHECK(contains(clean, "built_from_commit = \"" + head + "\""));
        CHECK(contains(clean, "built_with_changes = \"no\""));
        const auto written = fs::last_write_time(output);
        commitSource(folder, output);
        CHECK(fs::last_write_time(output) == written);
        spill(folder + "/file", "two\n");
        CHECK(contains(commitSource(folder, output), "built_with_changes = \"yes\""));
        // An archive of the sources within somebody's clone is not of that clone's commit.
        spill(folder + "/archive/file", "one\n");
        CHECK(contains(commitSource(folder + "/archive", output), "built_from_commit = \"unknown\""));
    }
}
