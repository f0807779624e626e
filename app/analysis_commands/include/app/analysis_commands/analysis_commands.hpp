// The commands for results: reports, statistics, power, and copying databases elsewhere.
#pragma once

#include "app/program/commands.hpp"

namespace deixis::app {

void addPowerCommand(Parser cli, Command& chosen);
void addFitCommand(Parser cli, Command& chosen);
void addReportCommand(Parser cli, Command& chosen);
void addEvaluateCommand(Parser cli, Command& chosen);
void addExportCommand(Parser cli, Command& chosen);
void addMergeCommand(Parser cli, Command& chosen);
void addPackageCommand(Parser cli, Command& chosen);
void addPushCommand(Parser cli, Command& chosen);
void addStatsCommand(Parser cli, Command& chosen);
void addReproductionCommand(Parser cli, Command& chosen);
void addSchemaCommand(Parser cli, Command& chosen);

}  // namespace deixis::app
