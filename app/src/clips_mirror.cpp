// deixis clips mirror: a clip, or all of a manifest's, with left and right exchanged.
#include <fmt/format.h>

#include <map>
#include <memory>

#include "assets/manifest.hpp"
#include "clip_files.hpp"
#include "clip_output.hpp"
#include "clips_commands.hpp"
#include "import_options.hpp"
#include "motion/clip_edit.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

struct ClipsMirrorArguments {
    std::string in;
    std::string out;
    std::string folder;
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
    const auto source = readMappedClip(options.in, options.import);
    if (!source) return tl::unexpected(source.error());
    return writeClip(motion::mirrored(source->clip, source->map), options.out, options.force);
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
    if (fs::equivalent(home, options.folder, code))
        return fail(options.folder, "is the folder of the manifest itself",
                    "Mirrored clips go to a folder of their own");

    OutputFolder folder(options.folder, options.force);
    std::map<std::string, fs::path> done;  // by the source's name
    std::vector<assets::ManifestRow> rows = manifest->rows;
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
    if (auto added = folder.add("manifest.csv", assets::manifestCsv(rows)); !added) return added;
    if (auto finished = folder.finish(); !finished) return finished;
    fmt::print("{} rows mirrored: {}\n", rows.size(), (fs::path(options.folder) / "manifest.csv").string());
    return {};
}

Result<void> mirror(const ClipsMirrorArguments& options) {
    if (options.out.empty() == options.folder.empty())
        return fail("clips mirror", "expected either OUT for one clip or --out for a manifest's clips");
    return options.folder.empty() ? mirrorClip(options) : mirrorManifest(options);
}

}  // namespace

void addClipsMirrorCommand(CLI::App& clips, Command& chosen) {
    auto options = std::make_shared<ClipsMirrorArguments>();
    CLI::App* command = clips.add_subcommand("mirror", "Exchange left and right: of a clip, or a manifest");
    command->add_option("IN", options->in, "Clip file; with --out a manifest")->required();
    CLI::Option* out = command->add_option("OUT", options->out, "The mirrored clip, BVH");
    command->add_option("--out", options->folder, "Folder for a manifest's mirrored clips and their manifest")
        ->excludes(out);
    addImportOptions(*command, options->import);
    command->add_flag("--force", options->force, "Replace what is there already");
    command->callback([options, &chosen] { chosen = [options] { return mirror(*options); }; });
}

}  // namespace deixis::app
