#include "motion/synthesis/demonstration_library.hpp"

#include <utility>

#include "motion/skeleton/clip_edit.hpp"
#include "pointing_plan.hpp"

namespace deixis::motion {

Result<std::vector<Demonstration>> makeDemonstrations(const Skeleton& avatar,
                                                      const DemonstrationParameters& parameters) {
    const auto body = makePointingBody(avatar);
    if (!body) return tl::unexpected(body.error());
    std::vector<Demonstration> out;
    for (const DemonstrationPlan& plan : planLibrary(*body, parameters))
        out.push_back({plan.target, perform(*body, plan.motion, parameters, plan.seed)});
    return out;
}

Demonstration mirrored(const Demonstration& demonstration) {
    Demonstration out = demonstration;
    out.target = mirrored(out.target);
    out.gesture.hand = opposite(out.gesture.hand);
    Clip& clip = out.gesture.clip;
    const std::vector<int> partners = mirrorPartners(clip.skeleton);
    for (LocalPose& frame : clip.frames) frame = mirrored(clip.skeleton, partners, frame);
    return out;
}

std::vector<Demonstration> withMirrored(std::vector<Demonstration> demonstrations) {
    const std::size_t count = demonstrations.size();
    demonstrations.reserve(2 * count);
    for (std::size_t i = 0; i < count; ++i) demonstrations.push_back(mirrored(demonstrations[i]));
    return demonstrations;
}

}  // namespace deixis::motion
