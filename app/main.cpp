// The program. Each command lives in a file of its own; this one names them and turns what went wrong into
// one line and an exit status: 0 done, 1 failed, 2 wrong usage.
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "app/command_line/command_line.hpp"
#include "app/command_line/old_spellings.hpp"
#include "app/program/progress_line.hpp"
#include "app/program/version.hpp"
#include "core/server_address.hpp"
#include "core/text.hpp"
#include "results/database/check_progress.hpp"
#ifdef DEIXIS_TRAINERS
#include "trainers/trainers.hpp"
#endif

namespace {

/// A server's address given to a command that works on files, by itself or as --option=ADDRESS.
std::optional<std::string> misplacedServer(const std::vector<std::string>& arguments) {
    if (arguments.empty() || arguments[0] == "report" || arguments[0] == "push") return std::nullopt;
    for (const std::string& one : arguments)
        for (const std::string& text : {one, one.substr(one.find('=') + 1)})
            if (deixis::looksLikeServerAddress(text)) return text;
    return std::nullopt;
}

/// What is typed ends up in databases, tables and pages, which are UTF-8.
std::optional<std::string> unkeepable(const std::vector<std::string>& arguments) {
    for (const std::string& one : arguments)
        if (!deixis::storableText(one)) return deixis::storable(one);
    return std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace deixis::app;
    // Answers, and all that is made from them, are their owner's alone.
    ::umask(S_IRWXG | S_IRWXO);
    // Line by line also into a pipe: what is told of the details comes before what they come to.
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    CLI::App cli{"Deixis: evaluate how an embodied agent points", "deixis"};
    cli.set_version_flag("--version", versionText());
    cli.require_subcommand(1);
    cli.fallthrough(false);

    Command chosen;
#ifdef DEIXIS_TRAINERS
    useTrainers(trainers());
#endif
    addCommands(cli, chosen);

    const std::vector<std::string> arguments =
        inCurrentSpelling(std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
    if (const auto text = unkeepable(arguments)) {
        fmt::print(
            stderr,
            "deixis: error: '{}': is no text in UTF-8. Type it in a terminal that uses UTF-8, or rename "
            "the file\n",
            *text);
        return 2;
    }
    if (const auto address = misplacedServer(arguments)) {
        fmt::print(
            stderr,
            "deixis: error: {}: is a server's address; only report and push take one, all else works on "
            "files. Run it with --help for more information.\n",
            deixis::withoutPasswords(*address));
        return 2;
    }
    deixis::results::observeChecks([](const std::filesystem::path& database) {
        return std::make_shared<ElapsedOnTerminal>("checking " + database.string());
    });
    try {
        cli.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
        const auto done = chosen();
        if (done) return 0;
        fmt::print(stderr, "deixis: error: {}\n", done.error().text());
        return 1;
    } catch (const CLI::ParseError& error) {
        std::ostringstream out, err;
        const int status = cli.exit(error, out, err);
        fmt::print("{}", out.str());
        if (status == 0) return 0;
        const std::string unknown = unknownWord(cli, arguments);
        fmt::print(stderr, "{}",
                   deixis::withoutPasswords(
                       unknown.empty() ? err.str() : unknown + "\nRun with --help for more information.\n"));
        return 2;
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "deixis: error: there is not enough memory for this\n");
        return 1;
    } catch (const std::exception& error) {
        fmt::print(stderr, "deixis: error: {}\n", deixis::withoutPasswords(error.what()));
        return 1;
    }
}
