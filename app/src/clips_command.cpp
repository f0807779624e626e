// deixis clips: looking into clip files.
#include <fmt/format.h>

#include <iterator>
#include <memory>

#include "clip_files.hpp"
#include "commands.hpp"
#include "motion/skeleton.hpp"

namespace deixis::app {

namespace {

struct Options {
    std::string file;
    bool csv = false;
    double metres_per_unit = 0.0;
};

void appendPoint(std::string& row, const Vec3& p) {
    fmt::format_to(std::back_inserter(row), ",{:.6f},{:.6f},{:.6f}", p.x, p.y, p.z);
}

Result<void> printJoints(const Options& options) {
    assets::BvhOptions read;
    if (options.metres_per_unit > 0.0) read.metres_per_unit = options.metres_per_unit;
    const auto file = readClipFile(options.file, read);
    if (!file) return tl::unexpected(file.error());
    const motion::Clip& clip = file->clip;
    if (!options.csv) {
        fmt::print("{}\n", file->description);
        for (const auto& joint : clip.skeleton.joints)
            fmt::print("{}{}\n", joint.name,
                       joint.parent < 0
                           ? std::string()
                           : "  <- " + clip.skeleton.joints[static_cast<std::size_t>(joint.parent)].name);
        return {};
    }
    std::string row = "frame,time";
    for (const auto& joint : clip.skeleton.joints) {
        fmt::format_to(std::back_inserter(row), ",{0}.x,{0}.y,{0}.z", joint.name);
        if (joint.end_site)
            fmt::format_to(std::back_inserter(row), ",{0}_End.x,{0}_End.y,{0}_End.z", joint.name);
    }
    fmt::print("{}\n", row);
    std::vector<Pose> world;
    for (int f = 0; f < clip.frameCount(); ++f) {
        motion::worldPose(clip.skeleton, clip.frames[static_cast<std::size_t>(f)], world);
        row = fmt::format("{},{:.6f}", f, f * clip.frame_time_s);
        for (int j = 0; j < clip.skeleton.size(); ++j) {
            appendPoint(row, world[static_cast<std::size_t>(j)].position);
            if (clip.skeleton.joints[static_cast<std::size_t>(j)].end_site)
                appendPoint(row, motion::tipPosition(clip.skeleton, world, j));
        }
        fmt::print("{}\n", row);
    }
    return {};
}

}  // namespace

void addClipsCommand(CLI::App& cli, Command& chosen) {
    CLI::App* clips = cli.add_subcommand("clips", "Look into clip files");
    clips->require_subcommand(1);
    auto options = std::make_shared<Options>();
    CLI::App* joints =
        clips->add_subcommand("joints", "The joints of a clip; with --csv their world positions");
    joints->add_option("FILE", options->file, "BVH file (also .bvh.gz) or Kinect v2 CSV")->required();
    joints->add_flag("--csv", options->csv, "World positions of every joint in every frame, metres");
    joints->add_option("--metres-per-unit", options->metres_per_unit, "Length of a BVH unit [detected]")
        ->check(CLI::PositiveNumber);
    joints->callback([options, &chosen] { chosen = [options] { return printJoints(*options); }; });
}

}  // namespace deixis::app
