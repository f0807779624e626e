#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <stdexcept>
#include <vector>

#include "assets/joints/bvh.hpp"

namespace deixis::assets {

namespace {

using motion::Clip;
using motion::Joint;

/// Angles z, x, y with R = Rz Rx Ry, degrees.
Vec3 zxyDegrees(const Quat& q) {
    // The entries of R that the angles need: sin x stands at (2, 1).
    const double sin_x = 2.0 * (q.y * q.z + q.w * q.x);
    const double r01 = 2.0 * (q.x * q.y - q.w * q.z);
    const double r11 = 1.0 - 2.0 * (q.x * q.x + q.z * q.z);
    const double r20 = 2.0 * (q.x * q.z - q.w * q.y);
    const double r22 = 1.0 - 2.0 * (q.x * q.x + q.y * q.y);
    const double cos_x = std::hypot(r01, r11);
    Vec3 zxy;
    zxy.y = std::atan2(sin_x, cos_x);
    if (cos_x > 1e-7) {
        zxy.x = std::atan2(-r01, r11);
        zxy.z = std::atan2(-r20, r22);
    } else {  // z and y turn about one axis: all of it goes to z
        const double r00 = 1.0 - 2.0 * (q.y * q.y + q.z * q.z);
        const double r10 = 2.0 * (q.x * q.y + q.w * q.z);
        zxy.x = std::atan2(r10, r00);
        zxy.z = 0.0;
    }
    return {degreesFromRadians(zxy.x), degreesFromRadians(zxy.y), degreesFromRadians(zxy.z)};
}

class Writer {
  public:
    explicit Writer(const Clip& clip)
        : clip_(clip), children_(clip.skeleton.joints.size()), moves_(clip.skeleton.joints.size(), false) {
        for (int i = 1; i < clip.skeleton.size(); ++i) {
            const int parent = clip.skeleton.joints[static_cast<std::size_t>(i)].parent;
            if (parent < 0) throw std::invalid_argument("writeBvh: the skeleton has more than one root");
            children_[static_cast<std::size_t>(parent)].push_back(static_cast<std::size_t>(i));
        }
        if (clip.skeleton.joints.empty()) throw std::invalid_argument("writeBvh: the skeleton is empty");
        moves_[0] = true;
        for (const auto& frame : clip.frames)
            for (std::size_t j = 0; j < moves_.size(); ++j)
                if (glm::length(frame.joints[j].position - clip.skeleton.joints[j].rest.position) > 1e-6)
                    moves_[j] = true;
    }

    std::string write() {
        out_ += "HIERARCHY\n";
        writeJoint(0, 0);
        fmt::format_to(std::back_inserter(out_), "MOTION\nFrames: {}\nFrame Time: {}\n", clip_.frameCount(),
                       clip_.frame_time_s);
        for (const auto& frame : clip_.frames) writeFrame(frame);
        return std::move(out_);
    }

  private:
    void writeVector(const Vec3& v) {
        for (int axis = 0; axis < 3; ++axis) writeNumber(v[axis]);
    }

    void writeNumber(double value) {
        // Rounded first, so that no "-0.000000" appears.
        const double rounded = std::round(value * 1e6) / 1e6;
        fmt::format_to(std::back_inserter(out_), " {:.6f}", rounded == 0.0 ? 0.0 : rounded);
    }

    void writeJoint(std::size_t index, std::size_t depth) {
        order_.push_back(index);
        const Joint& joint = clip_.skeleton.joints[index];
        const std::string indent(depth, '\t');
        out_ += indent + (depth == 0 ? "ROOT " : "JOINT ") + joint.name + "\n" + indent + "{\n";
        out_ += indent + "\tOFFSET";
        writeVector(joint.rest.position);
        out_ += "\n" + indent +
                (moves_[index] ? "\tCHANNELS 6 Xposition Yposition Zposition" : "\tCHANNELS 3") +
                " Zrotation Xrotation Yrotation\n";
        for (const std::size_t child : children_[index]) writeJoint(child, depth + 1);
        if (joint.end_site || children_[index].empty()) {  // many readers want one at every leaf
            out_ += indent + "\tEnd Site\n" + indent + "\t{\n" + indent + "\t\tOFFSET";
            writeVector(joint.end_site.value_or(Vec3(0.0)));
            out_ += "\n" + indent + "\t}\n";
        }
        out_ += indent + "}\n";
    }

    void writeFrame(const motion::LocalPose& frame) {
        const std::size_t begin = out_.size();
        for (const std::size_t j : order_) {
            if (moves_[j]) writeVector(frame.joints[j].position);
            writeVector(zxyDegrees(frame.joints[j].orientation));
        }
        out_.erase(begin, 1);  // the first number's blank
        out_ += '\n';
    }

    const Clip& clip_;
    std::vector<std::vector<std::size_t>> children_;
    std::vector<bool> moves_;
    std::vector<std::size_t> order_;  // depth first, as the file has the joints
    std::string out_;
};

}  // namespace

std::string writeBvh(const motion::Clip& clip) {
    return Writer(clip).write();
}

}  // namespace deixis::assets
