// Targets and their distractors (Deichler et al. 2023, section 2.4.3).
#pragma once

#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"
#include "studies/study.hpp"

namespace deixis::studies {

/// One target with its distractors; positions in the avatar's frame, metres, rounded to 0.1 mm so that they
/// are the same on every machine and survive printing.
struct TargetItem {
    std::string id;  ///< "T001", "T002", ...
    Vec3 target{0.0};
    std::vector<Vec3> distractors;
};

/// Draws space.count targets uniformly in height, arc and radius, and for each target its distractors from
/// the same ranges, redrawn until they lie within the distance band of the target and no nearer to each other
/// than a ball's diameter. Depends on space and seed alone. Fails with a clear error after a bounded search
/// where the ranges cannot be met.
[[nodiscard]] Result<std::vector<TargetItem>> sampleTargets(const TargetSpace& space, std::uint64_t seed);

/// "target_id,x,y,z,d1_x,d1_y,d1_z,d2_x,d2_y,d2_z" and a row each.
[[nodiscard]] std::string targetsCsv(const std::vector<TargetItem>& targets);

/// A picture like the paper's Figure 1: the targets (and, where given, the positions that a manifest's clips
/// were made for) in a perspective view and from above and the side. A whole SVG document.
[[nodiscard]] std::string targetsSvg(const TargetSpace& space, const std::vector<TargetItem>& targets,
                                     const std::vector<Vec3>& demonstrations);

}  // namespace deixis::studies
