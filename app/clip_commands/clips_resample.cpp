// deixis clips resample: a clip at another frame rate.
#include <memory>

#include "app/clips/clip_files.hpp"
#include "app/clips/clip_output.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/written_output.hpp"
#include "clips_commands.hpp"
#include "import_options.hpp"

namespace deixis::app {

namespace {

struct ClipsResampleArguments {
    std::string in;
    std::string out;
    double fps = 30.0;
    assets::ImportOptions import;
    bool force = false;
};

Result<void> resample(const ClipsResampleArguments& options) {
    if (auto free = checkFree(options.out, options.force); !free) return free;
    const auto source = readMappedClip(options.in, options.import);
    if (!source) return tl::unexpected(source.error());
    const auto resampled = motion::resample(source->clip, 1.0 / options.fps);
    if (!resampled) return fail(options.in, resampled.error().message, resampled.error().hint);
    return writeClip(*resampled, options.out);
}

}  // namespace

void addClipsResampleCommand(Parser clips, Command& chosen) {
    auto options = std::make_shared<ClipsResampleArguments>();
    Parser command = clips.addCommand("resample", "Resample a clip to another frame rate");
    describe(command, {.writes = "OUT, in the format given by its ending.",
                       .example = "deixis clips resample take.bvh -o take30.bvh --fps 30",
                       .page = "docs/segmentation.md"});
    command.addOption("IN", options->in, "Clip file").required();
    addOutputLast(command, options->out, "File for the clip at the new rate: .bvh, .glb or .csv").required();
    addForce(command, options->force);
    command.addOption("--fps", options->fps, "Frames per second of OUT").required().check(Range(1.0, 1000.0));
    addImportOptionsWithoutRate(command, options->import);
    command.callback([options, &chosen] { chosen = [options] { return resample(*options); }; });
}

}  // namespace deixis::app
