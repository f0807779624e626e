// The commands for clips: making, inspecting, converting and showing them.
#pragma once

#include "app/program/commands.hpp"

namespace deixis::app {

void addGenerateCommand(Parser cli, Command& chosen);
void addClipsCommand(Parser cli, Command& chosen);
void addViewCommand(Parser cli, Command& chosen);

}  // namespace deixis::app
