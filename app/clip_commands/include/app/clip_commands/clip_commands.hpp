// The commands of clips: making, looking into, converting and showing them.
#pragma once

#include "app/program/commands.hpp"

namespace deixis::app {

void addGenerateCommand(CLI::App& cli, Command& chosen);
void addClipsCommand(CLI::App& cli, Command& chosen);
void addViewCommand(CLI::App& cli, Command& chosen);

}  // namespace deixis::app
