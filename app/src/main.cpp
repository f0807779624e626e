// The program. Each command lives in a file of its own; this one names them and turns what went wrong into
// one line and an exit status: 0 done, 1 failed, 2 wrong usage.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <sstream>

#include "commands.hpp"
#include "core/server_address.hpp"

int main(int argc, char** argv) {
    using namespace deixis::app;
    CLI::App cli{"Deixis: evaluate how an embodied agent points", "deixis"};
    cli.set_version_flag("--version", programVersion());
    cli.require_subcommand(1);
    cli.fallthrough(false);

    Command chosen;
    addRunCommand(cli, chosen);
    addSimulateCommand(cli, chosen);
    addPowerCommand(cli, chosen);
    addFitCommand(cli, chosen);
    addReportCommand(cli, chosen);
    addEvaluateCommand(cli, chosen);
    addStatsCommand(cli, chosen);
    addReplayCommand(cli, chosen);
    addCheckCommand(cli, chosen);
    addPlanCommand(cli, chosen);
    addParticipantsCommand(cli, chosen);
    addExportCommand(cli, chosen);
    addMergeCommand(cli, chosen);
    addPushCommand(cli, chosen);
    addTargetsCommand(cli, chosen);
    addGenerateCommand(cli, chosen);
    addClipsCommand(cli, chosen);
    addViewCommand(cli, chosen);

    try {
        cli.parse(argc, argv);
        const auto done = chosen();
        if (done) return 0;
        fmt::print(stderr, "deixis: error: {}\n", done.error().text());
        return 1;
    } catch (const CLI::ParseError& error) {
        std::ostringstream out, err;
        const int status = cli.exit(error, out, err);
        fmt::print("{}", out.str());
        fmt::print(stderr, "{}", deixis::withoutPasswords(err.str()));
        return status == 0 ? 0 : 2;
    } catch (const std::exception& error) {
        fmt::print(stderr, "deixis: error: {}\n", deixis::withoutPasswords(error.what()));
        return 1;
    }
}
