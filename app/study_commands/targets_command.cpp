// deixis targets: a study's targets and distractors as CSV, and a picture of them; or a grid of test points.
#include <fmt/format.h>

#include <memory>

#include "app/clips/study_setup.hpp"
#include "app/clips/training_targets.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/written_output.hpp"
#include "app/study/angles_text.hpp"
#include "app/study/visibility_text.hpp"
#include "app/study_commands/study_commands.hpp"
#include "assets/data/data_paths.hpp"
#include "assets/data/demonstrations.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/synthesis/demonstration_library.hpp"
#include "studies/design/target_grid.hpp"
#include "studies/design/targets.hpp"

namespace deixis::app {

namespace {

struct TargetsArguments {
    std::string study;
    std::string picture;
    bool force = false;
    int grid = 0;
    std::string training;
};

Result<void> printGrid(const TargetsArguments& options) {
    const auto training = loadTrainingTargets(options.training);
    if (!training) return tl::unexpected(training.error());
    const auto grid = studies::targetGrid(training->targets, options.grid);
    if (!grid) return fail("--grid", grid.error().message, grid.error().hint);
    fmt::print("{}", studies::targetsCsv(*grid, {}));
    return {};
}

Result<void> printTargets(const TargetsArguments& options) {
    if (auto checked = checkOutput(options.picture); !checked) return checked;
    const auto setup = loadStudySetup(options.study);
    if (!setup) return tl::unexpected(setup.error());
    if (!options.picture.empty()) {
        const auto parameters = assets::loadDemonstrationParameters(assets::dataFile("demonstrations.toml"));
        if (!parameters) return tl::unexpected(parameters.error());
        // The picture sets the targets against what the built-in systems were made from, as the paper's does.
        const auto library = motion::makeDemonstrations(motion::referenceHumanoid(), *parameters);
        if (!library) return tl::unexpected(library.error());
        std::vector<Vec3> demonstrations;
        for (const auto& demonstration : *library) demonstrations.push_back(demonstration.target);
        const std::string svg = studies::targetsSvg(setup->study.targets, setup->targets, demonstrations);
        if (auto written = writeUnlessEdited(options.picture, svg, options.force); !written) return written;
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
    describe(command, {.writes = "nothing but what it prints, unless --picture names a file.",
                       .example = "deixis targets pointing2023 > targets.csv\ndeixis targets pointing2023 "
                                  "--picture targets.svg > targets.csv\ndeixis targets --grid > grid.csv",
                       .page = "docs/design.md"});
    command.addOption("STUDY", options->study, "Study file, or the name of one that ships");
    Option picture = command.addOption("--picture", options->picture, "SVG picture of them to write");
    addForce(command, options->force).needs(picture);
    Option grid_option =
        command
            .addOption("--grid", options->grid,
                       "Instead: so many test points (a third power; without a number 1000, as in the paper) "
                       "within the limits of the training targets")
            .expected(0, 1)
            .showDefault("1000");
    command.addOption("--training", options->training,
                      "Manifest or CSV of the training targets [those of the synthetic demonstrations]");
    command.callback([options, grid_option, &chosen] {
        const bool grid = grid_option.given();
        if (grid != options->study.empty()) rejectUsage("targets", "Give either STUDY or --grid");
        if (!grid && !options->training.empty())
            rejectUsage("--training", "Belongs to --grid: a study says itself where its targets lie");
        chosen = [options, grid] { return grid ? printGrid(*options) : printTargets(*options); };
    });
}

}  // namespace deixis::app
