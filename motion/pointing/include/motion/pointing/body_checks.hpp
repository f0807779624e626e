// What a body cannot or should not do: sliding feet, joints beyond their range, limbs inside the body.
// Pure functions on world poses of a clip (worldPoses()) and its humanoid map.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "motion/skeleton/clip.hpp"

namespace deixis::motion {

/// Foot skate as in Zhang, Starke, Komura & Saito (2018), "Mode-adaptive neural networks for quadruped motion
/// control", section 8: v (2 - 2^(h/H)) with v the foot's horizontal speed, h its height above its lowest in
/// the clip, counted where h < H = 2.5 cm. The mean over frames and both feet, m/s: how far a foot on the
/// floor slides in a second. The point is the toes' joint, or the foot's if there are no toes. None
/// without both feet or for a single frame.
struct FootSkate {
    double speed_m_s = 0.0;
    double contact_share = 0.0;  ///< share of frames in which a foot is lower than H, mean of both feet
};
[[nodiscard]] std::optional<FootSkate> footSkate(const std::vector<std::vector<Pose>>& world,
                                                 const HumanoidMap& map, double frame_time_s);

/// Ranges of movement of the American Academy of Orthopaedic Surgeons (Joint Motion: Method of Measuring and
/// Recording, 1965), those that joint positions can tell, for both sides of the body.
enum class JointLimit : unsigned char {
    elbow_flexion,       ///< 0 (straight) to 150 degrees
    wrist_bend,          ///< forearm against hand, any way, to 80 (flexion, the widest of the wrist's)
    shoulder_extension,  ///< upper arm behind the plane of the trunk, to 60
    knee_flexion,        ///< to 135
    hip_flexion,         ///< thigh before the trunk's line, to 120
    trunk_rotation,      ///< line of the shoulders against that of the hips, to 45
    head_rotation,       ///< face against the shoulders' ahead, to 60 to either side
    head_tilt,           ///< face up or down against the trunk, to 45
};
constexpr std::size_t joint_limit_count = 8;
[[nodiscard]] std::string_view jointLimitName(JointLimit limit);  ///< "elbow flexion", ...
[[nodiscard]] double jointLimitDegrees(JointLimit limit);

struct LimitViolation {
    JointLimit limit = JointLimit::elbow_flexion;
    std::optional<Side> side{};  ///< none for trunk and head
    double max_deg = 0.0;        ///< by how much the limit is exceeded at most
    double share = 0.0;          ///< of the frames in which it is
    int frame = 0;               ///< of the largest excess
};
/// What is exceeded anywhere in the clip; what the skeleton lacks the bones for is not looked at.
[[nodiscard]] std::vector<LimitViolation> jointLimitViolations(const Skeleton& skeleton,
                                                               const HumanoidMap& map,
                                                               const std::vector<std::vector<Pose>>& world);

/// A capsule: all points within `radius_m` of a segment.
struct Capsule {
    Vec3 from{0.0};
    Vec3 to{0.0};
    double radius_m = 0.0;
};
/// Smallest distance between the two segments less the radii: below 0 by the depth of an overlap.
[[nodiscard]] double capsuleDistance(const Capsule& a, const Capsule& b);

/// Forearm and hand of either arm against trunk and head, all as capsules: forearm radius 4.0 cm and hand
/// 3.0 cm, trunk two capsules of 10 cm from the hip joints to half-way between neck and shoulder, head 9 cm
/// from the head joint upwards; sizes for a person of 1.75 m, scaled by the distance from hips to head. The
/// radii are ordinary adult breadths, rounded: a limb that touches clothes is not reported, one that is
/// inside the body is.
struct Intersection {
    Side side = Side::right;
    bool with_head = false;  ///< else with the trunk
    double depth_m = 0.0;    ///< the largest in the clip
    double share = 0.0;      ///< of the frames in which they overlap
    int frame = 0;           ///< of the largest depth
};
/// Pairs that overlap in some frame. Empty if the map lacks arms, legs, neck or head.
[[nodiscard]] std::vector<Intersection> selfIntersections(const Skeleton& skeleton, const HumanoidMap& map,
                                                          const std::vector<std::vector<Pose>>& world);

}  // namespace deixis::motion
