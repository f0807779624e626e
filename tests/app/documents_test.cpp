// The documents keep to what is there: links lead somewhere, commands exist.
#include <regex>
#include <set>

#include "program.hpp"

using namespace deixis::tests;

namespace {

std::vector<fs::path> documents() {
    std::vector<fs::path> files{sourceDir() / "README.md"};
    for (const auto& entry : fs::directory_iterator(sourceDir() / "docs"))
        if (entry.path().extension() == ".md") files.push_back(entry.path());
    return files;
}

}  // namespace

TEST_SUITE("app/documents") {
    TEST_CASE("every relative link and picture leads to a file") {
        const std::regex link(R"(\]\(([^)#:]+)(#[^)]*)?\))");
        int links = 0;
        for (const fs::path& file : documents()) {
            const std::string text = slurp(file);
            for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
                INFO(file.string() << " -> " << (*at)[1].str());
                CHECK(fs::exists(file.parent_path() / (*at)[1].str()));
                ++links;
            }
        }
        CHECK(links > 15);
    }

    TEST_CASE(
        "every command that a document names is one of the program, with the options that it is given") {
        const std::regex command(R"((?:^|[`\n ])deixis ([a-z]+)((?: [^`\n]*)?))");
        const std::regex option(R"( (--[a-z-]+))");
        std::set<std::string> seen;
        for (const fs::path& file : documents()) {
            const std::string text = slurp(file);
            for (std::sregex_iterator at(text.begin(), text.end(), command), end; at != end; ++at) {
                std::string name = (*at)[1];
                const std::string rest = (*at)[2];
                const std::regex what(" ([a-z][a-z-]*)");
                std::smatch one;
                if ((name == "participants" || name == "clips" || name == "learn") &&
                    std::regex_search(rest, one, what))
                    name += " " + one[1].str();
                INFO(file.string() << ": deixis " << (*at)[1].str() << rest);
                const auto help = program(name + " --help");
                CHECK(help.status == 0);
                seen.insert(name);
                if (help.out.find("(not in this build)") != std::string::npos) continue;
                for (std::sregex_iterator o(rest.begin(), rest.end(), option); o != end; ++o)
                    CHECK(help.out.find((*o)[1].str()) != std::string::npos);
            }
        }
        for (const std::string name : {"run", "simulate", "report", "plan", "targets", "generate", "view"})
            CHECK(seen.count(name) == 1);
    }

    TEST_CASE(
        "the page on one's own generator does what it says: its script, and its commands in their order") {
        const Scratch scratch;
        const std::string page = slurp(sourceDir() / "docs/own-generator.md");
        const auto block = [&page](const std::string& begin) {
            const auto from = page.find(begin) + begin.size();
            return page.substr(from, page.find("```", from) - from);
        };
        spill(scratch / "own_generator.py", block("```python\n"));
        std::string commands = block("```\ndeixis targets");
        commands = "deixis targets" + commands;
        const auto done = shell("cd " + scratch.path().string() + " && set -e; deixis() { " + programFile() +
                                " \"$@\"; }; " + commands);
        CHECK_MESSAGE(done.status == 0, done.err);
        CHECK(contains(done.out, "T100.bvh: no problem found"));
        const std::string evaluation = slurp(scratch / "evaluation.html");
        CHECK(contains(evaluation, "own"));
    }
}
