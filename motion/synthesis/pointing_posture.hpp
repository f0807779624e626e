// The posture in which a body points at something: trunk, head, arm, hand and eyes.
#pragma once

#include "motion/synthesis/demonstration_parameters.hpp"
#include "pointing_body.hpp"

namespace deixis::motion {

/// What a posture is made for. Trunk and head angles are those of the body's own joints; zero leaves them.
struct PostureRequest {
    Side hand = Side::right;
    Vec3 aim{0.0};             ///< where the line through the fingertip goes
    double origin_k = 0.0;     ///< the line starts at (1-k) eye + k shoulder
    double extension = 0.985;  ///< shoulder to fingertip over the straight arm's length
    double index_alignment = 1.0;
    double wrist_limit_rad = 0.0;
    double knuckle_limit_rad = 0.0;
    double swivel_offset_rad = 0.0;
    double palm_inward_rad = 0.0;
    double torso_yaw_rad = 0.0;    ///< positive to the left
    double torso_pitch_rad = 0.0;  ///< positive forward
    double torso_roll_rad = 0.0;   ///< positive to the right
    double head_yaw_rad = 0.0;     ///< relative to the torso
    double head_pitch_rad = 0.0;   ///< positive downward
    double shoulder_raise_share = 0.0;
    double shoulder_forward_rad = 0.0;
};

/// Fingertip on the line, elbow where Soechting & Flanders put it, palm down, index finger turned towards the
/// aim as far as wrist and `index_alignment` allow. The eyes stay at rest: they follow the head in motion.
[[nodiscard]] LocalPose solvePosture(const PointingBody& body, const PostureRequest& request,
                                     const ArmPostureParameters& arm);

/// Turns the head (neck and head joints) of a pose.
void turnHead(const PointingBody& body, LocalPose& pose, const Quat& torso_from_head);

/// The rotation (w not negative), or as much of it as turns by the limit.
[[nodiscard]] Quat turnedAtMost(const Quat& rotation, double limit_rad);

/// Azimuth (0 along +z, positive to the left) and elevation of a direction, radians.
[[nodiscard]] double azimuthOf(const Vec3& direction);
[[nodiscard]] double elevationOf(const Vec3& direction);

}  // namespace deixis::motion
