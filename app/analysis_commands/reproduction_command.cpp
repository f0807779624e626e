// deixis reproduction: the paper's results and ours side by side, on one page.
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/analysis_commands/analysis_commands.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/version.hpp"
#include "app/program/written_output.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "motion/networks/weights_file.hpp"
#include "results/reproduction/reproduction.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

struct ReproductionArguments {
    std::vector<std::string> grids;
    std::vector<std::string> studies;
    std::string ceiling;
    std::string demonstrations;
    std::vector<std::string> weights;
    std::string picture;
    std::vector<std::string> pages;
    std::string page;
    bool force = false;
};

/// Reads each of an option's NAME=FILE.
template <typename Figures, typename Read>
Result<void> readNamed(const char* option, const std::vector<std::string>& texts, Read read,
                       std::vector<Figures>& out) {
    for (const std::string& text : texts) {
        const auto one = nameAndValue(text);
        if (!one) return fail(option, fmt::format("found '{}', expected NAME=FILE", text));
        auto figures = read(one->first, one->second);
        if (!figures) return tl::unexpected(figures.error());
        out.push_back(std::move(*figures));
    }
    return {};
}

Result<results::TrainedSystem> readTrained(const fs::path& file) {
    const auto bytes = readFile(file);
    if (!bytes) return tl::unexpected(bytes.error());
    const auto weights = motion::decodeWeights(*bytes, file.string());
    if (!weights) return tl::unexpected(weights.error());
    const auto metric = [&](const char* name) {
        const auto found = weights->metrics.find(name);
        return found == weights->metrics.end() ? std::nullopt : std::optional(found->second);
    };
    results::TrainedSystem out{.system = file.stem().string(),
                               .bytes = static_cast<long long>(bytes->size()),
                               .rewarded = weights->text("task").value_or(""),
                               .trained_by = weights->program_version,
                               .reward = metric("validation_reward"),
                               .jerk_ratio = metric("validation_jerk_ratio"),
                               .at_rest = metric("validation_at_rest"),
                               .arm_error_m = metric("validation_arm_error_m")};
    for (const auto& array : weights->arrays) out.numbers += static_cast<long long>(array.values.size());
    return out;
}

Result<void> write(const ReproductionArguments& options) {
    if (auto checked = checkOutput(options.page); !checked) return checked;
    if (auto free = checkReplaceable(options.page, options.force); !free) return free;
    results::ReproductionInput input;
    input.program = programVersion();
    input.pages = options.pages;
    if (auto read = readNamed("--grid", options.grids, results::readGridFigures, input.grids); !read)
        return read;
    if (auto read = readNamed("--study", options.studies, results::readStudyFigures, input.studies); !read)
        return read;
    if (!options.ceiling.empty()) {
        auto ceiling = results::readCeilingFigures(options.ceiling);
        if (!ceiling) return tl::unexpected(ceiling.error());
        input.ceiling = std::move(*ceiling);
    }
    if (!options.demonstrations.empty()) {
        auto demonstrations = results::readDemonstrationFigures(options.demonstrations);
        if (!demonstrations) return tl::unexpected(demonstrations.error());
        input.demonstrations = std::move(*demonstrations);
    }
    for (const std::string& file : options.weights) {
        auto trained = readTrained(file);
        if (!trained) return tl::unexpected(trained.error());
        input.trained.push_back(std::move(*trained));
    }
    if (!options.picture.empty()) {
        auto svg = readFile(options.picture);
        if (!svg) return tl::unexpected(svg.error());
        if (!svg->starts_with("<svg"))
            return fail(options.picture, "is no SVG picture",
                        "Expected what 'deixis targets --picture' writes");
        input.targets_svg = std::move(*svg);
    }
    if (auto written = writeFile(options.page, results::renderReproduction(input)); !written) return written;
    fmt::print("reproduction: {}\n", options.page);
    return {};
}

}  // namespace

void addReproductionCommand(Parser cli, Command& chosen) {
    auto options = std::make_shared<ReproductionArguments>();
    Parser command =
        cli.addCommand("reproduction", "Set results beside those of Deichler et al. (2023): one page");
    describe(command, {.writes = "the page (-o; default: reproduction.html in this folder).",
                       .example = "deixis reproduction --grid spherical=grid.json "
                                  "--study two-cue=analysis.json -o reproduction.html",
                       .page = "docs/reproduction.md"});
    command
        .addOption("--grid", options->grids,
                   "JSON of an objective evaluation (deixis evaluate), and its name; may be repeated")
        .oneValueEachTime()
        .valueName("NAME=FILE");
    command
        .addOption("--study", options->studies,
                   "JSON of a report on pointing2023 (deixis report), and who answered; may be repeated")
        .oneValueEachTime()
        .valueName("NAME=FILE");
    command
        .addOption("--ceiling", options->ceiling,
                   "JSON of an evaluation of the study's clips (deixis evaluate --study)")
        .valueName("FILE");
    command
        .addOption("--demonstrations", options->demonstrations,
                   "CSV of the demonstrations' measures (deixis clips measure --csv)")
        .valueName("FILE");
    command.addOption("--weights", options->weights, "A trained system, named like its file; may be repeated")
        .oneValueEachTime()
        .valueName("FILE");
    command.addOption("--picture", options->picture, "Picture of the targets (deixis targets --picture)");
    command.addOption("--page", options->pages, "Page with more, to link to; may be repeated")
        .oneValueEachTime()
        .valueName("FILE");
    addOutput(command, options->page, "HTML page to write [reproduction.html]");
    addForce(command, options->force);
    command.callback([options, &chosen] {
        if (options->page.empty()) options->page = "reproduction.html";
        if (options->grids.empty() && options->studies.empty())
            rejectUsage("reproduction", "Give --grid or --study: there is nothing to compare");
        chosen = [options] { return write(*options); };
    });
}

}  // namespace deixis::app
