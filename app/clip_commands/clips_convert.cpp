// deixis clips convert: a clip file in another format.
#include <fmt/format.h>

#include <memory>

#include "app/clips/clip_output.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/written_output.hpp"
#include "clips_commands.hpp"
#include "import_options.hpp"

namespace deixis::app {

namespace {

struct ClipsConvertArguments {
    std::string from;
    std::string to;
    bool force = false;
    assets::ImportOptions import;
};

Result<void> convert(const ClipsConvertArguments& options) {
    if (auto free = checkFree(options.to, options.force); !free) return free;
    const auto file = assets::importClip(options.from, options.import);
    if (!file) return tl::unexpected(file.error());
    if (auto done = writeClip(file->clip, options.to); !done) return done;
    for (const std::string& remark : file->remarks) fmt::print(stderr, "{}: {}\n", options.from, remark);
    fmt::print("{}: {}\n{}: {} frames at {:.4g} fps, metres, y up\n", options.from, assets::describe(*file),
               options.to, file->clip.frameCount(), file->clip.framesPerSecond());
    return {};
}

}  // namespace

void addClipsConvertCommand(Parser clips, Command& chosen) {
    auto options = std::make_shared<ClipsConvertArguments>();
    Parser command = clips.addCommand(
        "convert", "Write a clip in another format, in metres and y up, on its own skeleton");
    describe(command, {.writes = "OUT, in the format given by its ending.",
                       .example = "deixis clips convert take.csv -o take.bvh",
                       .page = "docs/clip-format.md"});
    command.addOption("IN", options->from, clip_file_kinds).required();
    addOutputLast(command, options->to, "File to write: .bvh, .glb, or .csv for joint positions").required();
    addForce(command, options->force);
    addImportOptions(command, options->import);
    command.callback([options, &chosen] { chosen = [options] { return convert(*options); }; });
}

}  // namespace deixis::app
