// deixis view: a clip on the avatar, in a window or as a picture.
#include <memory>

#include "assets/bvh.hpp"
#include "clip_files.hpp"
#include "commands.hpp"
#include "study_setup.hpp"

#ifdef DEIXIS_IMMERSIVE
#include "immersive/clip_viewer.hpp"
#endif

namespace deixis::app {

#ifdef DEIXIS_IMMERSIVE

namespace {

struct Options {
    std::string file;
    double metres_per_unit = 0.0;
    ViewOptions view;
};

Result<void> view(const Options& options) {
    const auto avatar = loadShippedAvatar();
    if (!avatar) return tl::unexpected(avatar.error());
    assets::BvhOptions read;
    if (options.metres_per_unit > 0.0) read.metres_per_unit = options.metres_per_unit;
    const auto file = readClipFile(options.file, read);
    if (!file) return tl::unexpected(file.error());
    const auto clip = clipOnAvatar(file->clip, *avatar, options.file);
    if (!clip) return tl::unexpected(clip.error());
    return viewClip(*clip, options.file, file->description, *avatar, options.view);
}

}  // namespace

void addViewCommand(CLI::App& cli, Command& chosen) {
    auto options = std::make_shared<Options>();
    CLI::App* command = cli.add_subcommand("view", "Show a clip on the avatar");
    command->add_option("FILE", options->file, "BVH file (also .bvh.gz) or Kinect v2 CSV")->required();
    command->add_option("--metres-per-unit", options->metres_per_unit, "Length of a BVH unit [detected]")
        ->check(CLI::PositiveNumber);
    command->add_option("--size", options->view.size, "Window or picture size")->capture_default_str();
    command->add_option("--screenshot", options->view.screenshot, "Write a PNG and open no window");
    command->add_option(
        "--time", options->view.times_s,
        "Time in seconds at which the clip starts or the picture is taken; several make a strip");
    command->add_option("--from", options->view.from, "front, left, right, back or three-quarter")
        ->capture_default_str();
    command->callback([options, &chosen] { chosen = [options] { return view(*options); }; });
}

#else

void addViewCommand(CLI::App& cli, Command& chosen) {
    CLI::App* command = cli.add_subcommand("view", "Show a clip on the avatar (not in this build)");
    command->prefix_command();
    command->callback([&chosen] {
        chosen = []() -> Result<void> {
            return fail("view", "this program was built without windows (DEIXIS_IMMERSIVE=OFF)");
        };
    });
}

#endif

}  // namespace deixis::app
