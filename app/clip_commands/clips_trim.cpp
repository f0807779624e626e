// deixis clips trim: a part of a clip.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "app/clips/clip_files.hpp"
#include "app/clips/clip_output.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/written_output.hpp"
#include "clips_commands.hpp"
#include "core/number.hpp"
#include "import_options.hpp"
#include "motion/skeleton/clip_edit.hpp"

namespace deixis::app {

namespace {

struct ClipsTrimArguments {
    std::string in;
    std::string out;
    std::string from = "0";
    std::string to;
    assets::ImportOptions import;
    bool force = false;
};

/// "30": frame 30; "1.5s": the frame nearest to that time.
Result<int> frameFrom(std::string_view option, const std::string& text, const motion::Clip& clip) {
    constexpr double max_frames = 1e9;  // a file may have far fewer
    if (text.ends_with('s')) {
        const auto time_s = finiteNumber(std::string_view(text).substr(0, text.size() - 1));
        if (time_s)
            if (const double frame = std::round(*time_s / clip.frame_time_s); std::abs(frame) < max_frames)
                return static_cast<int>(frame);
    } else if (const auto frame = wholeNumber(text);
               frame && std::abs(static_cast<double>(*frame)) < max_frames) {
        return static_cast<int>(*frame);
    }
    return fail(std::string(option),
                fmt::format("found '{}', expected a frame such as 30 or seconds such as 1.5s", text));
}

Result<void> trim(const ClipsTrimArguments& options) {
    if (auto free = checkFree(options.out, options.force); !free) return free;
    const auto source = readMappedClip(options.in, options.import);
    if (!source) return tl::unexpected(source.error());
    const auto first = frameFrom("--from", options.from, source->clip);
    if (!first) return tl::unexpected(first.error());
    const auto last = options.to.empty() ? Result<int>(source->clip.frameCount() - 1)
                                         : frameFrom("--to", options.to, source->clip);
    if (!last) return tl::unexpected(last.error());
    const auto part = motion::trimmed(source->clip, *first, *last);
    if (!part) return fail(options.in, part.error().message, part.error().hint);
    return writeClip(*part, options.out);
}

}  // namespace

void addClipsTrimCommand(Parser clips, Command& chosen) {
    auto options = std::make_shared<ClipsTrimArguments>();
    Parser command = clips.addCommand("trim", "Keep a part of a clip");
    describe(command, {.writes = "OUT, in the format given by its ending.",
                       .example = "deixis clips trim take.bvh -o part.bvh --from 1.5s --to 3s",
                       .page = "docs/segmentation.md"});
    command.addOption("IN", options->in, "Clip file").required();
    addOutputLast(command, options->out, "File for the part: .bvh, .glb or .csv").required();
    addForce(command, options->force);
    command.addOption("--from", options->from, "First frame kept, from 0, or seconds as in 1.5s")
        .showDefault();
    command.addOption("--to", options->to, "Last frame kept, or seconds as in 3s [the clip's last]");
    addImportOptions(command, options->import);
    command.callback([options, &chosen] { chosen = [options] { return trim(*options); }; });
}

}  // namespace deixis::app
