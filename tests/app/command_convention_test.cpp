// One convention in every command (docs/command-line.md): this walks all of them, as the program declares
// them, and asks the real program.
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "app/command_line/command_line.hpp"
#include "app/command_line/old_spellings.hpp"
#include "program.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

struct OneCommand {
    std::string words;  ///< "clips info"
    const CLI::App* app = nullptr;
};

/// Every command below, groups of commands among them.
void walk(const CLI::App& from, const std::string& path, std::vector<OneCommand>& out) {
    for (const CLI::App* command : from.get_subcommands([](const CLI::App*) { return true; })) {
        if (command->get_group().empty()) continue;  // not for people: help leaves it out
        const std::string words = path + (path.empty() ? "" : " ") + command->get_name();
        out.push_back({words, command});
        walk(*command, words, out);
    }
}

struct Declared {
    CLI::App cli{"", "deixis"};
    app::Command chosen;
    std::vector<OneCommand> commands;
    Declared() {
        cli.require_subcommand(1);
        app::addCommands(cli, chosen);
        walk(cli, "", commands);
    }
};

/// The lines after "Example:" up to the next empty one.
std::vector<std::string> examplesIn(const std::string& help) {
    std::vector<std::string> out;
    const auto at = help.find("\nExample:\n");
    if (at == std::string::npos) return out;
    std::istringstream in(help.substr(at + 10));
    for (std::string line; std::getline(in, line) && !line.empty();)
        out.push_back(line.substr(line.find_first_not_of(' ')));
    return out;
}

/// The words of a line as a shell would take them, up to where its output goes.
std::vector<std::string> wordsOf(const std::string& line) {
    std::vector<std::string> out;
    std::string word;
    bool quoted = false;
    for (const char c : line + " ") {
        if (c == '\'') {
            quoted = !quoted;
        } else if (c == ' ' && !quoted) {
            if (word == ">") return out;
            if (!word.empty()) out.push_back(word);
            word.clear();
        } else {
            word += c;
        }
    }
    return out;
}

std::size_t filesBelow(const fs::path& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::recursive_directory_iterator(folder), fs::recursive_directory_iterator()));
}

/// The program, run in that folder.
Finished programIn(const Scratch& folder, const std::string& arguments) {
    return program(arguments, "cd " + folder.path().string() + " &&");
}

}  // namespace

