// The commands for a study and its participants: from checking its file to replaying a session.
#pragma once

#include "app/program/commands.hpp"

namespace deixis::app {

void addRunCommand(Parser cli, Command& chosen);
void addSimulateCommand(Parser cli, Command& chosen);
void addReplayCommand(Parser cli, Command& chosen);
void addCheckCommand(Parser cli, Command& chosen);
void addPlanCommand(Parser cli, Command& chosen);
void addParticipantsCommand(Parser cli, Command& chosen);
void addTargetsCommand(Parser cli, Command& chosen);

}  // namespace deixis::app
