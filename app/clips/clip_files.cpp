#include "app/clips/clip_files.hpp"

#include <glm/geometric.hpp>
#include <vector>

#include "assets/tables/humanoid_file.hpp"
#include "motion/pointing/placement.hpp"
#include "motion/retarget/retarget.hpp"
#include "motion/skeleton/clip_edit.hpp"

namespace deixis::app {

namespace {

// For each joint of the avatar, the clip's joint of the same name; empty where the clip is on another
// skeleton.
std::vector<int> sameSkeletonOrder(const motion::Skeleton& clip, const motion::Skeleton& avatar) {
    if (clip.size() != avatar.size()) return {};
    std::vector<int> order;
    for (const motion::Joint& joint : avatar.joints) {
        const int index = clip.find(joint.name);
        if (index < 0) return {};
        const motion::Joint& other = clip.joints[static_cast<std::size_t>(index)];
        // The root's offset is free: its position comes with every frame.
        if (joint.parent >= 0 && glm::length(other.rest.position - joint.rest.position) > 1e-4) return {};
        order.push_back(index);
    }
    return order;
}

Error inFile(Error error, const std::string& file) {
    if (error.where.empty()) error.where = file;
    return error;
}

}  // namespace

Result<motion::HumanoidMapping> mapImported(const assets::ImportedClip& imported,
                                            const std::filesystem::path& file) {
    return assets::mapClip(file, imported.clip.skeleton, imported.humanoid ? &*imported.humanoid : nullptr);
}

Result<MappedClip> readMappedClip(const std::filesystem::path& file, const assets::ImportOptions& options) {
    auto imported = assets::importClip(file, options);
    if (!imported) return tl::unexpected(imported.error());
    const auto mapping = mapImported(*imported, file);
    if (!mapping) return tl::unexpected(mapping.error());
    return MappedClip{std::move(imported->clip), mapping->map};
}

bool isOnAvatar(const motion::Clip& clip, const assets::Avatar& avatar) {
    return !sameSkeletonOrder(clip.skeleton, avatar.skeleton).empty();
}

void standByTarget(motion::Clip& clip, const motion::HumanoidMap& map, assets::TargetFrame frame) {
    if (frame == assets::TargetFrame::figure)
        clip = motion::moved(clip, motion::figureOnFloorFromClip(clip, map));
}

Result<motion::Clip> clipOnAvatar(const assets::ImportedClip& imported, const std::string& file,
                                  const assets::Avatar& avatar, const motion::RetargetOptions& options,
                                  motion::RetargetReport* report) {
    const motion::Clip& clip = imported.clip;
    const std::vector<int> order = sameSkeletonOrder(clip.skeleton, avatar.skeleton);
    if (order.empty()) {
        const auto mapping = mapImported(imported, file);
        if (!mapping) return tl::unexpected(mapping.error());
        auto retargeted =
            motion::retarget(clip, mapping->map, avatar.skeleton, avatar.humanoid, options, report);
        if (!retargeted) return tl::unexpected(inFile(retargeted.error(), file));
        return retargeted;
    }
    if (options.gesture)
        if (const auto checked = motion::checkPhases(*options.gesture, clip.frameCount()); !checked)
            return tl::unexpected(inFile(checked.error(), file));
    motion::Clip out;
    out.skeleton = avatar.skeleton;
    out.frame_time_s = clip.frame_time_s;
    out.frames.resize(clip.frames.size());
    for (std::size_t f = 0; f < clip.frames.size(); ++f) {
        out.frames[f].joints.reserve(order.size());
        for (const int index : order)
            out.frames[f].joints.push_back(clip.frames[f].joints[static_cast<std::size_t>(index)]);
    }
    if (report != nullptr && options.gesture)
        report->source_error = report->avatar_error =
            motion::pointingError(out, avatar.humanoid, *options.gesture);
    return out;
}

}  // namespace deixis::app
