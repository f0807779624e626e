#include "hinges.hpp"

#include <glm/geometric.hpp>
#include <string_view>

#include "motion/skeleton/axes.hpp"
#include "physics/figure/mjcf.hpp"

namespace deixis::physics {

namespace {

using motion::Side;
using motion::x_axis;
using motion::y_axis;
using motion::z_axis;

/// From DeepMimic's humanoid (Peng, Abbeel, Levine & van de Panne 2018): its trunk, half of the stiffness and
/// damping of its neck, shoulder and elbow, and twice those of its legs. A standing body tips over on ankles
/// that are not clearly stiffer than its weight times the height of its centre, some 600 N m/rad. The
/// muscles' torques are that humanoid's (elbow 70 for 60; hip, knee and ankle twice). The damping is no
/// muscle's: what it takes at 8 rad/s, as fast as joints turn when people point, comes on top of them.
///
/// Floor and limits push segments that are light for such damping. MuJoCo finds their forces as if damping
/// were explicit, and a body rattles at them; with a tenth of damping times step as inertia of the joint
/// itself it comes to rest.
struct Actuator {
    double stiffness, damping, torque;
};
constexpr double fast_rad_s = 8.0;
constexpr double armature_share = 0.1;
constexpr Actuator trunk{1000.0, 100.0, 200.0};
constexpr Actuator neck{50.0, 5.0, 50.0};
constexpr Actuator shoulder{200.0, 20.0, 100.0};
constexpr Actuator elbow{150.0, 15.0, 70.0};
constexpr Actuator hip{1000.0, 100.0, 400.0};
constexpr Actuator knee{1000.0, 100.0, 300.0};
constexpr Actuator ankle{800.0, 80.0, 180.0};

/// Of the left side, or in the middle.
struct Turn {
    std::string_view name;
    Vec3 axis;
    double min_deg, max_deg;
};

Hinge hinge(std::string name, const Turn& turn, const Actuator& actuator) {
    return {std::move(name),
            turn.axis,
            radiansFromDegrees(turn.min_deg),
            radiansFromDegrees(turn.max_deg),
            actuator.stiffness,
            actuator.damping,
            actuator.torque + fast_rad_s * actuator.damping,
            armature_share * actuator.damping * step_s};
}

std::vector<Hinge> middle(std::string_view joint, const std::vector<Turn>& turns, const Actuator& actuator) {
    std::vector<Hinge> out;
    for (const Turn& turn : turns)
        out.push_back(hinge(std::string(joint) + " " + std::string(turn.name), turn, actuator));
    return out;
}

/// The right side is the left one's mirror image: with the same angles it mirrors its posture.
std::vector<Hinge> sided(Side side, std::string_view joint, const std::vector<Turn>& turns,
                         const Actuator& actuator) {
    std::vector<Hinge> out;
    for (Turn turn : turns) {
        if (side == Side::right) turn.axis = {turn.axis.x, -turn.axis.y, -turn.axis.z};
        out.push_back(hinge(
            std::string(motion::sideName(side)) + " " + std::string(joint) + " " + std::string(turn.name),
            turn, actuator));
    }
    return out;
}

}  // namespace

std::vector<Hinge> trunkHinges() {
    return middle("trunk",
                  {{"rotation", y_axis, -45.0, 45.0},  // to the left
                   {"flexion", x_axis, -25.0, 80.0},
                   {"bend", z_axis, -35.0, 35.0}},  // to the right
                  trunk);
}

std::vector<Hinge> neckHinges() {
    return middle(
        "neck",
        {{"rotation", y_axis, -60.0, 60.0}, {"flexion", x_axis, -45.0, 45.0}, {"bend", z_axis, -45.0, 45.0}},
        neck);
}

/// Three hinges stand badly where the second has turned by 90 degrees: the arm then lies along the first's
/// axis. So that one is tilted ahead by 30 degrees, where people do not point: its ends are steeply up ahead
/// and behind the hanging arm. Limits of such axes are not tabulated. They are: horizontal flexion 135 and
/// extension 45 about the first, as about an upright axis; up and down to 15 degrees from the first axis; and
/// for the turn about the arm 90 to either side, as elbow and shoulder share it, and an arm that is led round
/// turns about itself without its joint turning.
std::vector<Hinge> shoulderHinges(Side side, const Vec3& bone) {
    Vec3 along = glm::normalize(bone);
    if (side == Side::right) along.x = -along.x;  // of the left arm that it mirrors
    const double tilt = radiansFromDegrees(30.0);
    const Vec3 tilted{0.0, std::cos(tilt), std::sin(tilt)};
    const Vec3 upright = glm::normalize(tilted - glm::dot(tilted, along) * along);
    return sided(side, "shoulder",
                 {{"swing", -upright, -45.0, 135.0},  // ahead
                  {"raise", glm::cross(along, upright), -75.0, 75.0},
                  {"twist", -along, -90.0, 90.0}},  // outwards: palm up
                 shoulder);
}

/// Elbows and knees may be overstretched by 10 degrees.
std::vector<Hinge> elbowHinges(Side side) {
    return sided(side, "elbow", {{"flexion", -y_axis, -10.0, 150.0}}, elbow);
}

std::vector<Hinge> hipHinges(Side side) {
    return sided(side, "hip",
                 {{"flexion", -x_axis, -30.0, 120.0},
                  {"abduction", z_axis, -30.0, 45.0},
                  {"rotation", y_axis, -45.0, 45.0}},  // outwards
                 hip);
}

std::vector<Hinge> kneeHinges(Side side) {
    return sided(side, "knee", {{"flexion", x_axis, -10.0, 135.0}}, knee);
}

/// The turn about the shin is an assumption.
std::vector<Hinge> ankleHinges(Side side) {
    return sided(side, "ankle",
                 {{"dorsiflexion", -x_axis, -50.0, 20.0},
                  {"inversion", -z_axis, -15.0, 35.0},
                  {"rotation", y_axis, -20.0, 20.0}},
                 ankle);
}

}  // namespace deixis::physics
