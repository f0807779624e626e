// deixis clips joints: the joints of a clip and where they are.
#include <fmt/format.h>

#include <memory>

#include "app/program/command_help.hpp"
#include "assets/joints/joint_positions.hpp"
#include "clips_commands.hpp"
#include "import_options.hpp"

namespace deixis::app {

namespace {

struct ClipsJointsArguments {
    std::string file;
    bool csv = false;
    assets::ImportOptions import;
};

Result<void> printJoints(const ClipsJointsArguments& options) {
    const auto file = assets::importClip(options.file, options.import);
    if (!file) return tl::unexpected(file.error());
    if (options.csv) {
        fmt::print("{}", assets::writeJointCsv(file->clip));
        return {};
    }
    fmt::print("{}\n", assets::describe(*file));
    const auto& joints = file->clip.skeleton.joints;
    for (const auto& joint : joints)
        fmt::print(
            "{}{}\n", joint.name,
            joint.parent < 0 ? std::string() : "  <- " + joints[static_cast<std::size_t>(joint.parent)].name);
    return {};
}

}  // namespace

void addClipsJointsCommand(Parser clips, Command& chosen) {
    auto options = std::make_shared<ClipsJointsArguments>();
    Parser joints =
        clips.addCommand("joints", "List the joints of a clip; with --csv print their world positions");
    describe(joints, {.writes = "nothing; it prints the joints.",
                      .example = "deixis clips joints take.bvh --csv > positions.csv",
                      .page = "docs/clip-format.md"});
    joints.addOption("FILE", options->file, clip_file_kinds).required();
    joints.addFlag("--csv", options->csv,
                   "Print the world positions of every joint in every frame as CSV, in metres");
    addImportOptions(joints, options->import);
    joints.callback([options, &chosen] { chosen = [options] { return printJoints(*options); }; });
}

}  // namespace deixis::app
