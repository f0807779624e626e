// An avatar's pose between and during clips.
#pragma once

#include <vector>

#include "motion/skeleton/clip.hpp"

namespace deixis::studies {

/// Holds a pose, plays a clip, or blends smoothly to another pose. Buffers are reused: no allocation per
/// frame. The skeleton, and every pose blended to, must outlive it.
class AvatarPoser {
  public:
    static constexpr double blend_s = 0.25;

    AvatarPoser(const motion::Skeleton& skeleton, const motion::LocalPose& start);

    void standAt(const Vec3& place);                            ///< on the floor; at first the origin
    void blendTo(const motion::LocalPose& goal, double now_s);  ///< takes blend_s from now
    void show(const motion::Clip& clip, double clip_time_s);    ///< ends a blend
    void advance(double now_s);                                 ///< continues with a blend, if one runs
    [[nodiscard]] bool blending() const { return goal_ != nullptr; }

    /// Writes stage_from_joint where the pose has changed since the last call.
    void write(std::vector<Pose>& stage_from_joint);

  private:
    const motion::Skeleton& skeleton_;
    motion::LocalPose pose_;
    motion::LocalPose from_;
    const motion::LocalPose* goal_ = nullptr;
    double blend_start_s_ = 0.0;
    Vec3 place_{0.0};
    bool changed_ = true;
};

}  // namespace deixis::studies
