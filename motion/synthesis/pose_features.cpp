#include "motion/synthesis/pose_features.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "pointing_body.hpp"

namespace deixis::motion {

namespace {

constexpr std::array<Bone, 17> moving_bones{Bone::spine,
                                            Bone::chest,
                                            Bone::upperChest,
                                            Bone::neck,
                                            Bone::head,
                                            Bone::leftEye,
                                            Bone::rightEye,
                                            Bone::leftShoulder,
                                            Bone::leftUpperArm,
                                            Bone::leftLowerArm,
                                            Bone::leftHand,
                                            Bone::rightShoulder,
                                            Bone::rightUpperArm,
                                            Bone::rightLowerArm,
                                            Bone::rightHand,
                                            Bone::leftIndexProximal,
                                            Bone::rightIndexProximal};

Quat turnFrom(const Quat& from, const Quat& to) {
    return glm::conjugate(from) * to;
}

/// The vector of the same rotation nearest to another: whole turns are added about its axis.
Vec3 nearestTo(const Vec3& other, const Vec3& vector) {
    const double angle = glm::length(vector);
    if (angle < 1e-9) return vector;
    const Vec3 axis = vector / angle;
    const double turns = std::round((glm::dot(other, axis) - angle) / (2.0 * pi));
    return axis * (angle + 2.0 * pi * turns);
}

}  // namespace

Result<PoseFeatures> PoseFeatures::of(const Skeleton& avatar) {
    const auto body = makePointingBody(avatar);
    if (!body) return tl::unexpected(body.error());
    return PoseFeatures(*body);
}

PoseFeatures::PoseFeatures(const PointingBody& body) : skeleton_(body.skeleton), at_ease_(body.relaxed) {
    for (const Bone bone : moving_bones)
        if (body.map.has(bone)) joints_.push_back(body.joint(bone));
    for (const Side side : {Side::left, Side::right})
        for (const std::size_t joint : body.fingers[static_cast<std::size_t>(side)]) {
            if (static_cast<int>(joint) == body.map[armBones(side).index_proximal]) continue;
            const Vec3 turn = rotationVector(turnFrom(body.relaxed.joints[joint].orientation,
                                                      body.pointing_hands.joints[joint].orientation));
            hands_[static_cast<std::size_t>(side)].push_back({joint, turn});
        }
}

std::string PoseFeatures::names() const {
    std::string out;
    for (const std::size_t joint : joints_) out += skeleton_.joints[joint].name + " ";
    return out + "leftFingers rightFingers";
}

std::vector<double> PoseFeatures::encode(const LocalPose& pose, std::span<const double> previous) const {
    std::vector<double> out;
    out.reserve(size());
    const auto turned = [&](std::size_t joint) {
        Quat turn = turnFrom(at_ease_.joints[joint].orientation, pose.joints[joint].orientation);
        if (turn.w < 0.0) turn = -turn;
        return rotationVector(turn);
    };
    for (const std::size_t joint : joints_) {
        Vec3 vector = turned(joint);
        if (const std::size_t at = out.size(); !previous.empty())
            vector = nearestTo(Vec3(previous[at], previous[at + 1], previous[at + 2]), vector);
        out.insert(out.end(), {vector.x, vector.y, vector.z});
    }
    for (const auto& fingers : hands_) {
        double along = 0.0, whole = 0.0;
        for (const FingerTurn& finger : fingers) {
            along += glm::dot(turned(finger.joint), finger.turn);
            whole += glm::dot(finger.turn, finger.turn);
        }
        out.push_back(whole > 0.0 ? along / whole : 0.0);
    }
    return out;
}

std::vector<std::vector<double>> PoseFeatures::encode(const Clip& clip) const {
    std::vector<std::vector<double>> out;
    for (const LocalPose& frame : clip.frames)
        out.push_back(encode(frame, out.empty() ? std::span<const double>() : out.back()));
    return out;
}

LocalPose PoseFeatures::decode(std::span<const double> features) const {
    LocalPose pose = at_ease_;
    const auto turn = [&pose](std::size_t joint, const Vec3& by) {
        Quat& orientation = pose.joints[joint].orientation;
        orientation = glm::normalize(orientation * rotationBy(by));
    };
    for (std::size_t i = 0; i < joints_.size(); ++i)
        turn(joints_[i], {features[3 * i], features[3 * i + 1], features[3 * i + 2]});
    for (std::size_t side = 0; side < hands_.size(); ++side)
        for (const FingerTurn& finger : hands_[side])
            turn(finger.joint, features[3 * joints_.size() + side] * finger.turn);
    return pose;
}

}  // namespace deixis::motion
