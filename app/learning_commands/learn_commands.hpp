// The commands below `deixis learn`.
#pragma once

#include "app/program/commands.hpp"

namespace deixis::app {

void addLearnProjectCommand(Parser learn, Command& chosen);
void addLearnTrainCommands(Parser learn, Command& chosen);
void addLearnGesturesCommands(Parser learn, Command& chosen);

}  // namespace deixis::app
