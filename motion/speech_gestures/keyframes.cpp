#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "motion/speech_gestures/pose_control.hpp"

namespace deixis::motion {

namespace {

using Numbers = std::array<double, upper_body_numbers>;

struct Knot {
    double at = 0.0;  ///< frame
    Numbers value{};
    Numbers slope{};  ///< a frame
};

/// The slopes of a cubic spline that is twice continuously differentiable, 0 at both ends, by eliminating
/// forwards and then backwards what the knots say of each other (a tridiagonal system).
void setSlopes(std::vector<Knot>& knots) {
    if (knots.size() < 3) return;
    const std::size_t last = knots.size() - 1;
    std::vector<double> upper(knots.size(), 0.0);
    for (std::size_t i = 1; i < last; ++i) {
        const double before = 1.0 / (knots[i].at - knots[i - 1].at);
        const double after = 1.0 / (knots[i + 1].at - knots[i].at);
        const double diagonal = 2.0 * (before + after) - before * upper[i - 1];
        upper[i] = after / diagonal;
        for (std::size_t d = 0; d < upper_body_numbers; ++d) {
            const double right = 3.0 * ((knots[i].value[d] - knots[i - 1].value[d]) * before * before +
                                        (knots[i + 1].value[d] - knots[i].value[d]) * after * after);
            knots[i].slope[d] = (right - before * knots[i - 1].slope[d]) / diagonal;
        }
    }
    for (std::size_t i = last - 1; i > 0; --i)
        for (std::size_t d = 0; d < upper_body_numbers; ++d)
            knots[i].slope[d] -= upper[i] * knots[i + 1].slope[d];
}

Numbers between(const Knot& a, const Knot& b, double at) {
    const double length = b.at - a.at;
    const double u = (at - a.at) / length;
    Numbers out;
    for (std::size_t d = 0; d < upper_body_numbers; ++d)
        out[d] = (1.0 + 2.0 * u) * (1.0 - u) * (1.0 - u) * a.value[d] + u * u * (3.0 - 2.0 * u) * b.value[d] +
                 length * u * (1.0 - u) * ((1.0 - u) * a.slope[d] - u * b.slope[d]);
    return out;
}

}  // namespace

Result<void> checkPoses(std::span<const PoseControl> poses, std::size_t frames) {
    std::vector<int> seen;
    for (const PoseControl& one : poses) {
        if (one.frame < 0 || static_cast<std::size_t>(one.frame) >= frames)
            return fail("pose control", fmt::format("found a pose at frame {}, expected frames from 0 to {}",
                                                    one.frame, frames - 1));
        for (const Vec3& direction : one.pose.directions) {
            const double length = glm::length(direction);
            if (!(std::abs(length - 1.0) <= 0.01))
                return fail("pose control",
                            fmt::format("the pose at frame {} has a direction of length {}, expected 1",
                                        one.frame, length));
        }
        seen.push_back(one.frame);
    }
    std::ranges::sort(seen);
    if (const auto twice = std::ranges::adjacent_find(seen); twice != seen.end())
        return fail("pose control", fmt::format("found two poses for frame {}, expected one", *twice));
    return {};
}

UpperBodyMotion motionThroughKeyframes(std::vector<PoseControl> keyframes, std::size_t frames,
                                       const UpperBodyPose& ends) {
    if (frames == 0) return {};
    std::ranges::sort(keyframes, {}, &PoseControl::frame);
    const int last = static_cast<int>(frames) - 1;
    if (keyframes.empty() || keyframes.front().frame > 0) keyframes.insert(keyframes.begin(), {0, ends});
    if (keyframes.back().frame < last) keyframes.push_back({last, ends});
    std::vector<Knot> knots;
    for (const PoseControl& one : keyframes)
        knots.push_back({static_cast<double>(one.frame), numbersOf(one.pose), {}});
    setSlopes(knots);
    UpperBodyMotion out;
    std::size_t after = 0;
    for (int frame = 0; frame <= last; ++frame) {
        while (keyframes[after].frame < frame) ++after;
        if (keyframes[after].frame == frame) {
            out.frames.push_back(keyframes[after].pose);
            continue;
        }
        // Through 0 0 0 a direction says nothing: it stays what it was.
        const Numbers numbers = between(knots[after - 1], knots[after], frame);
        UpperBodyPose pose = out.frames.back();
        for (std::size_t b = 0; b < upper_bone_count; ++b) {
            const Vec3 direction{numbers[3 * b], numbers[3 * b + 1], numbers[3 * b + 2]};
            if (const double length = glm::length(direction); length > 1e-6)
                pose.directions[b] = direction / length;
        }
        out.frames.push_back(pose);
    }
    return out;
}

}  // namespace deixis::motion
