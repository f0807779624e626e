#include "physics/figure/figure_pose.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace deixis::physics {

namespace {

using motion::LocalPose;

Quat orientationOf(const Figure& figure, const LocalPose& pose, std::size_t joint) {
    Quat out = pose.joints[joint].orientation;
    for (int parent = figure.skeleton.joints[joint].parent; parent >= 0;
         parent = figure.skeleton.joints[static_cast<std::size_t>(parent)].parent)
        out = pose.joints[static_cast<std::size_t>(parent)].orientation * out;
    return out;
}

std::size_t parentBone(const Figure& figure, const Segment& segment) {
    return figure.segments[static_cast<std::size_t>(segment.parent)].bone;
}

/// How the segment is turned in its parent.
Quat turnOf(const Figure& figure, const LocalPose& pose, const Segment& segment) {
    return glm::conjugate(orientationOf(figure, pose, parentBone(figure, segment))) *
           orientationOf(figure, pose, segment.bone);
}

/// The part of a rotation about an axis: turned further about it, the angle grows by as much.
double angleAbout(const Quat& turn, const Vec3& axis) {
    const double along = turn.x * axis.x + turn.y * axis.y + turn.z * axis.z;
    return std::remainder(2.0 * std::atan2(along, turn.w), 2.0 * pi);
}

/// Angles a, b, c of turn = R(first, a) R(second, b) R(third, c), the second within 90 degrees.
std::array<double, 3> threeAngles(const Quat& turn, const Hinge* hinges) {
    const Vec3& first = hinges[0].axis;
    const Vec3& second = hinges[1].axis;
    const Vec3 third = glm::cross(first, second);
    const double sign = glm::dot(third, hinges[2].axis) > 0.0 ? 1.0 : -1.0;
    const glm::dmat3 axes(first, second, third);
    const glm::dmat3 m =
        glm::transpose(axes) * glm::mat3_cast(turn) * axes;  // as if about x, y, z; m[column][row]
    return {std::atan2(-m[2][1], m[2][2]), std::asin(std::clamp(m[2][0], -1.0, 1.0)),
            sign * std::atan2(-m[1][0], m[0][0])};
}

Quat turnBy(const Figure& figure, const Segment& segment, std::span<const double> angles_rad) {
    Quat out = no_rotation;
    for (std::size_t i = segment.first; i < segment.first + segment.count; ++i)
        out = out * glm::angleAxis(angles_rad[i], figure.hinges[i].axis);
    return out;
}

/// That share of a rotation, by the shorter arc.
Quat partOf(const Quat& rotation, double share) {
    return glm::slerp(no_rotation, rotation, share);
}

/// Turns the joints of a segment so that it is turned in its parent by `change` more.
void turnMore(const Figure& figure, const Segment& segment, const Quat& change, LocalPose& pose) {
    const Quat parent = orientationOf(figure, pose, parentBone(figure, segment));
    // As each joint is turned in the segment's parent now; in the end, by its part of the change more.
    std::vector<Quat> wanted;
    double share = 0.0;
    for (const TurningJoint& turning : segment.turning) {
        share += turning.share;
        wanted.push_back(partOf(change, std::min(share, 1.0)) * glm::conjugate(parent) *
                         orientationOf(figure, pose, turning.joint));
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const std::size_t joint = segment.turning[i].joint;
        const int above = figure.skeleton.joints[joint].parent;
        const Quat from = orientationOf(figure, pose, static_cast<std::size_t>(above));
        pose.joints[joint].orientation = glm::normalize(glm::conjugate(from) * parent * wanted[i]);
    }
}

}  // namespace

Pose rootOf(const Figure& figure, const LocalPose& pose) {
    const auto hips = figure.segments.front().bone;
    Pose out = pose.joints[hips];
    for (int parent = figure.skeleton.joints[hips].parent; parent >= 0;
         parent = figure.skeleton.joints[static_cast<std::size_t>(parent)].parent)
        out = pose.joints[static_cast<std::size_t>(parent)] * out;
    return out;
}

PoseFit fitPose(const Figure& figure, const LocalPose& pose) {
    PoseFit fit;
    fit.angles_rad.resize(figure.hinges.size());
    for (const Segment& segment : figure.segments) {
        if (segment.count == 0) continue;
        const Quat turn = turnOf(figure, pose, segment);
        if (segment.count == 1) {
            fit.angles_rad[segment.first] = angleAbout(turn, figure.hinges[segment.first].axis);
        } else {
            const auto angles = threeAngles(turn, &figure.hinges[segment.first]);
            std::copy(angles.begin(), angles.end(),
                      fit.angles_rad.begin() + static_cast<std::ptrdiff_t>(segment.first));
        }
    }
    for (std::size_t i = 0; i < figure.hinges.size(); ++i) {
        double& angle = fit.angles_rad[i];
        const double within = std::clamp(angle, figure.hinges[i].min_rad, figure.hinges[i].max_rad);
        if (const double beyond = std::abs(angle - within); beyond > fit.beyond_rad) {
            fit.beyond_rad = beyond;
            fit.beyond_hinge = i;
        }
        angle = within;
    }
    const auto body = segmentPoses(figure, rootOf(figure, pose), fit.angles_rad);
    const auto world = motion::worldPose(figure.skeleton, pose);
    for (const char* name : {"left forearm", "right forearm", "left hand", "right hand"}) {
        const std::size_t segment = figure.segment(name);
        fit.distance_m =
            std::max(fit.distance_m,
                     glm::distance(body[segment].position, world[figure.segments[segment].bone].position));
    }
    return fit;
}

void applyAngles(const Figure& figure, std::span<const double> angles_rad, LocalPose& pose) {
    for (const Segment& segment : figure.segments) {
        if (segment.count == 0) continue;
        const Quat turn = turnOf(figure, pose, segment);
        Quat change = no_rotation;
        if (segment.count == 1) {
            const Hinge& hinge = figure.hinges[segment.first];
            change = glm::angleAxis(angles_rad[segment.first] - angleAbout(turn, hinge.axis), hinge.axis);
        } else {
            change = turnBy(figure, segment, angles_rad) * glm::conjugate(turn);
        }
        turnMore(figure, segment, change, pose);
    }
}

void applyRoot(const Figure& figure, const Pose& root, LocalPose& pose) {
    const auto hips = figure.segments.front().bone;
    const Pose above = rootOf(figure, pose) * inverse(pose.joints[hips]);
    pose.joints[hips] = inverse(above) * root;
}

std::vector<Pose> segmentPoses(const Figure& figure, const Pose& root, std::span<const double> angles_rad) {
    std::vector<Pose> out{root};
    out.reserve(figure.segments.size());
    for (std::size_t i = 1; i < figure.segments.size(); ++i) {
        const Segment& segment = figure.segments[i];
        out.push_back(out[static_cast<std::size_t>(segment.parent)] *
                      Pose{segment.joint_m, turnBy(figure, segment, angles_rad)});
    }
    return out;
}

}  // namespace deixis::physics
