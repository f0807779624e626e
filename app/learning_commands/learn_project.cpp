// deixis learn project: a manifest's clips as a simulated body can move.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/clips/clip_output.hpp"
#include "app/clips/study_setup.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/progress_line.hpp"
#include "assets/joints/bvh.hpp"
#include "assets/tables/manifest.hpp"
#include "core/random.hpp"
#include "demonstrations.hpp"
#include "learn_commands.hpp"
#include "physics/projection/projection.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

struct LearnProjectArguments {
    std::string manifest;
    std::string folder;
    std::string avatar;
    bool full_body = false;
    double noise_rad = 0.0;
    std::uint64_t seed = 1;
    bool force = false;
};

/// A clip's line of the table.
struct Tracked {
    std::string clip;
    physics::Tracking plain;
    physics::Projection made;  ///< without its clip
};

Result<Tracked> projectRow(physics::Body& body, const motion::Clip& clip, const fs::path& file,
                           const LearnProjectArguments& options, const assets::ManifestRow& row) {
    const auto plain = physics::project(body, clip, {.feed_forward = false});
    if (!plain) return tl::unexpected(inFile(plain.error(), file.string()));
    auto made = physics::project(
        body, clip, {.noise_rad = options.noise_rad, .seed = deriveSeed(options.seed, row.clip)});
    if (!made) return tl::unexpected(inFile(made.error(), file.string()));
    return Tracked{row.clip, plain->tracking, std::move(*made)};
}

void printTable(const std::vector<Tracked>& clips) {
    std::size_t width = 4;
    for (const Tracked& clip : clips) width = std::max(width, clip.clip.size());
    const auto line = [width](const std::string& name, const physics::Tracking& plain,
                              const physics::Tracking& made, double fit_m) {
        fmt::print("{:<{}}  {:>7.2f} {:>6.2f}  {:>9.2f} {:>6.2f}  {:>12.2f}\n", name, width,
                   100.0 * plain.mean_m, 100.0 * plain.max_m, 100.0 * made.mean_m, 100.0 * made.max_m,
                   100.0 * fit_m);
    };
    fmt::print("Elbows and wrists, cm from the demonstration's\n");
    fmt::print("{:<{}}  {:>7} {:>6}  {:>9} {:>6}  {:>12}\n", "", width, "plain", "", "projected", "",
               "no joint for");
    fmt::print("{:<{}}  {:>7} {:>6}  {:>9} {:>6}  {:>12}\n", "clip", width, "mean", "max", "mean", "max",
               "max");
    physics::Tracking plain, made;
    double fit_m = 0.0;
    const auto share = 1.0 / static_cast<double>(clips.size());
    for (const Tracked& clip : clips) {
        line(clip.clip, clip.plain, clip.made.tracking, clip.made.fit_distance_m);
        plain.mean_m += share * clip.plain.mean_m;
        plain.max_m = std::max(plain.max_m, clip.plain.max_m);
        made.mean_m += share * clip.made.tracking.mean_m;
        made.max_m = std::max(made.max_m, clip.made.tracking.max_m);
        fit_m = std::max(fit_m, clip.made.fit_distance_m);
    }
    line("all", plain, made, fit_m);
    for (const Tracked& clip : clips)
        if (clip.made.beyond_limit_rad > 0.0)
            fmt::print("{}: {} goes {:.1f} degrees beyond its limit, and was stopped there\n", clip.clip,
                       clip.made.beyond_limit_of, degreesFromRadians(clip.made.beyond_limit_rad));
}

Result<void> projectAll(const LearnProjectArguments& options) {
    const auto manifest = readDemonstrations(options.manifest);
    if (!manifest) return tl::unexpected(manifest.error());
    const fs::path home = fs::absolute(manifest->file).parent_path();
    OutputFolder folder(options.folder, options.force);
    const auto names = folder.expectClipsOf(*manifest);
    if (!names) return tl::unexpected(names.error());

    const auto avatar = loadAvatarOrShipped(options.avatar);
    if (!avatar) return tl::unexpected(avatar.error());
    const auto figure = physics::makeFigure(
        avatar->skeleton, options.full_body ? physics::Stance::free : physics::Stance::pinned);
    if (!figure) return tl::unexpected(inFile(figure.error(), options.avatar));
    auto body = physics::Body::make(*figure);
    if (!body) return tl::unexpected(body.error());

    const Progress progress = progressOnTerminal("projecting");
    std::vector<Tracked> table;
    std::vector<assets::ManifestRow> rows = manifest->rows;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const fs::path file = home / rows[i].clip;
        const auto clip = demonstrationClip(file, *avatar, rows[i]);
        if (!clip) return tl::unexpected(clip.error());
        auto tracked = projectRow(*body, *clip, file, options, rows[i]);
        if (!tracked) return tl::unexpected(tracked.error());
        rows[i].clip = (*names)[i].generic_string();
        rows[i].processing = assets::physics_projected;
        if (auto added = folder.add((*names)[i], assets::writeBvh(tracked->made.clip)); !added) return added;
        tracked->made.clip = {};
        table.push_back(std::move(*tracked));
        progress(i + 1, rows.size());
    }
    if (auto added = folder.add("manifest.csv", assets::manifestCsv(rows)); !added) return added;
    if (auto finished = folder.finish(); !finished) return finished;
    printTable(table);
    fmt::print("{} clips physics-projected: {}\n", rows.size(),
               (fs::path(options.folder) / "manifest.csv").string());
    return {};
}

}  // namespace

void addLearnProjectCommand(Parser learn, Command& chosen) {
    auto options = std::make_shared<LearnProjectArguments>();
    Parser command = learn.addCommand("project", "Make demonstrations that a simulated body can perform");
    describe(command,
             {.writes = "a BVH file for each clip and manifest.csv to DIR, all of them or none. Prints how "
                        "closely the body follows.",
              .example = "deixis learn project clips/manifest.csv -o projected",
              .page = "docs/learning.md"});
    command.addOption("MANIFEST", options->manifest, "Manifest of the demonstrations, each with a target")
        .required();
    addOutput(command, options->folder, "Folder for the new clips and their manifest", "DIR").required();
    addForce(command, options->force);
    command.addOption("--avatar", options->avatar,
                      "Whose body it is, glTF or VRM; other clips are retargeted [Deixis's own]");
    command.addFlag("--full-body", options->full_body,
                    "The body stands on its feet; else its pelvis is held as in the clip");
    command
        .addOption("--noise", options->noise_rad,
                   "Standard deviation of what is added to targets, in radians")
        .showDefault()
        .check(Range(0.0, 0.5));
    addSeed(command, options->seed, "that noise");
    command.callback([options, &chosen] { chosen = [options] { return projectAll(*options); }; });
}

}  // namespace deixis::app
