#include "clip_files.hpp"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <vector>

#include "assets/joint_positions.hpp"
#include "motion/retarget.hpp"

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

}  // namespace

Result<ClipFile> readClipFile(const std::filesystem::path& path, const assets::BvhOptions& options) {
    if (path.extension() == ".csv") {
        auto clip = assets::readKinectClip(path);
        if (!clip) return tl::unexpected(clip.error());
        std::string description = fmt::format("Kinect v2 joint positions, {} frames at {:.4g} fps",
                                              clip->frameCount(), clip->framesPerSecond());
        return ClipFile{std::move(*clip), std::move(description)};
    }
    auto bvh = assets::readBvh(path, options);
    if (!bvh) return tl::unexpected(bvh.error());
    std::string description =
        fmt::format("BVH, unit {}, {} joints, {} frames at {:.4g} fps", bvh->unit, bvh->clip.skeleton.size(),
                    bvh->clip.frameCount(), bvh->clip.framesPerSecond());
    return ClipFile{std::move(bvh->clip), std::move(description)};
}

Result<motion::Clip> clipOnAvatar(const motion::Clip& clip, const assets::Avatar& avatar,
                                  const std::string& name) {
    const std::vector<int> order = sameSkeletonOrder(clip.skeleton, avatar.skeleton);
    if (order.empty()) {
        auto retargeted =
            motion::retarget(clip, motion::detectHumanoid(clip.skeleton), avatar.skeleton, avatar.humanoid);
        if (!retargeted && retargeted.error().where.empty()) {
            Error error = retargeted.error();
            error.where = name;
            return tl::unexpected(error);
        }
        return retargeted;
    }
    motion::Clip out;
    out.skeleton = avatar.skeleton;
    out.frame_time_s = clip.frame_time_s;
    out.frames.resize(clip.frames.size());
    for (std::size_t f = 0; f < clip.frames.size(); ++f) {
        out.frames[f].joints.reserve(order.size());
        for (const int index : order)
            out.frames[f].joints.push_back(clip.frames[f].joints[static_cast<std::size_t>(index)]);
    }
    return out;
}

}  // namespace deixis::app
