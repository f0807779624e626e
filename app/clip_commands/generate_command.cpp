// deixis generate: a built-in or learned system's clips for a list of targets.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "app/clip_commands/clip_commands.hpp"
#include "app/clips/generation.hpp"
#include "app/clips/study_setup.hpp"
#include "app/clips/systems.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/progress_line.hpp"
#include "assets/tables/target_list.hpp"

namespace deixis::app {

namespace {

struct GenerateArguments {
    std::string system;
    std::string targets;
    std::string folder;
    std::string weights;
    std::uint64_t seed = 1;
    motion::HoldSettings settings;
    bool force = false;
};

Result<void> generate(const GenerateArguments& options) {
    const auto avatar = loadShippedAvatar();
    if (!avatar) return tl::unexpected(avatar.error());
    const auto system = makeSystem(options.system, options.weights, avatar->skeleton);
    if (!system) return tl::unexpected(system.error());
    const auto targets = assets::readTargetList(options.targets);
    if (!targets) return tl::unexpected(targets.error());
    auto working = std::make_optional<ElapsedOnTerminal>("generating");
    const auto rows =
        generateClips(*system, *targets, options.seed, options.settings, options.folder, options.force);
    working.reset();
    if (!rows) return tl::unexpected(rows.error());
    fmt::print("{} clips of {}: {}\n", rows->size(), options.system,
               (std::filesystem::path(options.folder) / "manifest.csv").string());
    return {};
}

}  // namespace

void addGenerateCommand(Parser cli, Command& chosen) {
    auto options = std::make_shared<GenerateArguments>();
    Parser command = cli.addCommand("generate", "Make a system's clips for a list of targets");
    describe(command, {.writes = "a BVH file for each target and manifest.csv to DIR; all of them or none.",
                       .example = "deixis targets pointing2023 > targets.csv\ndeixis generate direct "
                                  "--targets targets.csv -o clips/direct",
                       .page = "docs/systems.md"});
    command
        .addOption("SYSTEM", options->system,
                   fmt::format("One of {}", fmt::join(motion::systemNames(), ", ")))
        .required();
    command
        .addOption("--targets", options->targets, "CSV with target_id,x,y,z, such as 'deixis targets' prints")
        .required();
    addOutput(command, options->folder, "Folder for the clips and their manifest", "DIR").required();
    command
        .addOption("--weights", options->weights,
                   "A learned system's weights [those that come with the program]")
        .valueName("FILE");
    addForce(command, options->force);
    addSeed(command, options->seed, "what varies from clip to clip");
    command
        .addOption("--hold", options->settings.hold_s,
                   "How long a gesture is held, in seconds [as the system does]")
        .check(Range(0.1, 30.0));
    command
        .addOption("--unsteadiness", options->settings.unsteadiness_m,
                   "How far the fingertip wanders during the hold, in metres [as the system does]")
        .check(Range(0.0, 0.5));
    command.callback([options, &chosen] { chosen = [options] { return generate(*options); }; });
}

}  // namespace deixis::app
