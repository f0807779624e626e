#include "physics/policy/observation.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string_view>

namespace deixis::physics {

namespace {

constexpr float speed_share = 0.1F;

/// The turn about the upright axis by which a pelvis faces where it does.
Quat headingOf(const Quat& pelvis) {
    const Vec3 ahead = pelvis * Vec3(0.0, 0.0, 1.0);
    return glm::angleAxis(std::atan2(ahead.x, ahead.z), Vec3(0.0, 1.0, 0.0));
}

/// Of unit length; shorter than it within a centimetre, where there is none.
Vec3 directionTo(const Vec3& there) {
    constexpr double near_m = 0.01;
    return there / std::max(near_m, glm::length(there));
}

/// Writes one after another.
class Numbers {
  public:
    explicit Numbers(std::span<float> out) : out_(out) {}
    void add(double number) { out_[at_++] = static_cast<float>(number); }
    void add(const Vec3& vector) {
        for (int i = 0; i < 3; ++i) add(vector[i]);
    }

  private:
    std::span<float> out_;
    std::size_t at_ = 0;
};

/// Of a segment's joint from the pelvis, where all angles are 0.
Vec3 placeOf(const Figure& figure, std::string_view name) {
    Vec3 out(0.0);
    for (int i = static_cast<int>(figure.segment(name)); i > 0;
         i = figure.segments[static_cast<std::size_t>(i)].parent)
        out += figure.segments[static_cast<std::size_t>(i)].joint_m;
    return out;
}

}  // namespace

BodyObserver::BodyObserver(const Figure& figure)
    : free_(figure.stance == Stance::free),
      hinges_(figure.hinges.size()),
      shoulders_m_{placeOf(figure, "left upper arm"), placeOf(figure, "right upper arm")} {
    // The elbows first: writeGoal() reads them.
    for (const char* name : {"left forearm", "right forearm", "left hand", "right hand", "head"})
        ends_.push_back(figure.segment(name));
    if (free_)
        for (const char* name : {"left foot", "right foot"}) ends_.push_back(figure.segment(name));
    state_size_ = 2 * hinges_ + 3 * ends_.size() + (free_ ? 1 + 6 + 6 : 0);
}

void BodyObserver::writeState(Body& body, std::span<float> out) const {
    Numbers numbers(out);
    for (const double angle : body.angles_rad()) numbers.add(angle);
    for (const double speed : body.speeds_rad_s()) numbers.add(static_cast<double>(speed_share) * speed);
    const RootState root = body.root();
    const Quat to_heading = glm::conjugate(headingOf(root.pose.orientation));
    const std::vector<Vec3> joints = body.jointPositions_m();
    for (const std::size_t end : ends_) numbers.add(to_heading * (joints[end] - root.pose.position));
    if (!free_) return;
    const Quat turn = to_heading * root.pose.orientation;
    numbers.add(root.pose.position.y);
    numbers.add(turn * Vec3(0.0, 1.0, 0.0));
    numbers.add(turn * Vec3(0.0, 0.0, 1.0));
    numbers.add(to_heading * root.velocity_m_s);
    numbers.add(static_cast<double>(speed_share) * (to_heading * root.angular_velocity_rad_s));
}

void BodyObserver::writeGoal(const RootState& root, std::span<const float> state, const PolicyGoal& goal,
                             std::span<float> out) const {
    Numbers numbers(out);
    const std::size_t side = goal.hand == motion::Side::left ? 0 : 1;
    const float* elbow = &state[2 * hinges_ + 3 * side];
    const Vec3 there =
        glm::conjugate(headingOf(root.pose.orientation)) * (goal.target_m - root.pose.position);
    numbers.add(directionTo(there - shoulders_m_[side]));
    numbers.add(directionTo(there - Vec3(elbow[0], elbow[1], elbow[2])));
    numbers.add(side == 0 ? 1.0 : -1.0);
    if (!goal.phase) return;
    numbers.add(std::sin(pi * *goal.phase));
    numbers.add(2.0 * *goal.phase - 1.0);
}

}  // namespace deixis::physics
