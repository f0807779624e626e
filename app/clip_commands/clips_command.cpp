// deixis clips: looking into clip files, checking, converting, changing and cutting them.
#include "app/clip_commands/clip_commands.hpp"
#include "app/program/command_help.hpp"
#include "clips_commands.hpp"

namespace deixis::app {

void addClipsCommand(Parser cli, Command& chosen) {
    Parser clips = cli.addCommand("clips", "Inspect, check, convert and cut clip files");
    clips.requireCommand();
    describe(clips, {.writes = "nothing, or what -o names.",
                     .example = "deixis clips info clips/T001.bvh",
                     .page = "docs/clip-format.md"});
    addClipsInfoCommand(clips, chosen);
    addClipsCheckCommand(clips, chosen);
    addClipsConvertCommand(clips, chosen);
    addClipsJointsCommand(clips, chosen);
    addClipsMapCommand(clips, chosen);
    addClipsRetargetCommand(clips, chosen);
    addClipsMeasureCommand(clips, chosen);
    addClipsStatisticsCommand(clips, chosen);
    addClipsMirrorCommand(clips, chosen);
    addClipsTrimCommand(clips, chosen);
    addClipsResampleCommand(clips, chosen);
    addClipsSegmentCommand(clips, chosen);
    addClipsAuthorCommand(clips, chosen);
}

}  // namespace deixis::app
