#include "avatar_poser.hpp"

#include <algorithm>

namespace deixis::studies {

AvatarPoser::AvatarPoser(const motion::Skeleton& skeleton, const motion::LocalPose& start)
    : skeleton_(skeleton), pose_(start), from_(start) {}

void AvatarPoser::standAt(const Vec3& place) {
    changed_ = changed_ || place_ != place;
    place_ = place;
}

void AvatarPoser::blendTo(const motion::LocalPose& goal, double now_s) {
    from_.joints = pose_.joints;
    goal_ = &goal;
    blend_start_s_ = now_s;
}

void AvatarPoser::show(const motion::Clip& clip, double clip_time_s) {
    goal_ = nullptr;
    motion::sample(clip, clip_time_s, pose_);
    changed_ = true;
}

void AvatarPoser::advance(double now_s) {
    if (goal_ == nullptr) return;
    const double t = std::clamp((now_s - blend_start_s_) / blend_s, 0.0, 1.0);
    const double eased = t * t * (3.0 - 2.0 * t);
    for (std::size_t j = 0; j < pose_.joints.size(); ++j)
        pose_.joints[j] = motion::interpolate(from_.joints[j], goal_->joints[j], eased);
    if (t >= 1.0) {
        pose_.joints = goal_->joints;
        goal_ = nullptr;
    }
    changed_ = true;
}

void AvatarPoser::write(std::vector<Pose>& stage_from_joint) {
    if (!changed_ && !stage_from_joint.empty()) return;
    motion::worldPose(skeleton_, pose_, stage_from_joint);
    for (Pose& joint : stage_from_joint) joint.position += place_;
    changed_ = false;
}

}  // namespace deixis::studies
