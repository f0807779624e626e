// deixis clips map: which joint of a clip plays which humanoid bone.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "app/program/written_output.hpp"
#include "assets/joints/clip_import.hpp"
#include "assets/tables/humanoid_file.hpp"
#include "clips_commands.hpp"
#include "import_options.hpp"

namespace deixis::app {

namespace {

struct ClipsMapArguments {
    std::string file;
    bool json = false;
    bool toml = false;
};

const std::string& jointOf(const motion::HumanoidMapping& mapping, const motion::Skeleton& skeleton,
                           motion::Bone bone) {
    return skeleton.joints[static_cast<std::size_t>(mapping.map[bone])].name;
}

void printJson(const motion::HumanoidMapping& mapping, const motion::Skeleton& skeleton,
               const std::vector<std::string>& warnings) {
    nlohmann::ordered_json out;
    out["scheme"] = mapping.scheme;
    out["joints"] = skeleton.size();
    auto& bones = out["bones"] = nlohmann::ordered_json::object();
    for (std::size_t b = 0; b < motion::bone_count; ++b) {
        const auto bone = static_cast<motion::Bone>(b);
        if (mapping.map.has(bone))
            bones[std::string(motion::boneName(bone))] = {
                {"joint", jointOf(mapping, skeleton, bone)},
                {"found_by", std::string(motion::foundByName(mapping.foundBy(bone)))}};
    }
    auto& missing = out["missing"] = nlohmann::ordered_json::array();
    for (const motion::Bone bone : mapping.missing()) missing.push_back(std::string(motion::boneName(bone)));
    out["remarks"] = mapping.remarks;
    out["doubts"] = warnings;
    printAsJson(out);
}

void printTable(const motion::HumanoidMapping& mapping, const motion::Skeleton& skeleton,
                const std::vector<std::string>& warnings) {
    fmt::print("scheme: {}\n", mapping.scheme);
    std::size_t found = 0;
    for (std::size_t b = 0; b < motion::bone_count; ++b) {
        const auto bone = static_cast<motion::Bone>(b);
        if (!mapping.map.has(bone)) continue;
        ++found;
        fmt::print("{:<24} {:<32} by {}\n", motion::boneName(bone), jointOf(mapping, skeleton, bone),
                   motion::foundByName(mapping.foundBy(bone)));
    }
    fmt::print("{} of {} bones, out of {} joints\n", found, motion::bone_count, skeleton.size());
    std::string missing;
    for (const motion::Bone bone : mapping.missing())
        missing += fmt::format("{}{}", missing.empty() ? "" : ", ", motion::boneName(bone));
    if (!missing.empty()) fmt::print("missing: {}\n", missing);
    for (const std::string& remark : mapping.remarks) fmt::print("remark: {}\n", remark);
    for (const std::string& warning : warnings) fmt::print("doubt: {}\n", warning);
}

Result<void> printMap(const ClipsMapArguments& options) {
    const auto file = assets::importClip(options.file);
    if (!file) return tl::unexpected(file.error());
    const motion::Skeleton& skeleton = file->clip.skeleton;
    const auto mapping = assets::mapClip(options.file, skeleton, file->humanoid ? &*file->humanoid : nullptr);
    if (!mapping) return tl::unexpected(mapping.error());
    const auto warnings = motion::mappingWarnings(skeleton, mapping->map,
                                                  motion::worldPose(skeleton, file->clip.frames.front()));
    if (options.json)
        printJson(*mapping, skeleton, warnings);
    else if (options.toml)
        fmt::print("{}", assets::humanoidToml(*mapping, skeleton));
    else
        printTable(*mapping, skeleton, warnings);
    return {};
}

}  // namespace

void addClipsMapCommand(Parser clips, Command& chosen) {
    auto options = std::make_shared<ClipsMapArguments>();
    Parser map = clips.addCommand("map", "Show which joint of a clip is which humanoid bone");
    describe(map, {.writes = "nothing; it prints the mapping.",
                   .example = "deixis clips map take.bvh --toml > take.humanoid.toml",
                   .page = "docs/clip-format.md"});
    map.addOption("FILE", options->file, clip_file_kinds).required();
    Option json = addJson(map, options->json, "Print JSON");
    map.addFlag("--toml", options->toml, "Print a file NAME.humanoid.toml to edit and put beside the clip")
        .excludes(json);
    map.callback([options, &chosen] { chosen = [options] { return printMap(*options); }; });
}

}  // namespace deixis::app
