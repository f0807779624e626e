// The commands of the program. Each `add...Command` declares a subcommand and its options; when the command
// line names it, `chosen` becomes what is to be done.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "core/error.hpp"

namespace deixis::app {

using Command = std::function<Result<void>()>;

void addRunCommand(CLI::App& cli, Command& chosen);
void addSimulateCommand(CLI::App& cli, Command& chosen);
void addPowerCommand(CLI::App& cli, Command& chosen);
void addFitCommand(CLI::App& cli, Command& chosen);
void addReportCommand(CLI::App& cli, Command& chosen);
void addEvaluateCommand(CLI::App& cli, Command& chosen);
void addReplayCommand(CLI::App& cli, Command& chosen);
void addCheckCommand(CLI::App& cli, Command& chosen);
void addPlanCommand(CLI::App& cli, Command& chosen);
void addParticipantsCommand(CLI::App& cli, Command& chosen);
void addExportCommand(CLI::App& cli, Command& chosen);
void addMergeCommand(CLI::App& cli, Command& chosen);
void addPackageCommand(CLI::App& cli, Command& chosen);
void addPushCommand(CLI::App& cli, Command& chosen);
void addTargetsCommand(CLI::App& cli, Command& chosen);
void addGenerateCommand(CLI::App& cli, Command& chosen);
void addClipsCommand(CLI::App& cli, Command& chosen);
void addStatsCommand(CLI::App& cli, Command& chosen);
void addSchemaCommand(CLI::App& cli, Command& chosen);
void addViewCommand(CLI::App& cli, Command& chosen);
void addDescribeCommand(CLI::App& cli, Command& chosen);

}  // namespace deixis::app
