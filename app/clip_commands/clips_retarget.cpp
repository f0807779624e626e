// deixis clips retarget: a folder of clips on an avatar.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/clips/clip_retargeting.hpp"
#include "app/clips/study_setup.hpp"
#include "app/program/command_help.hpp"
#include "app/program/command_options.hpp"
#include "clips_commands.hpp"

namespace deixis::app {

namespace {

struct ClipsRetargetArguments {
    std::string manifest;
    std::string folder;
    std::string keep = "joint-angles";
    std::string avatar;
    std::string fingers = "relaxed";
    std::string feet = "planted";
    bool force = false;
};

void printRow(const assets::ManifestRow& row, const motion::RetargetReport& report) {
    fmt::print("{}", row.clip);
    if (report.source_error && report.avatar_error)
        fmt::print("  pointing error {:.2f} deg (at most {:.2f}), on the avatar {:.2f} (at most {:.2f})",
                   report.source_error->median_deg, report.source_error->max_deg,
                   report.avatar_error->median_deg, report.avatar_error->max_deg);
    if (report.feet.standing_share > 0.0)
        fmt::print("  feet slide {:.1f} mm/s, were {:.1f}", 1000.0 * report.feet.after_m_s,
                   1000.0 * report.feet.before_m_s);
    fmt::print("\n");
    for (const std::string& remark : report.remarks) fmt::print("    {}\n", remark);
}

/// Errors of source and avatar that differ by more are counted apart: the target is nearer than the
/// avatar's arm can point at as the source does, or angles were to be kept.
constexpr double much_deg = 2.0;

Result<void> retargetAll(const ClipsRetargetArguments& options) {
    const auto manifest = assets::readManifest(options.manifest);
    if (!manifest) return tl::unexpected(manifest.error());
    const auto avatar = loadAvatarOrShipped(options.avatar);
    if (!avatar) return tl::unexpected(avatar.error());
    const RetargetSettings settings{*motion::keepFromName(options.keep), options.fingers == "pointing",
                                    options.feet == "planted"};
    double apart_deg = 0.0;
    std::size_t compared = 0;
    std::size_t far_apart = 0;
    double farthest_deg = 0.0;
    std::string farthest;
    const auto rows =
        retargetClips(*manifest, *avatar, settings, options.folder, options.force,
                      [&](const assets::ManifestRow& row, const motion::RetargetReport& report) {
                          printRow(row, report);
                          if (!row.source_error_deg || !row.avatar_error_deg) return;
                          const double difference = std::abs(*row.avatar_error_deg - *row.source_error_deg);
                          ++compared;
                          if (difference <= much_deg) {
                              apart_deg = std::max(apart_deg, difference);
                              return;
                          }
                          ++far_apart;
                          if (difference <= farthest_deg) return;
                          farthest_deg = difference;
                          farthest = row.clip;
                      });
    if (!rows) return tl::unexpected(rows.error());
    fmt::print("{} clips and manifest.csv in {}\n", rows->size(), options.folder);
    if (compared > far_apart)
        fmt::print("pointing error of source and avatar: at most {:.2f} deg apart on {} of {} clips\n",
                   apart_deg, compared - far_apart, compared);
    if (far_apart > 0)
        fmt::print("more than {:.0f} deg apart: {} of {} clips, most of all {}, by {:.1f} deg\n", much_deg,
                   far_apart, compared, farthest, farthest_deg);
    return {};
}

}  // namespace

void addClipsRetargetCommand(Parser clips, Command& chosen) {
    auto options = std::make_shared<ClipsRetargetArguments>();
    Parser command =
        clips.addCommand("retarget", "Retarget the clips of a manifest to an avatar, as BVH files");
    describe(command, {.writes = "a BVH file for each clip and manifest.csv to DIR; all of them or none.",
                       .example = "deixis clips retarget clips/manifest.csv -o on-avatar --keep pointing-ray",
                       .page = "docs/clip-format.md"});
    command.addOption("MANIFEST", options->manifest, "CSV, see docs/manifest.md").required();
    addOutput(command, options->folder, "Folder for the clips and their manifest", "DIR").required();
    addForce(command, options->force);
    command.addOption("--keep", options->keep, "What retargeting keeps of a pointing arm")
        .check(OneOf{{"joint-angles", "pointing-ray"}})
        .showDefault();
    command.addOption("--avatar", options->avatar, "A humanoid glTF or VRM file [Deixis's own avatar]");
    command.addOption("--fingers", options->fingers, "Hands of figures without fingers while they point")
        .check(OneOf{{"relaxed", "pointing"}})
        .showDefault();
    command.addOption("--feet", options->feet, "Whether planted feet are held in place")
        .check(OneOf{{"planted", "free"}})
        .showDefault();
    command.callback([options, &chosen] { chosen = [options] { return retargetAll(*options); }; });
}

}  // namespace deixis::app
