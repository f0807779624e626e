// deixis clips mirror: a clip, or all of a manifest's, with left and right exchanged.
#include <fmt/format.h>

#include <map>
#include <memory>
#include <optional>

#include "app/clips/clip_files.hpp"
#include "app/clips/clip_output.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/progress_line.hpp"
#include "app/program/written_output.hpp"
#include "assets/tables/manifest.hpp"
#include "clips_commands.hpp"
#include "import_options.hpp"
#include "motion/skeleton/clip_edit.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

struct ClipsMirrorArguments {
    std::string in;
    std::string out;
    assets::ImportOptions import;
    bool force = false;
};

/// "T1" -> "T1-mirrored" -> "T1".
std::string mirroredName(const std::string& name) {
    const std::string mark = "-mirrored";
    if (name.size() > mark.size() && name.ends_with(mark)) return name.substr(0, name.size() - mark.size());
    return name + mark;
}

Result<void> mirrorClip(const ClipsMirrorArguments& options) {
    if (auto free = checkFree(options.out, options.force); !free) return free;
    const auto source = readMappedClip(options.in, options.import);
    if (!source) return tl::unexpected(source.error());
    return writeClip(motion::mirrored(source->clip, source->map), options.out);
}

/// Where the image of a clip goes: under its own folder inside the manifest's, or beside the manifest.
fs::path imageFile(const std::string& clip) {
    fs::path folder = fs::path(clip).lexically_normal().parent_path();
    if (folder.is_absolute() || (!folder.empty() && *folder.begin() == "..")) folder.clear();
    return folder / (mirroredName(clipStem(clip)) + ".bvh");
}

Result<void> mirrorManifest(const ClipsMirrorArguments& options) {
    const auto manifest = assets::readManifest(options.in);
    if (!manifest) return tl::unexpected(manifest.error());
    const fs::path home = fs::absolute(manifest->file).parent_path();
    std::error_code code;
    if (fs::equivalent(home, options.out, code))
        return fail(options.out, "is the folder of the manifest itself",
                    "Put mirrored clips in another folder");

    OutputFolder folder(options.out, options.force);
    std::vector<fs::path> names{"manifest.csv"};
    for (const assets::ManifestRow& row : manifest->rows) names.push_back(imageFile(row.clip));
    if (auto free = folder.expect(names); !free) return free;
    std::map<std::string, fs::path> done;  // by the source's name
    std::vector<assets::ManifestRow> rows = manifest->rows;
    auto working = std::make_optional<ElapsedOnTerminal>("mirroring");
    for (assets::ManifestRow& row : rows) {
        const auto [image, is_new] = done.emplace(row.clip, imageFile(row.clip));
        if (is_new) {
            const auto source = readMappedClip(home / row.clip, options.import);
            if (!source) return tl::unexpected(source.error());
            const auto bytes = clipBytes(motion::mirrored(source->clip, source->map), image->second);
            if (!bytes) return tl::unexpected(bytes.error());
            if (auto added = folder.add(image->second, *bytes); !added) return added;
        }
        row.clip = image->second.generic_string();
        row.target_id = mirroredName(row.target_id);
        if (row.target) row.target = motion::mirrored(*row.target);
        if (row.phases) row.phases->hand = motion::opposite(row.phases->hand);
    }
    working.reset();
    if (auto added = folder.add("manifest.csv", assets::manifestCsv(rows)); !added) return added;
    if (auto finished = folder.finish(); !finished) return finished;
    fmt::print("{} rows mirrored: {}\n", rows.size(), (fs::path(options.out) / "manifest.csv").string());
    return {};
}

Result<void> mirror(const ClipsMirrorArguments& options) {
    // Joint positions are .csv, as manifests are; what is asked for tells which of them is meant.
    const bool manifest = fs::path(options.in).extension() == ".csv" && !isClipFile(options.out);
    return manifest ? mirrorManifest(options) : mirrorClip(options);
}

}  // namespace

void addClipsMirrorCommand(Parser clips, Command& chosen) {
    auto options = std::make_shared<ClipsMirrorArguments>();
    Parser command =
        clips.addCommand("mirror", "Mirror a clip, or all clips of a manifest: left becomes right");
    describe(command, {.writes = "the clip, or the clips of a manifest and their manifest.csv to a folder.",
                       .example = "deixis clips mirror T001.bvh -o T001-mirrored.bvh\ndeixis clips mirror "
                                  "clips/manifest.csv -o mirrored",
                       .page = "docs/segmentation.md"});
    command.addOption("IN", options->in, "Clip file, or a manifest").required();
    addOutputLast(command, options->out,
                  "File for the mirrored clip: .bvh, .glb or .csv; for a manifest, the folder for its clips")
        .required();
    addForce(command, options->force);
    addImportOptions(command, options->import);
    command.callback([options, &chosen] { chosen = [options] { return mirror(*options); }; });
}

}  // namespace deixis::app
