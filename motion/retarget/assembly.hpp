// From bone rotations in the world to a clip of the avatar that stands where it should; private to
// retargeting.
#pragma once

#include <array>
#include <vector>

#include "alignment.hpp"
#include "motion/retarget/retarget.hpp"

namespace deixis::motion {

struct AvatarRest {
    const Skeleton& skeleton;
    const HumanoidMap& map;
    std::vector<Pose> world;
    BodyShape shape;
    TrunkAxes axes;
    double leg_length_m;  ///< hip joint to ankle along the bones
    /// For each bone the nearest bone above it in the skeleton (-1: none), and the way from there in the T
    /// pose.
    std::array<int, bone_count> above{};
    std::array<Vec3, bone_count> offset{};
    Vec3 hip_centre_from_hips{0.0};
};
[[nodiscard]] AvatarRest avatarRest(const Skeleton& skeleton, const HumanoidMap& map);

/// Thigh and shin, mean of both sides.
[[nodiscard]] double legLength(const BodyShape& shape);

struct BodyFrame {
    BoneTurns rotation;  ///< world rotation of each bone, y up
    Vec3 hip_centre;     ///< midpoint between the hip joints, at the avatar's scale, metres
};

using BoneSet = std::array<bool, bone_count>;

/// Share of the pointing in a frame: 0 up to the onset and from the end on, 1 from peak to hold, along a
/// minimum-jerk trajectory between.
[[nodiscard]] double pointingShare(const PointingGesture& gesture, int frame);

/// Body frames as poses of the avatar. Bones outside `driven` keep their rest; fingers the relaxed hand, or
/// where a hand closes the pointing one.
class BodyPoser {
  public:
    /// `closing`: the gesture while which the hand closes, or null. Both must outlive this.
    BodyPoser(const AvatarRest& avatar, const BoneSet& driven, const PointingGesture* closing);

    using Workspace = std::vector<Quat>;  ///< kept from frame to frame to save allocating it

    [[nodiscard]] LocalPose pose(const BodyFrame& body, int frame, Workspace& workspace) const;
    /// World rotation and position of a bone that the avatar has.
    [[nodiscard]] Quat rotation(const BodyFrame& body, int frame, Bone bone) const;
    [[nodiscard]] Vec3 position(const BodyFrame& body, int frame, Bone bone) const;
    /// Midpoint between the eyes, and the index finger's tip, as for pointingRay().
    [[nodiscard]] Vec3 eye(const BodyFrame& body, int frame) const;
    [[nodiscard]] Vec3 fingertip(const BodyFrame& body, int frame, Side side) const;

  private:
    [[nodiscard]] const Quat& handShape(std::size_t finger_bone, int frame) const;

    const AvatarRest& avatar_;
    const BoneSet& driven_;
    const PointingGesture* closing_;
    struct PosedJoint {
        int parent;
        std::size_t bone;  // bone_count: none
    };
    std::vector<PosedJoint> joints_;
    LocalPose relaxed_;
    /// Of each frame from the closing gesture's onset to its end, the pointing hand's fingers, thumb first.
    std::vector<std::array<Quat, 15>> closed_;
    LocalPose rest_;
};

/// Points of the avatar's soles, each at rest on the floor: under the ankle, under the ball of the foot
/// (where the toes begin; the foot's tip without toes), and under the tip of the toes.
struct Sole {
    Bone foot, toes;
    Vec3 heel{0.0};             ///< in the foot's frame, metres
    Vec3 ball{0.0};             ///< in the foot's frame
    std::optional<Vec3> tip{};  ///< in the toes' frame; none without toes
};
[[nodiscard]] Sole soleOf(const AvatarRest& avatar, Side side);

/// Of a frame the height of the soles' lowest point, metres.
[[nodiscard]] double soleHeight(const AvatarRest& avatar, const std::array<Sole, 2>& soles,
                                const BodyFrame& frame);

/// The height that the soles of a tenth of the frames lie below: a single foot driven into the floor does not
/// lift the whole clip.
struct FloorHeight {
    double floor = 0.0;
    double lowest = 0.0;  ///< of all frames
};
[[nodiscard]] FloorHeight floorHeight(const AvatarRest& avatar, const std::vector<BodyFrame>& frames);

/// Where the hips joint is.
[[nodiscard]] Vec3 hipsPosition(const AvatarRest& avatar, const BodyFrame& frame);

/// The turn about the vertical that makes a body face +z.
[[nodiscard]] Quat turnToFront(const BodyFrame& frame);

/// How the feet come to the floor: one shift for the clip, which keeps jumps; or one for each frame, for a
/// person who keeps a foot on the floor while the recorded height of the hips wavers.
enum class Ground : unsigned char { clip, frame };

/// Turns the motion so that its first frame faces +z with the hips over the origin, moves it up or down so
/// that the feet stand on the floor, and makes a clip of it.
[[nodiscard]] Clip assemble(const AvatarRest& avatar, std::vector<BodyFrame> frames, const BoneSet& driven,
                            Ground ground, double frame_time_s);

}  // namespace deixis::motion
