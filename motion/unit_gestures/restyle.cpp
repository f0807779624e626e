#include "motion/unit_gestures/restyle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace deixis::motion {

namespace {

constexpr int blend_frames = 7;           // half a second
constexpr double amplitude_rate = 0.2;    // e^(0.2 x 3) = 1.8
constexpr double hand_rate = 0.35;        // the other hand is down to a third at 3
constexpr double turn_deg = 8.0;          // a unit of space
constexpr double farthest_deg = 165.0;    // from hanging: beyond it an arm would swing round behind
constexpr double outward_while_deg = 20;  // an arm that hangs is not spread; so far from hanging it is

/// How much of each style a frame has: the mean of its neighbourhood.
struct Amounts {
    double speed = 0.0, space = 0.0, handedness = 0.0;
};

Amounts amountsAt(const std::vector<WantedStyle>& styles, int frame) {
    Amounts out;
    int count = 0;
    for (int i = frame - blend_frames / 2; i <= frame + blend_frames / 2; ++i) {
        if (i < 0 || i >= static_cast<int>(styles.size())) continue;
        const WantedStyle& style = styles[static_cast<std::size_t>(i)];
        out.speed += style.speed.value_or(0.0);
        out.space += style.space.value_or(0.0);
        out.handedness += style.handedness.value_or(0.0);
        ++count;
    }
    return {out.speed / count, out.space / count, out.handedness / count};
}

/// The direction `share` times as far from `from`.
Vec3 farther(const Vec3& from, const Vec3& direction, double share) {
    const double angle = angleBetween(from, direction);
    if (angle < 1e-6) return direction;
    const Vec3 axis = glm::cross(from, direction);
    if (glm::length(axis) < 1e-9) return direction;
    const double to = std::min(angle * share, std::max(angle, radiansFromDegrees(farthest_deg)));
    return glm::normalize(glm::angleAxis(to, glm::normalize(axis)) * from);
}

}  // namespace

UpperBodyMotion restyled(const UpperBodyMotion& motion, const std::vector<WantedStyle>& styles) {
    const UpperBodyPose& hanging = relaxedUpperBody();
    struct Arm {
        std::array<UpperBone, 2> bones;
        double outward;  // about z
        double handed;
    };
    const std::array<Arm, 2> arms{{{{UpperBone::left_upper_arm, UpperBone::left_forearm}, 1.0, 1.0},
                                   {{UpperBone::right_upper_arm, UpperBone::right_forearm}, -1.0, -1.0}}};
    UpperBodyMotion out = motion;
    for (std::size_t i = 0; i < out.frames.size(); ++i) {
        const Amounts amounts = amountsAt(styles, static_cast<int>(i));
        if (amounts.speed == 0.0 && amounts.space == 0.0 && amounts.handedness == 0.0) continue;
        for (const Arm& arm : arms) {
            const double other_hand = std::min(0.0, arm.handed * amounts.handedness);
            const double share = std::exp(amplitude_rate * amounts.speed + hand_rate * other_hand);
            for (const UpperBone bone : arm.bones) {
                Vec3& direction = out.frames[i][bone];
                const double away_deg = degreesFromRadians(angleBetween(hanging[bone], direction));
                const double turn =
                    arm.outward * amounts.space * turn_deg * std::min(1.0, away_deg / outward_while_deg);
                direction = farther(hanging[bone], direction, share);
                direction = glm::angleAxis(radiansFromDegrees(turn), Vec3(0, 0, 1)) * direction;
            }
        }
    }
    return out;
}

}  // namespace deixis::motion
