// What every clip that a reader gives must hold, however its bytes came about; a fuzzer stops where it does
// not.
#pragma once

#include <cmath>
#include <cstdlib>

#include "assets/joints/clip_import.hpp"

namespace deixis::fuzz {

inline void require(bool holds) {
    if (!holds) std::abort();
}

inline void checkClip(const Result<assets::ImportedClip>& imported) {
    if (!imported) {
        require(!imported.error().text().empty());
        return;
    }
    const motion::Clip& clip = imported->clip;
    require(!clip.frames.empty() && clip.frame_time_s > 0.0 && !clip.skeleton.joints.empty());
    for (int j = 0; j < clip.skeleton.size(); ++j)
        require(clip.skeleton.joints[static_cast<std::size_t>(j)].parent < j);
    for (const motion::LocalPose& frame : clip.frames) {
        require(frame.joints.size() == clip.skeleton.joints.size());
        for (const Pose& pose : frame.joints) {
            require(std::isfinite(pose.position.x) && std::isfinite(pose.position.y) &&
                    std::isfinite(pose.position.z));
            require(std::abs(glm::length(pose.orientation) - 1.0) < 1e-6);
        }
    }
}

}  // namespace deixis::fuzz
