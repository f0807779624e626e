// deixis describe: the manual page and the completion, made when the program is built. Help leaves it out.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "app/program/commands.hpp"
#include "app/program/version.hpp"
#include "assets/data/data_paths.hpp"
#include "bash_completion.hpp"
#include "manual_page.hpp"

namespace deixis::app {

namespace {

/// The TOML files of a kind that ship, by name, after `out`.
std::vector<std::string> shippedNames(const char* kind, std::vector<std::string> out = {}) {
    std::error_code code;
    for (const auto& entry : std::filesystem::directory_iterator(assets::dataFile(kind), code))
        if (entry.path().extension() == ".toml") out.push_back(entry.path().stem().string());
    std::sort(out.begin(), out.end());
    return out;
}

Result<void> printDescription(const CLI::App& cli, const std::string& kind) {
    const CommandDescription program = describe(cli);
    if (kind == "man") {
        const std::string version = programVersion();
        fmt::print("{}", manualPage(program, version.substr(0, version.find(" ("))));
    } else
        fmt::print("{}", bashCompletion(program, {{"STUDY", shippedNames("studies", {"@files"})},
                                                  {"--effect", shippedNames("effects", {"@files"})},
                                                  {"--language", shippedNames("languages")}}));
    return {};
}

}  // namespace

void addDescribeCommand(Parser cli, Command& chosen) {
    auto kind = std::make_shared<std::string>();
    Parser command = cli.addCommand("describe", "Print the manual page, or the completion for bash");
    command.hide();
    command.addOption("KIND", *kind, "man or bash").required().check(OneOf{{"man", "bash"}});
    command.callback(
        [kind, cli, &chosen] { chosen = [kind, cli] { return printDescription(cli.app(), *kind); }; });
}

}  // namespace deixis::app
