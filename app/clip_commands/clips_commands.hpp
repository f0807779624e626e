// The subcommands of `deixis clips`, one file each; declared as in commands.hpp.
#pragma once

#include "app/program/commands.hpp"

namespace deixis::app {

void addClipsInfoCommand(Parser clips, Command& chosen);
void addClipsCheckCommand(Parser clips, Command& chosen);
void addClipsConvertCommand(Parser clips, Command& chosen);
void addClipsJointsCommand(Parser clips, Command& chosen);
void addClipsMapCommand(Parser clips, Command& chosen);
void addClipsRetargetCommand(Parser clips, Command& chosen);
void addClipsMeasureCommand(Parser clips, Command& chosen);
void addClipsStatisticsCommand(Parser clips, Command& chosen);
void addClipsMirrorCommand(Parser clips, Command& chosen);
void addClipsTrimCommand(Parser clips, Command& chosen);
void addClipsResampleCommand(Parser clips, Command& chosen);
void addClipsSegmentCommand(Parser clips, Command& chosen);
void addClipsAuthorCommand(Parser clips, Command& chosen);

}  // namespace deixis::app
