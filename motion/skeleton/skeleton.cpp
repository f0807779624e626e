#include "motion/skeleton/skeleton.hpp"

namespace deixis::motion {

namespace {

/// parent * local, as core/pose.hpp has it; here, where the compiler can unfold it: a session does this for
/// every joint in every frame.
Pose compose(const Pose& parent, const Pose& local) {
    return {parent.position + parent.orientation * local.position, parent.orientation * local.orientation};
}

}  // namespace

int Skeleton::find(std::string_view name) const {
    for (int i = 0; i < size(); ++i)
        if (joints[static_cast<std::size_t>(i)].name == name) return i;
    return -1;
}

LocalPose restPose(const Skeleton& skeleton) {
    LocalPose pose;
    pose.joints.reserve(skeleton.joints.size());
    for (const Joint& joint : skeleton.joints) pose.joints.push_back(joint.rest);
    return pose;
}

void worldPose(const Skeleton& skeleton, const LocalPose& pose, std::vector<Pose>& out) {
    out.resize(pose.joints.size());
    for (std::size_t i = 0; i < pose.joints.size(); ++i) {
        const int parent = skeleton.joints[i].parent;
        out[i] = parent < 0 ? pose.joints[i] : compose(out[static_cast<std::size_t>(parent)], pose.joints[i]);
    }
}

std::vector<Pose> worldPose(const Skeleton& skeleton, const LocalPose& pose) {
    std::vector<Pose> out;
    worldPose(skeleton, pose, out);
    return out;
}

HumanoidMap mapByVrmNames(const Skeleton& skeleton) {
    HumanoidMap map;
    for (int i = 0; i < skeleton.size(); ++i)
        if (const auto bone = boneFromName(skeleton.joints[static_cast<std::size_t>(i)].name)) map[*bone] = i;
    return map;
}

Vec3 tipPosition(const Skeleton& skeleton, const std::vector<Pose>& world, int joint) {
    const auto index = static_cast<std::size_t>(joint);
    const auto& end_site = skeleton.joints[index].end_site;
    return end_site ? transformPoint(world[index], *end_site) : world[index].position;
}

}  // namespace deixis::motion
