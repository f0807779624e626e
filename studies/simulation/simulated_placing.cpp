#include "simulated_placing.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "studies/observers/observer_cues.hpp"

namespace deixis::studies {

namespace {

constexpr double near_enough_m = 0.02;
constexpr int max_drags = 3;
constexpr double depth_m = 2.0;  ///< from where the line begins
constexpr double depth_sd_m = 0.25;
constexpr double lowest_m = 0.1;

}  // namespace

BallPlacer::BallPlacer(const ObserverModel& model, std::uint64_t seed)
    : model_(model), placing_(seed, "placing") {}

void BallPlacer::forget() {
    believed_.reset();
    farther_m_ = 0.0;
    drags_ = 0;
}

bool BallPlacer::plan(const PresentedFrame& frame, const SeenArm& arm, SimulatedHand& hand, double at_s) {
    if (!believed_) {
        const Ray& line = arm.lines.line;
        const AcrossRay across = acrossRay(line.direction);
        const double right_rad =
            model_.noise_rad * placing_.normal();  // drawn in this order by every compiler
        const double above_rad = model_.noise_rad * placing_.normal();
        const Vec3 direction = glm::normalize(line.direction + std::tan(right_rad) * across.right +
                                              std::tan(above_rad) * across.above);
        const double along_m = std::max(0.5, depth_m + depth_sd_m * placing_.normal());
        believed_ = line.origin + along_m * direction;
        believed_->y = std::max(believed_->y, lowest_m);
    }
    const Vec3 at = frame.balls[0].centre;
    if (glm::length(*believed_ - at) < near_enough_m || drags_ == max_drags) return false;
    ++drags_;
    const Ray from = aimAtBall(frame, 0);
    const Ray to{from.origin, glm::normalize(*believed_ - from.origin)};
    farther_m_ = glm::length(*believed_ - from.origin) - glm::dot(at - from.origin, from.direction);
    hand.drag(from, to, at, at_s);  // who presses looks at what is pressed
    return true;
}

double BallPlacer::farther_m(const SimulatedHand& hand, const InputFrame& input) {
    return hand.dragging() && !input.select ? std::exchange(farther_m_, 0.0) : 0.0;
}

}  // namespace deixis::studies
