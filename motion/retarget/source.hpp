// The figure that a clip is retargeted from; private to retargeting.
#pragma once

#include <vector>

#include "assembly.hpp"

namespace deixis::motion {

/// A pose of the source in which it stands about upright and straight: what the avatar's T pose is aligned
/// to.
struct Neutral {
    std::vector<Pose> world;
    BodyShape shape;
    bool is_rest;
};

/// How well a figure stands: 6 with legs and trunk in one line, the thighs side by side.
[[nodiscard]] double standing(const BodyShape& shape);

/// Frames of a clip by bones. What holds for the clip as a whole is taken from 200 frames spread over it.
class Source {
  public:
    Source(const Clip& clip, const HumanoidMap& map);

    struct Look {
        std::size_t frame;
        std::vector<Pose> world;
        BodyShape shape;
    };
    [[nodiscard]] const std::vector<Look>& looks() const { return looks_; }
    [[nodiscard]] const Clip& clip() const { return clip_; }
    [[nodiscard]] const HumanoidMap& map() const { return map_; }

    /// The rest pose, if it is that of a standing figure. Some rigs' rest is a heap of bones; then the frame
    /// in which the figure stands best.
    [[nodiscard]] Neutral neutral() const;

    /// The axis that is up in the motion: y, unless the figure on the whole rises along another axis, and its
    /// rest too (else it lies down).
    [[nodiscard]] Vec3 upAxis(const Neutral& neutral) const;

    /// Many CMU conversions carry a T pose in front of the motion.
    [[nodiscard]] bool startsWithAddedPose() const;

    /// World poses of the joints that play a bone, and of those above them, with the whole figure turned
    /// about the origin; other joints, and where thumbs, middle, ring and little fingers are, are left as
    /// they are.
    void place(std::size_t frame, const Quat& turn, std::vector<Pose>& world) const;

  private:
    const Clip& clip_;
    const HumanoidMap& map_;
    struct Needed {
        std::size_t index;
        int parent;
        bool placed;  // its position is asked for
    };
    std::vector<Needed> needed_;  // joints, parents first
    std::vector<Look> looks_;
};

}  // namespace deixis::motion
