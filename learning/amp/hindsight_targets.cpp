#include "hindsight_targets.hpp"

#include <glm/geometric.hpp>

#include "motion/skeleton/kinematics.hpp"
#include "task_reward.hpp"

namespace deixis::learning {

std::vector<motion::Demonstration> withHindsightTargets(std::vector<motion::Demonstration> demonstrations,
                                                        AmpTask task) {
    const auto kind = rayOf(task);
    if (!kind) return demonstrations;
    for (motion::Demonstration& one : demonstrations) {
        const motion::GeneratedClip& made = one.gesture;
        const motion::Skeleton& skeleton = made.clip.skeleton;
        const auto middle = static_cast<std::size_t>((made.peak_frame + made.hold_frame) / 2);
        const auto world = motion::worldPose(skeleton, made.clip.frames[middle]);
        const Ray ray =
            motion::pointingRay(skeleton, motion::mapByVrmNames(skeleton), world, made.hand, *kind);
        one.target = ray.origin + glm::distance(one.target, ray.origin) * glm::normalize(ray.direction);
    }
    return demonstrations;
}

}  // namespace deixis::learning
