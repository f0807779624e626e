#include "environments.hpp"

#include <algorithm>
#include <cmath>

#include "motion/skeleton/kinematics.hpp"
#include "physics/figure/figure_pose.hpp"
#include "physics/figure/mjcf.hpp"
#include "task_reward.hpp"

namespace deixis::learning {

namespace {

constexpr double fallen_m = 0.25;  ///< below where the pelvis should be

}  // namespace

Environments::Environments(const physics::Body& body, const std::vector<ReferenceMotion>& references,
                           const AmpSettings& settings, std::uint64_t seed)
    : references_(references),
      settings_(settings),
      observer_(body.figure()),
      bodies_(static_cast<std::size_t>(settings.environments), body),
      plays_(bodies_.size()),
      random_(seed, "environments") {
    restart(seed);
}

void Environments::restart(std::uint64_t seed) {
    random_ = Random(seed, "environments");
    for (std::size_t i = 0; i < plays_.size(); ++i) begin(i);
}

std::size_t Environments::seenSize() const {
    return observer_.stateSize() + physics::BodyObserver::goalSize(settings_.variant.policy_phase);
}

void Environments::begin(std::size_t body) {
    Play& play = plays_[body];
    play.reference = &references_[random_.below(references_.size())];
    play.control = random_.below(play.reference->controls());
    Vec3 target_m = play.reference->target_m;
    for (int axis = 0; axis < 3; ++axis)
        target_m[axis] += random_.uniform(-settings_.target_spread_m, settings_.target_spread_m);
    play.balls_m = ballsAround(settings_.task, target_m, random_);
    const auto states = static_cast<std::size_t>(settings_.discriminator_window - 1);
    play.past.resize(states * stateSize());
    for (std::size_t i = 0; i < states; ++i) {
        const std::size_t back = states - 1 - i;
        bodies_[body].setState(play.reference->states[play.control - std::min(back, play.control)]);
        observer_.writeState(bodies_[body], std::span(play.past).subspan(i * stateSize(), stateSize()));
    }
}

void Environments::seeOne(std::size_t body, std::span<float> out) {
    const Play& play = plays_[body];
    const std::span<float> state = out.first(observer_.stateSize());
    observer_.writeState(bodies_[body], state);
    physics::PolicyGoal goal{play.balls_m.front(), play.reference->hand, {}};
    if (settings_.variant.policy_phase) goal.phase = play.reference->phase(play.control);
    observer_.writeGoal(bodies_[body].root(), state, goal, out.subspan(observer_.stateSize()));
}

void Environments::see(std::span<float> out) {
    for (std::size_t i = 0; i < count(); ++i) seeOne(i, out.subspan(i * seenSize(), seenSize()));
}

double Environments::reward(const physics::Body& body, const Play& play) {
    const physics::Figure& figure = body.figure();
    pose_ = play.reference->base[play.control];
    physics::applyRoot(figure, body.root().pose, pose_);
    physics::applyAngles(figure, body.angles_rad(), pose_);
    const auto world = motion::worldPose(figure.skeleton, pose_);
    return taskReward(settings_.task, figure.skeleton, figure.map, world, play.reference->hand, play.balls_m);
}

double Environments::power_w(const physics::Body& body, std::span<const double> targets_rad) const {
    const auto angles = body.angles_rad(), speeds = body.speeds_rad_s();
    double out = 0.0;
    for (std::size_t i = 0; i < targets_rad.size(); ++i) {
        const physics::Hinge& hinge = body.figure().hinges[i];
        const double pull = std::clamp(hinge.stiffness_nm_rad * (targets_rad[i] - angles[i]),
                                       -hinge.max_torque_nm, hinge.max_torque_nm);
        out += std::abs((pull - hinge.damping_nms_rad * speeds[i]) * speeds[i]);
    }
    return out;
}

Environments::Step Environments::step(std::size_t index, std::span<const double> targets_rad,
                                      std::span<float> after) {
    Play& play = plays_[index];
    physics::Body& body = bodies_[index];
    const ReferenceMotion& reference = *play.reference;
    Step out;
    out.phase = reference.phase(play.control);
    body.step(targets_rad, physics::steps_per_control);
    ++play.control;
    out.fallen = body.root().pose.position.y < reference.states[play.control].root.pose.position.y - fallen_m;
    const double share = reference.holdIsOver(play.control) ? settings_.task_after_hold : 1.0;
    out.task_reward = share * reward(body, play);
    out.task_at_best = share * motion::highest_pointing_reward;
    out.ended = out.fallen || play.control == reference.controls();
    if (settings_.power_penalty > 0.0) out.power_w = power_w(body, targets_rad);
    seeOne(index, after);
    std::shift_left(play.past.begin(), play.past.end(), static_cast<std::ptrdiff_t>(stateSize()));
    std::ranges::copy(after.first(stateSize()), play.past.end() - static_cast<std::ptrdiff_t>(stateSize()));
    if (out.ended) begin(index);
    return out;
}

}  // namespace deixis::learning
