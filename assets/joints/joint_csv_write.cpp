#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "assets/joints/joint_positions.hpp"
#include "core/csv.hpp"

namespace deixis::assets {

namespace {

void appendPoint(std::string& row, const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis) {
        // Rounded first, so that no "-0.000000" appears.
        const double rounded = std::round(p[axis] * 1e6) / 1e6;
        fmt::format_to(std::back_inserter(row), ",{:.6f}", rounded == 0.0 ? 0.0 : rounded);
    }
}

}  // namespace

std::string writeJointCsv(const motion::Clip& clip) {
    std::string out = "frame,time";
    for (const motion::Joint& joint : clip.skeleton.joints) {
        for (const char axis : {'x', 'y', 'z'}) out.append(",").append(csvField(joint.name + "." + axis));
        if (joint.end_site)
            for (const char axis : {'x', 'y', 'z'})
                out.append(",").append(csvField(joint.name + "_End." + axis));
    }
    out += '\n';
    std::vector<Pose> world;
    for (std::size_t f = 0; f < clip.frames.size(); ++f) {
        motion::worldPose(clip.skeleton, clip.frames[f], world);
        fmt::format_to(std::back_inserter(out), "{},{:.6f}", f, static_cast<double>(f) * clip.frame_time_s);
        for (int j = 0; j < clip.skeleton.size(); ++j) {
            appendPoint(out, world[static_cast<std::size_t>(j)].position);
            if (clip.skeleton.joints[static_cast<std::size_t>(j)].end_site)
                appendPoint(out, motion::tipPosition(clip.skeleton, world, j));
        }
        out += '\n';
    }
    return out;
}

}  // namespace deixis::assets
