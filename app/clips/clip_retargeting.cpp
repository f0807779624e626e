#include "app/clips/clip_retargeting.hpp"

#include <fmt/format.h>

#include "app/clips/clip_files.hpp"
#include "app/clips/clip_output.hpp"
#include "assets/joints/bvh.hpp"
#include "motion/pointing/placement.hpp"

namespace deixis::app {

namespace fs = std::filesystem;

std::optional<motion::PointingGesture> gestureOf(const assets::ManifestRow& row) {
    if (!row.phases) return std::nullopt;
    return motion::PointingGesture{*row.phases, row.target};
}

Result<motion::Clip> retargetRow(assets::ImportedClip clip, const std::string& file,
                                 const assets::Avatar& avatar, const RetargetSettings& settings,
                                 assets::ManifestRow& row, motion::RetargetReport* report) {
    if (row.target) {
        const auto mapping = mapImported(clip, file);
        if (!mapping) return tl::unexpected(mapping.error());
        standByTarget(clip.clip, mapping->map, row.target_frame);
        row.target_frame = assets::TargetFrame::clip;
        if (motion::standsAway(clip.clip, mapping->map))
            return fail(
                file,
                "begins half a metre or more from the origin, or faces away from +z, and its target is "
                "given in its coordinates: an avatar points from the origin",
                "Where the target is given from the figure, as it stands in the first frame, say so in "
                "the manifest: target_frame is figure");
    }
    motion::RetargetOptions options;
    options.keep = settings.keep;
    options.close_hand = settings.close_hand;
    options.plant_feet = settings.plant_feet;
    options.gesture = gestureOf(row);
    motion::RetargetReport made;
    auto out = clipOnAvatar(clip, file, avatar, options, &made);
    if (!out) return out;
    const auto median = [](const std::optional<motion::PointingError>& error) {
        return error ? std::optional<double>(error->median_deg) : std::nullopt;
    };
    row.source_error_deg = median(made.source_error);
    row.avatar_error_deg = median(made.avatar_error);
    row.fps = out->framesPerSecond();
    if (report != nullptr) *report = std::move(made);
    return out;
}

Result<std::vector<assets::ManifestRow>> retargetClips(
    const assets::Manifest& manifest, const assets::Avatar& avatar, const RetargetSettings& settings,
    const fs::path& folder, bool force,
    const std::function<void(const assets::ManifestRow&, const motion::RetargetReport&)>& each) {
    OutputFolder output(folder, force);
    const auto names = output.expectClipsOf(manifest);
    if (!names) return tl::unexpected(names.error());
    std::vector<assets::ManifestRow> rows;
    for (assets::ManifestRow row : manifest.rows) {
        const fs::path file = manifest.file.parent_path() / row.clip;
        const auto read = assets::importClip(file);
        if (!read) return tl::unexpected(read.error());
        motion::RetargetReport report;
        const auto clip = retargetRow(*read, file.string(), avatar, settings, row, &report);
        if (!clip) return tl::unexpected(clip.error());
        row.clip = (*names)[rows.size()].string();
        if (auto added = output.add(row.clip, assets::writeBvh(*clip)); !added)
            return tl::unexpected(added.error());
        each(row, report);
        rows.push_back(std::move(row));
    }
    if (auto added = output.add("manifest.csv", assets::manifestCsv(rows)); !added)
        return tl::unexpected(added.error());
    if (auto finished = output.finish(); !finished) return tl::unexpected(finished.error());
    return rows;
}

}  // namespace deixis::app
