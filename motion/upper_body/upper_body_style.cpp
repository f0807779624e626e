#include "motion/upper_body/upper_body_style.hpp"

namespace deixis::motion {

Result<std::vector<Style>> styleOf(const UpperBodyMotion& motion, int window) {
    std::vector<std::vector<Vec3>> positions(upper_joint_count);
    for (const UpperBodyPose& pose : motion.frames) {
        const UpperBodyJoints joints = jointsOf(pose);
        for (std::size_t j = 0; j < upper_joint_count; ++j) positions[j].push_back(joints[j]);
    }
    return styleOfPositions(positions, static_cast<std::size_t>(UpperJoint::left_wrist),
                            static_cast<std::size_t>(UpperJoint::right_wrist), window);
}

}  // namespace deixis::motion
