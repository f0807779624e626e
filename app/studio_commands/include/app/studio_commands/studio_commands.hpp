// The commands for the studio: its server.
#pragma once

#include "app/program/commands.hpp"

namespace deixis::app {

void addServeCommand(Parser cli, Command& chosen);

}  // namespace deixis::app
