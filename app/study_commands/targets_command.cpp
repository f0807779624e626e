// deixis targets: a study's targets and distractors as CSV, and a picture of them; or a grid of test points,
// or what the synthetic demonstrations point at.
#include <fmt/format.h>

#include <memory>

#include "app/clips/study_setup.hpp"
#include "app/clips/synthetic_demonstrations.hpp"
#include "app/clips/training_targets.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/written_output.hpp"
#include "app/study/angles_text.hpp"
#include "app/study/visibility_text.hpp"
#include "app/study_commands/study_commands.hpp"
#include "core/files.hpp"
#include "studies/design/target_grid.hpp"
#include "studies/design/targets.hpp"

namespace deixis::app {

namespace {

struct TargetsArguments {
    std::string study;
    std::string picture;
    bool force = false;
    int grid = 0;
    bool spherical = false;
    bool demonstrations = false;
    std::string training;
};

Result<void> printDemonstrations() {
    const auto library = syntheticDemonstrations();
    if (!library) return tl::unexpected(library.error());
    std::vector<studies::TargetItem> targets;
    for (const auto& one : library->made)
        targets.push_back({.id = fmt::format("D{:02}", targets.size() + 1), .target = one.target});
    fmt::print("{}", studies::targetsCsv(targets, {}));
    return {};
}

Result<void> printGrid(const TargetsArguments& options) {
    const auto training = loadTrainingTargets(options.training);
    if (!training) return tl::unexpected(training.error());
    const auto grid =
        studies::targetGrid(training->targets, options.grid,
                            options.spherical ? studies::GridShape::spherical : studies::GridShape::box);
    if (!grid) return fail("--grid", grid.error().message, grid.error().hint);
    fmt::print("{}", studies::targetsCsv(*grid, {}));
    return {};
}

Result<void> printTargets(const TargetsArguments& options) {
    if (auto free = checkFree(options.picture, options.force); !free) return free;
    const auto setup = loadStudySetup(options.study);
    if (!setup) return tl::unexpected(setup.error());
    if (!options.picture.empty()) {
        // The picture sets the targets against what the built-in systems were made from, as the paper's does.
        const auto library = syntheticDemonstrations();
        if (!library) return tl::unexpected(library.error());
        std::vector<Vec3> demonstrations;
        for (const auto& demonstration : library->made) demonstrations.push_back(demonstration.target);
        const std::string svg = studies::targetsSvg(setup->study.targets, setup->targets, demonstrations);
        if (auto written = writeFile(options.picture, svg); !written) return written;
        fmt::print(stderr, "picture: {}\n", options.picture);
    }
    fmt::print("{}", studies::targetsCsv(setup->study, setup->targets));
    if (auto avatar = loadStudyAvatar(setup->study))
        fmt::print(stderr, "{}{}", visibilityText(*setup, *avatar), anglesText(*setup));
    else
        return tl::unexpected(avatar.error());
    return {};
}

}  // namespace

void addTargetsCommand(Parser cli, Command& chosen) {
    auto options = std::make_shared<TargetsArguments>();
    Parser command = cli.addCommand(
        "targets", "Print a study's targets and distractors as CSV; with --picture draw them, too");
    describe(command, {.writes = "only what it prints, unless --picture is given.",
                       .example = "deixis targets pointing2023 > targets.csv\ndeixis targets pointing2023 "
                                  "--picture targets.svg > targets.csv\ndeixis targets --grid > grid.csv",
                       .page = "docs/design.md"});
    command.addOption("STUDY", options->study, "Study file, or the name of one included");
    command.addOption("--picture", options->picture, "SVG picture of the targets to write");
    addForce(command, options->force, "a picture that is");
    Option grid_option = command
                             .addOption("--grid", options->grid,
                                        "Instead: this many test points (a cube number; default 1000, as in "
                                        "the paper) within the limits of the training targets")
                             .expected(0, 1)
                             .showDefault("1000");
    command.addFlag("--spherical", options->spherical,
                    "A grid even in azimuth, elevation and distance, not along x, y and z");
    command.addOption("--training", options->training,
                      "Manifest or CSV of the training targets [those of the synthetic demonstrations]");
    command.addFlag("--demonstrations", options->demonstrations,
                    "Instead: what the synthetic demonstrations point at, without their mirror images");
    command.callback([options, grid_option, &chosen] {
        const bool grid = grid_option.given();
        if (int{grid} + int{options->demonstrations} + int{!options->study.empty()} != 1)
            rejectUsage("targets", "Give one of STUDY, --grid and --demonstrations");
        if (!grid && !options->training.empty())
            rejectUsage("--training", "Only with --grid: a study has its own targets");
        if (!grid && options->spherical) rejectUsage("--spherical", "Only with --grid");
        chosen = [options, grid] {
            return options->demonstrations ? printDemonstrations()
                   : grid                  ? printGrid(*options)
                                           : printTargets(*options);
        };
    });
}

}  // namespace deixis::app
