// The body as a description: an avatar's bones as rigid segments with masses, hinges with limits, and
// actuators; and which pose of the avatar is which set of joint angles. Plain data: no simulation.
//
// A segment's frame is at its joint, its axes those of the avatar in the T pose, in which all angles are 0:
// x to the avatar's left, y up, z ahead. Three hinges in one place are a joint that turns every way: the
// first turns in the parent's frame, each next one in the frame of the one before.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "motion/skeleton/skeleton.hpp"
#include "physics/figure/de_leva.hpp"

namespace deixis::physics {

/// How the body stands.
enum class Stance : unsigned char {
    pinned,  ///< the pelvis is held, and there are no legs: 14 degrees of freedom
    free     ///< on its feet, on a floor: 28, and the 6 of the pelvis
};

/// An axis about which a joint turns, with its actuator: torque = stiffness (target - angle) - damping speed,
/// the first term at most `max_torque_nm`. Limits are ranges of movement of the American Academy of
/// Orthopaedic Surgeons (Joint Motion: Method of Measuring and Recording, 1965) but where hinges.cpp says
/// otherwise.
struct Hinge {
    std::string name;  ///< such as "left elbow flexion"
    Vec3 axis{0.0};    ///< of unit length, where all angles are 0
    double min_rad = 0.0;
    double max_rad = 0.0;
    double stiffness_nm_rad = 0.0;
    double damping_nms_rad = 0.0;
    double max_torque_nm = 0.0;
    double armature_kg_m2 = 0.0;  ///< inertia of the joint itself
};

/// A capsule from one point to another, or a box about the middle between them.
struct Shape {
    Vec3 from_m{0.0};
    Vec3 to_m{0.0};
    double radius_m = 0.0;
    Vec3 half_box_m{0.0};  ///< all 0: a capsule
};

/// A joint of the avatar that shares in a segment's turn; the shares of a segment add up to 1.
struct TurningJoint {
    std::size_t joint = 0;
    double share = 0.0;
};

struct Segment {
    std::string name;       ///< such as "left forearm"
    int parent = -1;        ///< index, smaller than its own; -1: the pelvis
    Vec3 joint_m{0.0};      ///< in the parent's frame; of the pelvis, where the avatar's hips are
    std::size_t bone = 0;   ///< the avatar's joint that it is at the end of
    std::size_t first = 0;  ///< of its hinges among the figure's
    std::size_t count = 0;  ///< 0 (fixed to its parent), 1 or 3
    MassProperties mass;
    Shape shape;
    std::vector<TurningJoint> turning{};  ///< from the trunk outwards; the last is `bone`
};

struct Figure {
    motion::Skeleton skeleton;  ///< the avatar's
    motion::HumanoidMap map;
    Stance stance = Stance::pinned;
    double stature_m = 0.0;
    double mass_kg = 0.0;  ///< of the whole person, with what `stance` leaves out
    std::vector<Segment> segments;
    std::vector<Hinge> hinges;

    /// Index of a segment by its name; throws where there is none.
    [[nodiscard]] std::size_t segment(std::string_view name) const;
    [[nodiscard]] std::size_t hinge(std::string_view name) const;
};

/// A body for any avatar in the T pose that faces +z, without rest rotations, its bones with VRM names.
/// Needs hips, head, arms to the hands and legs to the feet. Stature is told by the height of the head's
/// joint over the ankles, as they are in Deixis's own avatar.
[[nodiscard]] Result<Figure> makeFigure(const motion::Skeleton& avatar, Stance stance);

}  // namespace deixis::physics
