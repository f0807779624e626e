#include "skin_weights.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "motion/humanoid/reference_humanoid.hpp"
#include "shapes.hpp"

namespace deixis::avatar_maker {

namespace {

using motion::Bone;
using enum motion::Bone;

const std::vector<Pose>& restWorld() {
    static const auto world =
        motion::worldPose(motion::referenceHumanoid(), motion::restPose(motion::referenceHumanoid()));
    return world;
}
Vec3 place(Bone bone) {
    return restWorld()[static_cast<std::size_t>(bone)].position;
}
Vec3 tip(Bone bone) {
    return motion::tipPosition(motion::referenceHumanoid(), restWorld(), static_cast<int>(bone));
}

/// Weights by bone. They start as one at the root; each joint takes over a share of its parent's weight from
/// a soft border on, so that they sum to one and never leave a bone's own branch.
class Weights {
  public:
    Weights() { weight_[static_cast<std::size_t>(hips)] = 1.0; }

    void pass(Bone from, Bone to, double share) {
        const double moved = weight_[static_cast<std::size_t>(from)] * share;
        weight_[static_cast<std::size_t>(from)] -= moved;
        weight_[static_cast<std::size_t>(to)] += moved;
    }
    [[nodiscard]] const std::array<double, motion::bone_count>& values() const { return weight_; }

