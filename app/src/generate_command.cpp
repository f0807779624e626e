// deixis generate: a built-in system's clips for a list of targets.
#include <fmt/format.h>

#include <memory>

#include "assets/data_paths.hpp"
#include "assets/demonstrations.hpp"
#include "assets/target_list.hpp"
#include "commands.hpp"
#include "generation.hpp"
#include "study_setup.hpp"

namespace deixis::app {

namespace {

struct GenerateArguments {
    std::string system;
    std::string targets;
    std::string folder;
    std::uint64_t seed = 1;
    motion::HoldManner manner;
    bool force = false;
};

Result<void> generate(const GenerateArguments& options) {
    const auto avatar = loadShippedAvatar();
    if (!avatar) return tl::unexpected(avatar.error());
    const auto parameters = assets::loadDemonstrationParameters(assets::dataFile("demonstrations.toml"));
    if (!parameters) return tl::unexpected(parameters.error());
    const auto generator = motion::makeGenerator(options.system, avatar->skeleton, *parameters);
    if (!generator) return tl::unexpected(generator.error());
    const auto targets = assets::readTargetList(options.targets);
    if (!targets) return tl::unexpected(targets.error());
    const auto rows =
        generateClips(**generator, *targets, options.seed, options.manner, options.folder, options.force);
    if (!rows) return tl::unexpected(rows.error());
    fmt::print("{} clips of {}: {}\n", rows->size(), options.system,
               (std::filesystem::path(options.folder) / "manifest.csv").string());
    return {};
}

}  // namespace

void addGenerateCommand(CLI::App& cli, Command& chosen) {
    auto options = std::make_shared<GenerateArguments>();
    CLI::App* command =
        cli.add_subcommand("generate", "Make a built-in system's clips for a list of targets");
    command
        ->add_option("SYSTEM", options->system,
                     fmt::format("One of {}", fmt::join(motion::generatorNames(), ", ")))
        ->required();
    command
        ->add_option("--targets", options->targets,
                     "CSV with target_id,x,y,z, such as 'deixis targets' prints")
        ->required();
    command->add_option("--out", options->folder, "Folder for the clips and their manifest")->required();
    command->add_option("--seed", options->seed, "Seed of what varies from clip to clip")
        ->capture_default_str();
    command
        ->add_option("--hold", options->manner.hold_s, "Seconds that a gesture is held [as the system does]")
        ->check(CLI::Range(0.1, 30.0));
    command
        ->add_option("--unsteadiness", options->manner.unsteadiness_m,
                     "Metres that the fingertip wanders during the hold [as the system does]")
        ->check(CLI::Range(0.0, 0.5));
    command->add_flag("--force", options->force, "Replace what is there already");
    command->callback([options, &chosen] { chosen = [options] { return generate(*options); }; });
}

}  // namespace deixis::app
