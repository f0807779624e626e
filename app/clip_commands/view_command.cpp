// deixis view: a clip on the avatar, or a system that points at a ball; in a window, as a picture
// or a film.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "app/clip_commands/clip_commands.hpp"
#include "app/clips/clip_files.hpp"
#include "app/clips/study_setup.hpp"
#include "app/clips/systems.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/written_output.hpp"
#include "import_options.hpp"

#ifdef DEIXIS_IMMERSIVE
#include "app/viewer/clip_viewer.hpp"
#include "app/viewer/system_viewer.hpp"
#endif

namespace deixis::app {

#ifdef DEIXIS_IMMERSIVE

namespace {

struct ViewArguments {
    std::string file;
    std::string system;
    std::string weights;
    std::vector<double> target_m{0.5, 1.2, 1.6};
    std::string avatar;
    assets::ImportOptions import;
    ViewOptions view;
    bool force = false;
};

Result<void> view(const ViewArguments& options) {
    if (options.file.empty() == options.system.empty()) requireUsage("FILE or --system");
    for (const std::string& file : {options.view.screenshot, options.view.mp4_file})
        if (auto free = checkFree(file, options.force); !free) return free;
    const auto avatar = loadAvatarOrShipped(options.avatar);
    if (!avatar) return tl::unexpected(avatar.error());
    for (const std::string& remark : avatar->remarks) fmt::print(stderr, "{}: {}\n", options.avatar, remark);
    if (!options.system.empty()) {
        const auto system = makeSystem(options.system, options.weights, avatar->skeleton);
        if (!system) return tl::unexpected(system.error());
        const auto& at = options.target_m;
        return viewSystem(*system->generator, *avatar, Vec3(at[0], at[1], at[2]), options.view);
    }
    const auto file = assets::importClip(options.file, options.import);
    if (!file) return tl::unexpected(file.error());
    const auto clip = clipOnAvatar(*file, options.file, *avatar);
    if (!clip) return tl::unexpected(clip.error());
    return viewClip(*clip, options.file, assets::describe(*file), *avatar, options.view);
}

}  // namespace

void addViewCommand(Parser cli, Command& chosen) {
    auto options = std::make_shared<ViewArguments>();
    Parser command = cli.addCommand("view", "Show a clip on the avatar, or a system at work");
    describe(command, {.writes = "nothing, unless --screenshot names a PNG file, or --mp4 a film.",
                       .example = "deixis view clips/T001.bvh\ndeixis view clips/T001.bvh --time 0.5 1.0 "
                                  "1.5 --screenshot strip.png\ndeixis view --system direct --mp4 direct.mp4",
                       .page = "docs/clip-format.md"});
    command.addOption("FILE", options->file, clip_file_kinds);
    command.addOption("--system", options->system, "A system that points at a ball which you drag")
        .valueName("SYSTEM");
    command
        .addOption("--weights", options->weights,
                   "A learned system's weights [those that come with the program]")
        .valueName("FILE");
    command.addOption("--target", options->target_m, "Where the ball is at first, in metres")
        .expected(3)
        .valueName("X Y Z")
        .showDefault("0.5 1.2 1.6");
    addImportOptions(command, options->import);
    command.addOption("--avatar", options->avatar, "A humanoid glTF or VRM file [Deixis's own avatar]");
    command.addOption("--size", options->view.size, "Window or picture size").showDefault();
    const auto screenshot =
        command.addOption("--screenshot", options->view.screenshot, "Write a PNG and open no window");
    command
        .addOption("--mp4", options->view.mp4_file,
                   "Write a film of the whole movement (needs ffmpeg) and open no window")
        .excludes(screenshot);
    addForce(command, options->force, "a picture or film that is");
    command.addOption(
        "--time", options->view.times_s,
        "Time in seconds at which the clip starts or the picture is taken; several make a strip");
    command
        .addOption(
            "--from", options->view.from,
            "Side of the avatar: front, left, right, back or three-quarter [three-quarter; of a system "
            "from where the ball is seen, too]")
        .valueName("SIDE");
    command.callback([options, &chosen] { chosen = [options] { return view(*options); }; });
}

#else

void addViewCommand(Parser cli, Command& chosen) {
    Parser command = cli.addCommand("view", "Show a clip on the avatar (not in this build)");
    describe(command,
             {.writes = "nothing.", .example = "deixis view clips/T001.bvh", .page = "docs/clip-format.md"});
    command.takeAllWords();
    command.callback([&chosen] {
        chosen = []() -> Result<void> {
            return fail("view", "this program was built without windows (DEIXIS_IMMERSIVE=OFF)");
        };
    });
}

#endif

}  // namespace deixis::app
