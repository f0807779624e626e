#include "motion/unit_gestures/body_target.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "motion/pointing/two_bone_ik.hpp"
#include "motion/skeleton/axes.hpp"
#include "motion/skeleton/minimum_jerk.hpp"

namespace deixis::motion {

namespace {

Quat turnAbout(const Vec3& axis, double degrees) {
    return glm::angleAxis(radiansFromDegrees(degrees), axis);
}

double sideSign(Side side) {
    return side == Side::left ? 1.0 : -1.0;
}

struct ArmPlaces {
    UpperBone shoulder, upper_arm, forearm;
};
ArmPlaces placesOf(Side side) {
    using enum UpperBone;
    return side == Side::left ? ArmPlaces{left_shoulder, left_upper_arm, left_forearm}
                              : ArmPlaces{right_shoulder, right_upper_arm, right_forearm};
}

double lengthOf(UpperBone bone) {
    return upper_bones[static_cast<std::size_t>(bone)].length_m;
}

/// Where the elbow is by itself: below, a little behind and outwards of the line to the wrist.
Vec3 hangingElbow(Side side) {
    return {0.35 * sideSign(side), -1.0, -0.45};
}

Vec3 acrossLine(const Vec3& v, const Vec3& line) {
    const Vec3 along = glm::normalize(line);
    return v - glm::dot(v, along) * along;
}

ChannelValues relaxedHand(Side side) {
    const auto places = placesOf(side);
    const UpperBodyPose& pose = relaxedUpperBody();
    const Vec3 elbow = lengthOf(places.upper_arm) * pose[places.upper_arm];
    const Vec3 wrist = elbow + lengthOf(places.forearm) * pose[places.forearm];
    const Vec3 hanging = acrossLine(hangingElbow(side), wrist);
    const Vec3 found = acrossLine(elbow, wrist);
    const double swivel =
        std::atan2(glm::dot(glm::normalize(wrist), glm::cross(hanging, found)), glm::dot(hanging, found));
    const Vec3 share = wrist / mean_arm_m;
    return {sideSign(side) * share.x, share.y, share.z, sideSign(side) * degreesFromRadians(swivel)};
}

void layArm(UpperBodyPose& pose, Side side, const ChannelValues& hand, const Quat& trunk) {
    const double sign = sideSign(side);
    const auto places = placesOf(side);
    const TwoLinkArm arm{side, Vec3(sign * lengthOf(places.upper_arm), 0.0, 0.0),
                         Vec3(sign * lengthOf(places.forearm), 0.0, 0.0)};
    Vec3 wrist = mean_arm_m * Vec3(sign * hand[0], hand[1], hand[2]);
    constexpr double nearest_m = 0.02;  // nearer there is no direction
    if (glm::length(wrist) < nearest_m) wrist = Vec3(0.0, -nearest_m, 0.0);
    const Quat swivel = turnAbout(glm::normalize(wrist), sign * hand[3]);
    Vec3 elbow = acrossLine(hangingElbow(side), wrist);
    if (glm::length(elbow) < 1e-6) elbow = acrossLine(Vec3(sign, 0.0, 0.0), wrist);
    const ArmSolution solved = solveArm(arm, wrist, swivel * elbow);
    pose[places.upper_arm] = trunk * glm::normalize(solved.upper_arm * arm.elbow);
    pose[places.forearm] =
        trunk * glm::normalize(solved.upper_arm * (elbowRotation(side, solved.flexion_rad) * arm.tip));
}

/// The shoulder rises with a raised hand and draws ahead with one that reaches.
Vec3 shoulderOf(Side side, const ChannelValues& hand, double lift_deg) {
    constexpr double raise_deg = 14.0, draw_deg = 9.0;
    const double raised = std::clamp((hand[1] + 0.2) / 1.1, 0.0, 1.0);
    const double ahead = std::clamp((hand[2] - 0.5) / 0.5, 0.0, 1.0);
    const double sign = sideSign(side);
    return turnAbout(y_axis, -sign * draw_deg * minimumJerk(ahead)) *
           (turnAbout(z_axis, sign * (raise_deg * minimumJerk(raised) + lift_deg)) *
            relaxedUpperBody()[placesOf(side).shoulder]);
}

/// Of a straight way.
Vec3 nearestToShoulder(const Vec3& from, const Vec3& to) {
    const Vec3 way = to - from;
    const double squared = glm::dot(way, way);
    if (squared < 1e-12) return from;
    return from + std::clamp(-glm::dot(from, way) / squared, 0.0, 1.0) * way;
}

/// By which a key that is gone through is passed, per second; 0 where a stop is made.
ChannelValues speedAt(const ChannelKeys& keys, std::size_t i) {
    ChannelValues speed{};
    if (!keys[i].through || i == 0 || i + 1 == keys.size()) return speed;
    const double time_s = keys[i + 1].time_s - keys[i - 1].time_s;
    for (std::size_t v = 0; v < speed.size(); ++v)
        speed[v] = (keys[i + 1].values[v] - keys[i - 1].values[v]) / time_s;
    return speed;
}

}  // namespace

const BodyTarget& relaxedTarget() {
    static const BodyTarget target{relaxedHand(Side::right), relaxedHand(Side::left), {}, {}};
    return target;
}

UpperBodyPose poseOf(const BodyTarget& target) {
    const UpperBodyPose& relaxed = relaxedUpperBody();
    const auto& [yaw, lean, side_lean, lift] = target[indexOf(Channel::trunk)];
    const Quat lean_turn = turnAbout(x_axis, lean) * turnAbout(z_axis, side_lean);
    const Quat trunk = turnAbout(y_axis, yaw) * lean_turn;
    UpperBodyPose pose;
    pose[UpperBone::neck] = turnAbout(y_axis, yaw) * (lean_turn * relaxed[UpperBone::neck]);
    // The head keeps level, for the most part, while the trunk leans.
    constexpr double share_of_yaw = 0.6, share_of_lean = 0.6;
    const auto& head_values = target[indexOf(Channel::head)];
    const Quat head = turnAbout(y_axis, head_values[0] + share_of_yaw * yaw) *
                      turnAbout(x_axis, head_values[1] + share_of_lean * lean) *
                      turnAbout(z_axis, head_values[2] + share_of_lean * side_lean);
    pose[UpperBone::nose] = head * relaxed[UpperBone::nose];
    pose[UpperBone::head_top] = head * relaxed[UpperBone::head_top];
    for (const Side side : {Side::left, Side::right}) {
        const ChannelValues& hand = target[indexOf(handChannel(side))];
        pose[placesOf(side).shoulder] = trunk * shoulderOf(side, hand, lift);
        layArm(pose, side, hand, trunk);
    }
    for (Vec3& direction : pose.directions) direction = glm::normalize(direction);
    return pose;
}

Channel mirrored(Channel channel) {
    if (channel == Channel::right_hand) return Channel::left_hand;
    return channel == Channel::left_hand ? Channel::right_hand : channel;
}

ChannelValues mirrored(Channel channel, const ChannelValues& v) {
    if (channel == Channel::head) return {-v[0], v[1], -v[2], v[3]};
    if (channel == Channel::trunk) return {-v[0], v[1], -v[2], v[3]};
    return v;  // hands are written for their own side
}

ChannelValues valuesAt(const ChannelKeys& keys, double time_s) {
    const auto after = std::upper_bound(keys.begin(), keys.end(), time_s,
                                        [](double t, const ChannelKey& key) { return t < key.time_s; });
    if (after == keys.begin()) return keys.front().values;
    if (after == keys.end()) return keys.back().values;
    const auto i = static_cast<std::size_t>(after - keys.begin());
    const ChannelKey &from = keys[i - 1], &to = keys[i];
    const double way_s = to.time_s - from.time_s;
    const double u = (time_s - from.time_s) / way_s;
    const ChannelValues begin = speedAt(keys, i - 1), end = speedAt(keys, i);
    ChannelValues out{};
    for (std::size_t v = 0; v < out.size(); ++v)
        out[v] = from.values[v] + (to.values[v] - from.values[v]) * minimumJerk(u) +
                 way_s * (begin[v] * minimumJerkLeaving(u) + end[v] * minimumJerkArriving(u));
    return out;
}

HandWay handWay(const ChannelValues& from, const ChannelValues& to) {
    // The folded arm's wrist is 0.32 arm lengths from the shoulder.
    constexpr double nearest = 0.37;
    const Vec3 a(from[0], from[1], from[2]), b(to[0], to[1], to[2]);
    HandWay out{glm::length(b - a)};
    const Vec3 middle = nearestToShoulder(a, b);
    if (glm::length(middle) >= std::min({nearest, glm::length(a), glm::length(b)})) return out;
    // Before the body, or beside it where that is too near, too.
    double best = -1.0;
    Vec3 place(0.0);
    for (const Vec3& aside : {Vec3(0.05, -0.1, 0.4), Vec3(0.3, -0.1, 0.3), Vec3(0.5, 0.0, 0.1)})
        for (const double distance : {0.46, 0.6}) {
            const Vec3 tried = distance * glm::normalize(middle + aside);
            const double free = std::min({glm::length(nearestToShoulder(a, tried)),
                                          glm::length(nearestToShoulder(tried, b)), nearest});
            if (free <= best) continue;
            best = free;
            place = tried;
        }
    const double first = glm::length(place - a);
    out.length = first + glm::length(b - place);
    out.round = ChannelValues{place.x, place.y, place.z, 0.5 * (from[3] + to[3])};
    out.share_to_round = first / out.length;
    return out;
}

ChannelValues alongWay(const ChannelValues& from, const ChannelValues& to, double share) {
    const auto between = [](const ChannelValues& a, const ChannelValues& b, double t) {
        ChannelValues out{};
        for (std::size_t v = 0; v < out.size(); ++v) out[v] = a[v] + t * (b[v] - a[v]);
        return out;
    };
    const HandWay way = handWay(from, to);
    if (!way.round) return between(from, to, share);
    if (share <= way.share_to_round) return between(from, *way.round, share / way.share_to_round);
    return between(*way.round, to, (share - way.share_to_round) / (1.0 - way.share_to_round));
}

void appendKey(ChannelKeys& keys, Channel channel, const ChannelKey& key) {
    if (isHand(channel) && !keys.empty())
        if (const HandWay way = handWay(keys.back().values, key.values); way.round) {
            const double from_s = keys.back().time_s;
            keys.push_back({from_s + way.share_to_round * (key.time_s - from_s), *way.round, true});
        }
    keys.push_back(key);
}

BodyTarget targetAt(const BodyTrack& track, double time_s) {
    BodyTarget target = relaxedTarget();
    for (std::size_t c = 0; c < channel_count; ++c)
        if (!track[c].empty()) target[c] = valuesAt(track[c], time_s);
    return target;
}

}  // namespace deixis::motion
