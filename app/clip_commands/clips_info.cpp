// deixis clips info: what a clip file holds, and how that was found out.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/clips/clip_files.hpp"
#include "app/clips/clip_problems.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/written_output.hpp"
#include "clips_commands.hpp"
#include "import_options.hpp"
#include "motion/skeleton/skeleton.hpp"

namespace deixis::app {

namespace {

struct ClipsInfoArguments {
    std::string file;
    bool json = false;
    assets::ImportOptions import;
};

// From the lowest to the highest joint or tip in the first frame, metres.
double heightOf(const motion::Clip& clip) {
    const auto world = motion::worldPose(clip.skeleton, clip.frames.front());
    double low = world.front().position.y;
    double high = low;
    for (int j = 0; j < clip.skeleton.size(); ++j)
        for (const double y : {world[static_cast<std::size_t>(j)].position.y,
                               motion::tipPosition(clip.skeleton, world, j).y}) {
            low = std::min(low, y);
            high = std::max(high, y);
        }
    return high - low;
}

struct BoneRow {
    std::string_view bone;
    std::string joint;
};

std::vector<BoneRow> bonesOf(const motion::Clip& clip, const motion::HumanoidMap& map) {
    std::vector<BoneRow> rows;
    for (std::size_t b = 0; b < motion::bone_count; ++b)
        if (const int joint = map.joint[b]; joint >= 0)
            rows.push_back({motion::boneName(static_cast<motion::Bone>(b)),
                            clip.skeleton.joints[static_cast<std::size_t>(joint)].name});
    return rows;
}

/// Who says which joint plays which bone.
enum class BonesBy : unsigned char { person, file, names };
BonesBy bonesBy(const assets::ImportedClip& imported, const motion::HumanoidMapping& mapping) {
    const bool person = std::find(mapping.found.begin(), mapping.found.end(), motion::FoundBy::override_) !=
                        mapping.found.end();
    return person ? BonesBy::person : imported.humanoid ? BonesBy::file : BonesBy::names;
}

void printJson(const std::string& file, const assets::ImportedClip& imported,
               const motion::HumanoidMapping& mapping) {
    const motion::Clip& clip = imported.clip;
    const motion::HumanoidMap& map = mapping.map;
    constexpr std::array origins{"given", "declared", "detected"};
    nlohmann::ordered_json bones = nlohmann::ordered_json::object();
    for (const BoneRow& row : bonesOf(clip, map)) bones[std::string(row.bone)] = row.joint;
    const nlohmann::ordered_json out{
        {"file", file},
        {"format", imported.format},
        {"joints", clip.skeleton.size()},
        {"frames", clip.frameCount()},
        {"duration_s", clip.duration_s()},
        {"frame_rate", {{"fps", imported.rate.fps}, {"origin", assets::originName(imported.rate.origin)}}},
        {"unit",
         {{"name", imported.unit.name},
          {"metres", imported.unit.metres},
          {"origin", assets::originName(imported.unit.origin)}}},
        {"up",
         {{"axis", assets::upAxisName(imported.up.axis)},
          {"origin", assets::originName(imported.up.origin)}}},
        {"height_m", heightOf(clip)},
        {"humanoid",
         {{"origin", origins[static_cast<std::size_t>(bonesBy(imported, mapping))]},
          {"bones", bones},
          {"missing", motion::missingBones(map)}}},
        {"remarks", imported.remarks}};
    // Names that are not UTF-8 get a replacement character.
    printAsJson(out);
}

void printText(const std::string& file, const assets::ImportedClip& imported,
               const motion::HumanoidMapping& mapping) {
    const motion::Clip& clip = imported.clip;
    const motion::HumanoidMap& map = mapping.map;
    constexpr std::array origins{"as the file beside it says", "declared", "by the joints' names"};
    const auto bones = bonesOf(clip, map);
    fmt::print("{}\n", file);
    fmt::print("  format   {}\n", imported.format);
    fmt::print("  joints   {}\n", clip.skeleton.size());
    fmt::print("  frames   {} at {:.6g} fps ({}), {:.3f} s\n", clip.frameCount(), imported.rate.fps,
               assets::originName(imported.rate.origin), clip.duration_s());
    fmt::print("  unit     {} ({}), {:.6g} m\n", imported.unit.name, assets::originName(imported.unit.origin),
               imported.unit.metres);
    fmt::print("  up       {} ({})\n", assets::upAxisName(imported.up.axis),
               assets::originName(imported.up.origin));
    fmt::print("  height   {:.2f} m in the first frame\n", heightOf(clip));
    const auto missing = motion::missingBones(map);
    fmt::print("  bones    {} of {} ({}){}\n", bones.size(), motion::bone_count,
               origins[static_cast<std::size_t>(bonesBy(imported, mapping))],
               missing.empty() ? "" : fmt::format("; required but missing: {}", fmt::join(missing, ", ")));
    for (const BoneRow& row : bones) fmt::print("           {:<24} {}\n", row.bone, row.joint);
    for (const std::string& remark : imported.remarks) fmt::print("  remark   {}\n", remark);
}

Result<void> info(const ClipsInfoArguments& options) {
    const auto imported = assets::importClip(options.file, options.import);
    if (!imported) return tl::unexpected(imported.error());
    const auto mapping = mapImported(*imported, options.file);
    if (!mapping) return tl::unexpected(mapping.error());
    if (options.json)
        printJson(options.file, *imported, *mapping);
    else
        printText(options.file, *imported, *mapping);
    return {};
}

}  // namespace

void addClipsInfoCommand(Parser clips, Command& chosen) {
    auto options = std::make_shared<ClipsInfoArguments>();
    Parser command = clips.addCommand(
        "info", "Show a clip's format, frames, rate, unit, up axis and bones, and how each was determined");
    describe(command, {.writes = "nothing; it prints what it found.",
                       .example = "deixis clips info clips/T001.bvh",
                       .page = "docs/clip-format.md"});
    command.addOption("FILE", options->file, clip_file_kinds).required();
    addJson(command, options->json, "Print JSON");
    addImportOptions(command, options->import);
    command.callback([options, &chosen] { chosen = [options] { return info(*options); }; });
}

}  // namespace deixis::app
