// The commands for the studio: in a browser, and its server alone.
#pragma once

#include "app/program/commands.hpp"

namespace deixis::app {

void addStudioCommand(Parser cli, Command& chosen);
void addServeCommand(Parser cli, Command& chosen);

}  // namespace deixis::app
