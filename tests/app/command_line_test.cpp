// The command line as it is declared: what its numbers take, and what is proposed for what it does not know.
#include "app/command_line/command_line.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "program.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

/// Why the words are rejected: the parser's name of the problem, ": " and its message; empty: they are not.
std::string rejection(const std::vector<std::string>& words) {
    CLI::App cli{"", "deixis"};
    cli.require_subcommand(1);
    app::Command chosen;
    app::addCommands(cli, chosen);
    std::vector<std::string> backwards(words.rbegin(), words.rend());
    try {
        cli.parse(backwards);
    } catch (const CLI::ParseError& error) {
        return error.get_name() + ": " + error.what();
    }
    return "";
}

struct NumberOption {
    std::vector<std::string> words;  ///< that lead to it, its own name last
    std::string type;
    int values = 1;
};

void findNumbers(CLI::App& from, const std::vector<std::string>& path, std::vector<NumberOption>& out) {
    for (const CLI::Option* option : from.get_options()) {
        const std::string type =
            option->get_type_name().substr(0, option->get_type_name().find_first_of(":, "));
        if (option->get_items_expected_max() == 0 || (type != "FLOAT" && type != "INT" && type != "UINT"))
            continue;
        REQUIRE_MESSAGE(!option->get_lnames().empty(), option->get_name());
        NumberOption found{path, type, option->get_items_expected_min()};
        found.words.push_back("--" + option->get_lnames().front());
        out.push_back(found);
    }
    for (CLI::App* command : from.get_subcommands([](const CLI::App*) { return true; })) {
        std::vector<std::string> longer = path;
        longer.push_back(command->get_name());
        findNumbers(*command, longer, out);
    }
}

}  // namespace

TEST_SUITE("app/command_line") {
    TEST_CASE("Every option that is a number rejects what is none, and what would wrap or overflow") {
        CLI::App cli{"", "deixis"};
        app::Command chosen;
        app::addCommands(cli, chosen);
        std::vector<NumberOption> options;
        findNumbers(cli, {}, options);
        CHECK(options.size() >= 30);
        for (const NumberOption& option : options) {
            std::vector<std::string> bad{"nan", "-nan", "inf", "-inf", "1e400", "1x", "x", "0x10"};
            if (option.type != "FLOAT") bad.insert(bad.end(), {"1.5", "99999999999999999999", "010"});
            if (option.type == "UINT") bad.insert(bad.end(), {"-1", "-18446744073709551615"});
            for (const std::string& value : bad) {
                std::vector<std::string> words = option.words;
                words.back() += "=" + value;
                for (int i = 1; i < option.values; ++i) words.push_back(value);
                const std::string why = rejection(words);
                CAPTURE(option.words.back());
                CAPTURE(value);
                CAPTURE(why);
                CHECK((why.starts_with("ValidationError") || why.starts_with("ConversionError")));
                CHECK(contains(why, option.words.back()));
            }
            std::vector<std::string> words = option.words;
            words.back() += "=1";
            for (int i = 1; i < option.values; ++i) words.emplace_back("1");
            CHECK_MESSAGE(!contains(rejection(words), "expected a"), option.words.back());
        }
    }

    TEST_CASE("What passed every range before is rejected by the program") {
        for (const char* words : {"report x.sqlite --alpha nan", "generate direct --unsteadiness nan",
                                  "report x.sqlite --seed -1", "clips info x.bvh --unit inf",
                                  "clips trim a.bvh b.bvh --fps nan"}) {
            CAPTURE(words);
            const auto done = program(words);
            CHECK(done.status != 0);
            CHECK(contains(done.err, "expected"));
        }
    }

    TEST_CASE("What is mistyped is named, with what was probably meant") {
        struct Case {
            const char* words;
            const char* says;
        };
        for (const Case& one :
             {Case{"chek pointing2023", "deixis: there is no command chek. Did you mean check?"},
              Case{"clips chek x.bvh", "deixis clips: there is no command chek. Did you mean check?"},
              Case{"run pointing2023-stand-ins --partcipant P01",
                   "deixis run: there is no option --partcipant. Did you mean --participant?"},
              Case{"report --jsno=x y.sqlite",
                   "deixis report: there is no option --jsno. Did you mean --json?"},
              Case{"sing", "deixis: there is no command sing\n"}}) {
            CAPTURE(one.words);
            const auto done = program(one.words);
            CHECK(done.status == 2);
            CHECK(contains(done.err, one.says));
        }
        CHECK(contains(program("merge").err, "required"));
        const std::string help = program("merge --help").out;
        CHECK(contains(help, "DB..."));
        CHECK(contains(help, "two or more"));
    }

    TEST_CASE("In a pipe, too, what it comes to stands after the details") {
        const Scratch scratch;
        spill(scratch / "bad.bvh", "x");
        spill(scratch / "worse.bvh", "y");
        const auto done =
            program("clips check " + (scratch / "bad.bvh") + " " + (scratch / "worse.bvh") + " 2>&1 | cat");
        const auto verdict = done.out.find("2 of 2 files cannot be used");
        REQUIRE(verdict != std::string::npos);
        CHECK(done.out.find("worse.bvh:1") < verdict);
    }
}
