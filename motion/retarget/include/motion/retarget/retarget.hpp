// Retargeting any humanoid clip to the avatar: from another skeleton's rotations, or from joint positions
// alone.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/humanoid/mapping.hpp"
#include "motion/skeleton/clip.hpp"
#include "motion/skeleton/gesture_phases.hpp"

namespace deixis::motion {

/// What a retargeted pointing gesture keeps where the arms' lengths differ.
enum class Keep : unsigned char {
    joint_angles,  ///< every limb points as in the source
    pointing_ray,  ///< while it points, the ray from the eye over the fingertip misses the target as the
                   ///< source's
};
[[nodiscard]] std::string_view keepName(Keep keep);  ///< "joint-angles" or "pointing-ray"
[[nodiscard]] std::optional<Keep> keepFromName(std::string_view name);

/// When a clip's hand points, and at what.
struct PointingGesture : GesturePhases {
    /// In the clip's coordinates, metres. None: not known.
    std::optional<Vec3> target{};
};

struct RetargetOptions {
    Keep keep = Keep::joint_angles;  ///< a pointing ray is kept only where there is a gesture
    std::optional<PointingGesture> gesture{};
    /// Where the source has no fingers, the pointing hand closes with the index finger out while it points;
    /// else it is relaxed.
    bool close_hand = false;
    /// Feet that stand are kept in their place and out of the floor; else legs move as in the source.
    bool plant_feet = true;
};

/// Angle between the pointing ray (eye to fingertip, on from there) and the target, peak to hold, degrees.
struct PointingError {
    double median_deg = 0.0;
    double max_deg = 0.0;
};

/// How feet that stand moved, before and after they were planted. A foot stands while its heel or ball is
/// low and slow.
struct PlantedFeet {
    double standing_share = 0.0;  ///< of the frames, mean of both feet
    double before_m_s = 0.0;      ///< mean horizontal speed of standing feet
    double after_m_s = 0.0;
    double lowest_before_m = 0.0;  ///< height of the soles' lowest point in the clip
    double lowest_after_m = 0.0;
};

struct RetargetReport {
    double scale = 1.0;  ///< avatar hip height over the source's
    std::vector<std::string> remarks;
    PlantedFeet feet{};                           ///< where feet were planted
    std::optional<PointingError> source_error{};  ///< where a gesture has a target
    std::optional<PointingError> avatar_error{};
};

/// The clip played by the avatar: upright, facing its own way round, feet planted on the floor; rest poses
/// are corrected (T, A, arms down, z up) by aligning bone directions. A clip with a target stays where it
/// stands, since the target does. `avatar` is a T-pose
/// skeleton without rest rotations. Fails if the source lacks the bones that a humanoid needs, naming
/// them, and where a gesture ends after the clip.
[[nodiscard]] Result<Clip> retarget(const Clip& source, const HumanoidMap& source_map, const Skeleton& avatar,
                                    const HumanoidMap& avatar_map, const RetargetOptions& options = {},
                                    RetargetReport* report = nullptr);

/// The error of a clip's gesture, by pointingRay() from the eye over the fingertip; none if the gesture
/// has no target or ends after the clip.
[[nodiscard]] std::optional<PointingError> pointingError(const Clip& clip, const HumanoidMap& map,
                                                         const PointingGesture& gesture);

/// Where a person's joints were at one moment: metres, y up, facing anywhere. The neck is the point between
/// the shoulders.
struct BonePositions {
    std::array<std::optional<Vec3>, bone_count> at{};

    [[nodiscard]] const std::optional<Vec3>& operator[](Bone bone) const {
        return at[static_cast<std::size_t>(bone)];
    }
    std::optional<Vec3>& operator[](Bone bone) { return at[static_cast<std::size_t>(bone)]; }
};

/// The clip of an avatar (as for retarget) that holds its bones as the positions say. Bone lengths are the
/// avatar's. What positions do not tell is chosen so: limbs twist as the plane of elbow or knee says, and
/// little where they are straight; the head is level on the mean; hands rest, but for fingers
/// that every frame knows.
/// A whole person is levelled, so that it stands upright on the mean; feet stay flat, and in every frame one
/// is on the floor. Every frame must know hips, neck, head and the bones of both arms (to the hand) and legs
/// (to the foot).
/// An upper body, where no frame knows any bone of the legs: legs and hips stay as they stand at rest, at the
/// origin and facing +z; the whole is turned about the vertical so that the shoulders face +z on the mean; it
/// is not levelled, for nothing tells a lean from a tilted camera. Every frame must know neck, head, the
/// bones of both arms, and spine or hips, from where the chest rises to the neck. Fails naming what is
/// missing.
[[nodiscard]] Result<Clip> clipFromPositions(const std::vector<BonePositions>& frames, double frame_time_s,
                                             const Skeleton& avatar, const HumanoidMap& avatar_map,
                                             RetargetReport* report = nullptr);

}  // namespace deixis::motion
