// The commands of what was answered: reports, statistics, power, and databases on their way elsewhere.
#pragma once

#include "app/program/commands.hpp"

namespace deixis::app {

void addPowerCommand(CLI::App& cli, Command& chosen);
void addFitCommand(CLI::App& cli, Command& chosen);
void addReportCommand(CLI::App& cli, Command& chosen);
void addEvaluateCommand(CLI::App& cli, Command& chosen);
void addExportCommand(CLI::App& cli, Command& chosen);
void addMergeCommand(CLI::App& cli, Command& chosen);
void addPackageCommand(CLI::App& cli, Command& chosen);
void addPushCommand(CLI::App& cli, Command& chosen);
void addStatsCommand(CLI::App& cli, Command& chosen);
void addSchemaCommand(CLI::App& cli, Command& chosen);

}  // namespace deixis::app