  private:
    std::array<double, motion::bone_count> weight_{};
};

/// 0 before the joint, 1 beyond it, along `direction` (unit length).
double beyond(const Vec3& p, const Vec3& joint, const Vec3& direction, double before, double after) {
    return smoothStep(-before, after, glm::dot(p - joint, direction));
}

double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
    return roundCone(p, a, b, 0.0, 0.0);
}

void legs(const Vec3& p, Weights& w) {
    const double left_share = smoothStep(-0.022, 0.022, p.x);
    const Vec3 q(std::abs(p.x), p.y, p.z);
    const double thigh = beyond(q, place(leftUpperLeg), glm::normalize(Vec3(0.20, -1.0, 0.0)), 0.045, 0.085);
    w.pass(hips, leftUpperLeg, left_share * thigh);
    w.pass(hips, rightUpperLeg, (1.0 - left_share) * thigh / (1.0 - left_share * thigh + 1e-12));
    const double shin = beyond(q, place(leftLowerLeg), {0, -1, 0}, 0.055, 0.055);
    const double foot = smoothStep(-0.135, -0.075, -q.y);
    const double toes = beyond(q, place(leftToes), {0, 0, 1}, 0.025, 0.02);
    w.pass(leftUpperLeg, leftLowerLeg, shin);
    w.pass(rightUpperLeg, rightLowerLeg, shin);
    w.pass(leftLowerLeg, leftFoot, foot);
    w.pass(rightLowerLeg, rightFoot, foot);
    w.pass(leftFoot, leftToes, toes);
    w.pass(rightFoot, rightToes, toes);
}

void trunk(const Vec3& p, Weights& w) {
    w.pass(hips, spine, smoothStep(0.955, 1.085, p.y));
    w.pass(spine, chest, smoothStep(1.085, 1.205, p.y));
    w.pass(chest, upperChest, smoothStep(1.205, 1.32, p.y));
    const double in_neck = 1.0 - smoothStep(0.075, 0.125, std::abs(p.x));
    w.pass(upperChest, neck, in_neck * smoothStep(1.425, 1.500, p.y + 0.25 * (p.z + 0.02)));
    const double above_jaw = 0.85 * (p.y - 1.530) + 0.5 * std::max(p.z - 0.005, 0.0);
    w.pass(neck, head, in_neck * smoothStep(-0.020, 0.022, above_jaw));
}

/// Shares of one hand's weight among its fingers; what is left stays with the palm.
void fingers(const Vec3& q, bool left, double hand_weight, Weights& w) {
    if (hand_weight <= 0.0) return;
    struct Chain {
        Bone first, second, third;
    };
    static constexpr std::array<Chain, 5> chains{{
        {leftThumbMetacarpal, leftThumbProximal, leftThumbDistal},
        {leftIndexProximal, leftIndexIntermediate, leftIndexDistal},
        {leftMiddleProximal, leftMiddleIntermediate, leftMiddleDistal},
        {leftRingProximal, leftRingIntermediate, leftRingDistal},
        {leftLittleProximal, leftLittleIntermediate, leftLittleDistal},
    }};
    const auto closeness = [](double distance) {
        const double d2 = distance * distance + 1e-7;
        return 1.0 / (d2 * d2 * d2);
    };
    std::array<double, 5> near{};
    double all = 0.0;
    for (std::size_t i = 0; i < chains.size(); ++i) {
        const Chain& c = chains[i];
        const double distance = std::min({distanceToSegment(q, place(c.first), place(c.second)),
                                          distanceToSegment(q, place(c.second), place(c.third)),
                                          distanceToSegment(q, place(c.third), tip(c.third))});
        near[i] = closeness(distance);
        all += near[i];
        if (i > 0) all += 0.4 * closeness(distanceToSegment(q, place(leftHand), place(c.first)));
    }
    double left_over = 1.0;
    for (std::size_t i = 0; i < chains.size(); ++i) {
        const Chain& c = chains[i];
        const auto bone = [&](Bone b) { return left ? b : mirroredBone(b); };
        const Vec3 first = glm::normalize(place(c.second) - place(c.first));
        const Vec3 second = glm::normalize(place(c.third) - place(c.second));
        const Vec3 third = glm::normalize(tip(c.third) - place(c.third));
        const bool thumb = i == 0;
        const double start = thumb ? beyond(q, place(c.first), first, 0.004, 0.022)
                                   : beyond(q, place(c.first), first, 0.010, 0.008);
        const double share = near[i] / all * start;
        w.pass(bone(leftHand), bone(c.first), left_over > 1e-9 ? std::min(share / left_over, 1.0) : 0.0);
        left_over -= share;
        w.pass(bone(c.first), bone(c.second), beyond(q, place(c.second), second, 0.0075, 0.0065));
        w.pass(bone(c.second), bone(c.third), beyond(q, place(c.third), third, 0.006, 0.005));
    }
}

void arms(const Vec3& p, Weights& w) {
    const bool left = p.x > 0.0;
    const auto bone = [&](Bone b) { return left ? b : mirroredBone(b); };
    const Vec3 q(std::abs(p.x), p.y, p.z);
    const double shoulder = 0.85 * smoothStep(0.035, 0.150, q.x) * smoothStep(1.270, 1.400, q.y);
    w.pass(upperChest, bone(leftShoulder), shoulder);
    const double upper_arm =
        beyond(q, place(leftUpperArm), glm::normalize(Vec3(1.0, 0.12, 0.0)), 0.058, 0.055);
    for (const Bone b : {hips, spine, chest, upperChest, bone(leftShoulder)})
        w.pass(b, bone(leftUpperArm), upper_arm);
    w.pass(bone(leftUpperArm), bone(leftLowerArm), beyond(q, place(leftLowerArm), {1, 0, 0}, 0.042, 0.042));
    const double hand = beyond(q, place(leftHand), {1, 0, 0}, 0.024, 0.018);
    w.pass(bone(leftLowerArm), bone(leftHand), hand);
    fingers(q, left, hand, w);
}

}  // namespace

SkinWeights skinWeightsAt(const Vec3& p) {
    Weights w;
    if (p.y < 1.1 && std::abs(p.x) < 0.4) legs(p, w);
    trunk(p, w);
    arms(p, w);

    std::array<std::size_t, motion::bone_count> order;
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto& value = w.values();
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return value[a] != value[b] ? value[a] > value[b] : a < b;
    });
    const double sum = value[order[0]] + value[order[1]] + value[order[2]] + value[order[3]];
    SkinWeights out;
    constexpr int whole = 1024;
    int left_over = whole;
    for (std::size_t i = 4; i-- > 0;) {
        int share = i == 0 ? left_over : static_cast<int>(std::lround(value[order[i]] / sum * whole));
        left_over -= share;
        out.weights[i] = static_cast<float>(share) / static_cast<float>(whole);
        out.joints[i] = share > 0 ? static_cast<std::uint8_t>(order[i]) : std::uint8_t{0};
    }
    return out;
}

}  // namespace deixis::avatar_maker
