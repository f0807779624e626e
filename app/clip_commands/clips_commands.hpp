// The subcommands of `deixis clips`, one file each; declared as in commands.hpp.
#pragma once

#include "app/program/commands.hpp"

namespace deixis::app {

void addClipsInfoCommand(CLI::App& clips, Command& chosen);
void addClipsCheckCommand(CLI::App& clips, Command& chosen);
void addClipsConvertCommand(CLI::App& clips, Command& chosen);
void addClipsJointsCommand(CLI::App& clips, Command& chosen);
void addClipsMapCommand(CLI::App& clips, Command& chosen);
void addClipsRetargetCommand(CLI::App& clips, Command& chosen);
void addClipsMeasureCommand(CLI::App& clips, Command& chosen);
void addClipsStatisticsCommand(CLI::App& clips, Command& chosen);
void addClipsMirrorCommand(CLI::App& clips, Command& chosen);
void addClipsTrimCommand(CLI::App& clips, Command& chosen);
void addClipsResampleCommand(CLI::App& clips, Command& chosen);
void addClipsSegmentCommand(CLI::App& clips, Command& chosen);

}  // namespace deixis::app
