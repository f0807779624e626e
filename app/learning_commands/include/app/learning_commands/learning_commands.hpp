// The commands for learning systems from demonstrations.
#pragma once

#include "app/program/commands.hpp"

namespace deixis::app {

void addLearnCommand(Parser cli, Command& chosen);

}  // namespace deixis::app
