// The commands of a study and its participants: from checking its file to showing a session again.
#pragma once

#include "app/program/commands.hpp"

namespace deixis::app {

void addRunCommand(CLI::App& cli, Command& chosen);
void addSimulateCommand(CLI::App& cli, Command& chosen);
void addReplayCommand(CLI::App& cli, Command& chosen);
void addCheckCommand(CLI::App& cli, Command& chosen);
void addPlanCommand(CLI::App& cli, Command& chosen);
void addParticipantsCommand(CLI::App& cli, Command& chosen);
void addTargetsCommand(CLI::App& cli, Command& chosen);

}  // namespace deixis::app