TEST_SUITE("app/command_convention") {
    TEST_CASE("Every help text has an example, a page, says what is written, and reads as English") {
        const Declared declared;
        CHECK(declared.commands.size() >= 45);
        for (const OneCommand& command : declared.commands) {
            CAPTURE(command.words);
            const auto done = program(command.words + " --help");
            CHECK(done.status == 0);
            CHECK(done.err.empty());
            CHECK(contains(done.out, "Usage: deixis " + command.words));
            CHECK(contains(done.out, "\nWrites: "));
            const auto more = done.out.find("\nMore: docs/");
            REQUIRE(more != std::string::npos);
            const std::string page = done.out.substr(more + 7, done.out.find('\n', more + 1) - more - 7);
            CHECK_MESSAGE(fs::is_regular_file(sourceDir() / page), page);
            for (const std::string& odd :
                 std::vector<std::string>{" TEXT", " FLOAT", " INT", " UINT", "{", "REQUIRED",
                                          "Needs:", "Excludes:", sourceDir().string()})
                CHECK_MESSAGE(!contains(done.out, odd), odd);
            std::istringstream lines(done.out);
            for (std::string line; std::getline(lines, line);) CHECK_MESSAGE(line.size() <= 100, line);
        }
    }

    TEST_CASE("Every example is a command line that the program takes") {
        const Declared declared;
        for (const OneCommand& command : declared.commands) {
            CAPTURE(command.words);
            const std::vector<std::string> examples = examplesIn(command.app->help());
            REQUIRE(!examples.empty());
            bool own = false;
            for (const std::string& example : examples) {
                CAPTURE(example);
                std::vector<std::string> words = wordsOf(example);
                REQUIRE(words.size() > 1);
                CHECK(words.front() == "deixis");
                own = own || (example + " ").starts_with("deixis " + command.words + " ");
                Declared fresh;
                std::reverse(words.begin(), words.end());
                words.pop_back();
                CHECK_NOTHROW(fresh.cli.parse(words));
            }
            CHECK(own);
        }
    }

    TEST_CASE("Shared options are spelled, take and mean the same everywhere") {
        const Declared declared;
        std::set<std::string> with_output;
        for (const OneCommand& command : declared.commands) {
            CAPTURE(command.words);
            for (const CLI::Option* option : command.app->get_options()) {
                for (const std::string& name : option->get_lnames()) {
                    CAPTURE(name);
                    // Of what is written there is one spelling.
                    CHECK(name != "out");
                    CHECK(name != "overwrite");
                    CHECK(name != "no-picture");
                    if (name == "output") {
                        CHECK(option->check_sname("o"));
                        with_output.insert(command.words);
                    }
                    if (name == "force") {
                        CHECK(option->get_description().starts_with("Replace "));
                        CHECK(option->get_description().ends_with(" there already"));
                    }
                    for (const char* writes : {"latex", "r", "png", "mp4", "screenshot", "picture"})
                        if (name == writes) CHECK(command.app->get_option_no_throw("--force") != nullptr);
                    if (name == "json") CHECK(option->get_items_expected_min() == 0);
                    if (name == "seed") CHECK(option->get_description().starts_with("Seed of "));
                }
                for (const std::string& name : option->get_snames()) CHECK((name == "o" || name == "h"));
            }
        }
        // Whatever option names a place to write to, --force stands beside it, but for what is never
        // replaced.
        const std::set<std::string> never{"simulate", "export", "merge", "package"};
        for (const OneCommand& command : declared.commands)
            for (const char* name :
                 {"output", "latex", "r", "png", "mp4", "screenshot", "picture", "save-effects"})
                if (command.app->get_option_no_throw(std::string("--") + name) != nullptr &&
                    never.count(command.words) == 0)
                    CHECK_MESSAGE(command.app->get_option_no_throw("--force") != nullptr, command.words,
                                  name);
        for (const char* writes : {"simulate", "report", "evaluate", "fit", "export", "merge", "package",
                                   "generate", "clips convert", "clips mirror", "clips trim",
                                   "clips resample", "clips retarget", "clips segment", "learn project"})
            CHECK_MESSAGE(with_output.count(writes) == 1, writes);
    }

    TEST_CASE("Wrong usage exits with 2, and what fails with 1, without a word on standard output") {
        const Declared declared;
        for (const OneCommand& command : declared.commands) {
            if (command.app->get_prefix_command()) continue;  // not in this build
            CAPTURE(command.words);
            const auto done = program(command.words + " --no-such-option");
            CHECK(done.status == 2);
            CHECK(done.out.empty());
            CHECK(contains(done.err, "no-such-option"));
        }
        const auto absent = program("clips info nowhere.bvh");
        CHECK(absent.status == 1);
        CHECK(absent.out.empty());
    }

    TEST_CASE("What only prints leaves nothing in the current folder") {
        const Scratch scratch;
        for (const std::string words :
             {"targets pointing2023", "targets pointing2023 --no-picture", "targets --grid 27",
              "check pointing2023", "plan pointing2023 --participant P01", "schema analysis",
              "power pointing2023 --effect pointing2023 --participants 4 --studies 5 --json"}) {
            CAPTURE(words);
            const auto done = programIn(scratch, words);
            CHECK_MESSAGE(done.status == 0, done.err);
            CHECK(!done.out.empty());
            CHECK(filesBelow(scratch.path()) == 0);
        }
    }

    TEST_CASE(
        "JSON is printed without a file, and then alone; a report's page is replaced, a stranger's is not") {
        const Scratch scratch;
        spill(scratch / "answers.csv",
              "participant,system,rating\nP1,a,1\nP1,b,3\nP2,a,2\nP2,b,5\nP3,a,1\nP3,b,4\nP4,a,2\nP4,b,2\n");
        const auto printed = programIn(scratch, "report answers.csv --json");
        REQUIRE_MESSAGE(printed.status == 0, printed.err);
        CHECK(nlohmann::json::parse(printed.out)["schema"]["name"] == "deixis-analysis");
        CHECK(filesBelow(scratch.path()) == 1);

        const auto written = programIn(scratch, "report answers.csv --json numbers.json");
        CHECK(written.status == 0);
        CHECK(slurp(scratch / "numbers.json") == printed.out);
        CHECK(fs::exists(scratch / "report.html"));
        CHECK(programIn(scratch, "report answers.csv --json=numbers.json").status == 0);

        CHECK(programIn(scratch, "report --json=- answers.csv").out == printed.out);
        CHECK(programIn(scratch, "report --json answers.csv").out == printed.out);
        CHECK(programIn(scratch, "report --json numbers.json answers.csv").out.find("numbers.json") !=
              std::string::npos);
        const auto data_taken = programIn(scratch, "report --json answers.csv -o page.html");
        CHECK(data_taken.status == 2);
        CHECK(contains(data_taken.err, "put --json last"));

        spill(scratch / "thesis.html", "<html>my thesis</html>");
        CHECK_FAILS_SAYING(programIn(scratch, "report answers.csv -o thesis.html"), "thesis.html", "--force");
        CHECK(slurp(scratch / "thesis.html") == "<html>my thesis</html>");
        CHECK(programIn(scratch, "report answers.csv -o thesis.html --force").status == 0);
        CHECK(slurp(scratch / "thesis.html") == slurp(scratch / "report.html"));
    }

    TEST_CASE("Tables replace their own earlier version, pictures nothing, unless --force is given") {
        const Scratch scratch;
        spill(scratch / "answers.csv",
              "participant,system,rating\nP1,a,1\nP1,b,3\nP2,a,2\nP2,b,5\nP3,a,1\nP3,b,4\nP4,a,2\nP4,b,2\n");
        const std::string report = "report answers.csv -o report.html --csv tables --latex tex --r r";
        REQUIRE(programIn(scratch, report).status == 0);
        const std::string means = slurp(scratch / "tables/means.csv");
        CHECK(fs::exists(scratch / "tex/means.tex"));
        CHECK(fs::exists(scratch / "r/analysis.R"));
        // Other answers, the same tables.
        spill(scratch / "answers.csv", slurp(scratch / "answers.csv") + "P5,a,1\nP5,b,5\n");
        REQUIRE(programIn(scratch, report).status == 0);
        CHECK(slurp(scratch / "tables/means.csv") != means);
        // A lab's own file of that name stays, and nothing else is written.
        for (const std::string mine : {"tables/means.csv", "tex/means.tex", "r/analysis.R"}) {
            CAPTURE(mine);
            const std::string made = slurp(scratch / mine);
            spill(scratch / mine, "my own\n");
            fs::remove(scratch / "report.html");
            CHECK_FAILS_SAYING(programIn(scratch, report), mine, "--force");
            CHECK(slurp(scratch / mine) == "my own\n");
            CHECK_FALSE(fs::exists(scratch / "report.html"));
            CHECK(programIn(scratch, report + " --force").status == 0);
            CHECK(slurp(scratch / mine) == made);
        }
        spill(scratch / "fig.svg", "mine");
        const std::string targets = "targets pointing2023 --picture fig.svg";
        CHECK_FAILS_SAYING(programIn(scratch, targets), "fig.svg", "--force");
        CHECK(slurp(scratch / "fig.svg") == "mine");
        CHECK(programIn(scratch, targets + " --force").status == 0);
        CHECK(slurp(scratch / "fig.svg").starts_with("<svg"));
        spill(scratch / "clip.png", "mine");
        CHECK_FAILS_SAYING(programIn(scratch, "view clip.bvh --screenshot clip.png"), "clip.png", "--force");
        CHECK_FAILS_SAYING(
            programIn(scratch, "run pointing2023-stand-ins --station simulated --screenshot rating=clip.png"),
            "clip.png", "--force");
        CHECK_FAILS_SAYING(programIn(scratch, "replay s.sqlite --participant P01 --mp4 clip.png"), "clip.png",
                           "--force");
        CHECK(filesBelow(scratch.path()) > 3);
        CHECK_FALSE(fs::exists(scratch / "pointing2023-stand-ins.sqlite"));
    }

    TEST_CASE("Spellings of earlier versions go on working") {
        using Words = std::vector<std::string>;
        CHECK(app::inCurrentSpelling({"simulate", "s", "--db", "x"}) ==
              Words{"simulate", "s", "--output", "x"});
        CHECK(app::inCurrentSpelling({"simulate", "s", "--db=x"}) == Words{"simulate", "s", "--output=x"});
        CHECK(app::inCurrentSpelling({"run", "s", "--db", "x"}) == Words{"run", "s", "--db", "x"});
        CHECK(app::inCurrentSpelling({"clips", "mirror", "m", "--out", "x"}) ==
              Words{"clips", "mirror", "m", "--output", "x"});
        CHECK(app::inCurrentSpelling({"targets", "--no-picture", "s"}) == Words{"targets", "s"});
        CHECK(app::inCurrentSpelling({"generate", "--", "--out"}) == Words{"generate", "--", "--out"});
        CHECK(app::inCurrentSpelling({}).empty());

        const Scratch scratch;
        spill(scratch / "targets.csv", "target_id,x,y,z\nT1,0.2,1.2,1.4\n");
        const auto generated = programIn(scratch, "generate direct --targets targets.csv --out old");
        REQUIRE_MESSAGE(generated.status == 0, generated.err);
        CHECK(programIn(scratch, "generate direct --targets targets.csv -o new").status == 0);
        CHECK(slurp(scratch / "old/manifest.csv") == slurp(scratch / "new/manifest.csv"));
        CHECK(programIn(scratch, "clips mirror old/manifest.csv --out mirrored").status == 0);
        CHECK(fs::exists(scratch / "mirrored/manifest.csv"));
        std::string bvh;
        for (const auto& entry : fs::directory_iterator(scratch / "old"))
            if (entry.path().extension() == ".bvh") bvh = entry.path().string();
        CHECK(programIn(scratch, "clips trim " + bvh + " a.bvh --to 3").status == 0);
        CHECK(programIn(scratch, "clips trim " + bvh + " -o b.bvh --to 3").status == 0);
        CHECK(slurp(scratch / "a.bvh") == slurp(scratch / "b.bvh"));
        CHECK_FAILS_SAYING(programIn(scratch, "clips trim " + bvh + " -o b.bvh --to 4"), "b.bvh", "--force");
    }
}
