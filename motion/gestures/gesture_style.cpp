#include "motion/gestures/gesture_style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace deixis::motion {

namespace {

constexpr double style_limit = 3.0;

std::ptrdiff_t indexOf(const JointTrajectories& motion, Bone bone) {
    const auto found = std::find(motion.joints.begin(), motion.joints.end(), bone);
    return found == motion.joints.end() ? -1 : found - motion.joints.begin();
}

double handedness(double left, double right) {
    if (right > left) return left / right - 1.0;
    return left > 0.0 ? 1.0 - right / left : 0.0;
}

template <typename F>
Style eachOf(const F& f) {
    return {f(&Style::speed), f(&Style::space), f(&Style::handedness)};
}

}  // namespace

const std::vector<Bone>& styleBones() {
    static const std::vector<Bone> bones{
        Bone::hips,         Bone::spine,    Bone::neck,          Bone::head,          Bone::leftUpperArm,
        Bone::leftLowerArm, Bone::leftHand, Bone::rightUpperArm, Bone::rightLowerArm, Bone::rightHand};
    return bones;
}

const std::vector<Bone>& poseBones() {
    static const std::vector<Bone> bones(styleBones().begin() + 1, styleBones().end());
    return bones;
}

Result<std::vector<Style>> styleOfPositions(const std::vector<std::vector<Vec3>>& positions,
                                            std::size_t left_wrist, std::size_t right_wrist, int window) {
    const auto frames = static_cast<int>(positions.front().size());
    if (window < 2) return fail("", fmt::format("found a window of {} frames, expected 2 or more", window));
    if (frames < 2) return fail("", fmt::format("found {} frames, style needs at least 2", frames));

    std::vector<std::vector<double>> steps_m;  // [joint][frame - 1]
    for (const auto& trajectory : positions)
        steps_m.push_back(magnitudes(trajectory, 1.0, Derivative::speed));
    std::vector<Style> out;
    for (int i = 0; i < frames; ++i) {
        const int first = std::max(0, i - window / 2);
        const int last = std::min(frames - 1, i + window / 2);
        double speed = 0.0, space = 0.0, left_speed = 0.0, right_speed = 0.0;
        for (int j = first; j <= last; ++j) {
            const auto f = static_cast<std::size_t>(j);
            space += glm::length(positions[left_wrist][f] - positions[right_wrist][f]);
            if (f == 0) continue;
            for (const auto& of_joint : steps_m) speed += of_joint[f - 1];
            left_speed += steps_m[left_wrist][f - 1];
            right_speed += steps_m[right_wrist][f - 1];
        }
        const int whole_frames = window / 2 * 2 + 1;
        const double whole = whole_frames;
        const int steps = last - std::max(first, 1) + 1;
        out.push_back({speed * whole / (steps * static_cast<double>(window)),
                       space * whole / ((last - first + 1) * static_cast<double>(window)),
                       handedness(left_speed, right_speed)});
    }
    return out;
}

Result<std::vector<Style>> gestureStyle(const JointTrajectories& motion, int window) {
    const auto left = indexOf(motion, Bone::leftHand);
    const auto right = indexOf(motion, Bone::rightHand);
    if (left < 0 || right < 0)
        return fail("", "found no left and right hand", "Style is measured on both hands");
    return styleOfPositions(motion.positions, static_cast<std::size_t>(left), static_cast<std::size_t>(right),
                            window);
}

StyleNorm styleNorm(const std::vector<std::vector<Style>>& corpus) {
    double n = 0.0;
    for (const auto& clip : corpus) n += static_cast<double>(clip.size());
    const auto mean = [&](double Style::*element) {
        double sum = 0.0;
        for (const auto& clip : corpus)
            for (const Style& s : clip) sum += s.*element;
        return n > 0.0 ? sum / n : 0.0;
    };
    StyleNorm out;
    out.mean = eachOf(mean);
    out.sd = eachOf([&](double Style::*element) {
        double squares = 0.0;
        for (const auto& clip : corpus)
            for (const Style& s : clip) squares += std::pow(s.*element - out.mean.*element, 2);
        return n > 0.0 ? std::sqrt(squares / n) : 0.0;
    });
    return out;
}

Style normalisedStyle(const Style& style, const StyleNorm& norm) {
    return eachOf([&](double Style::*element) {
        if (norm.sd.*element <= 0.0) return 0.0;
        return std::clamp((style.*element - norm.mean.*element) / norm.sd.*element, -style_limit,
                          style_limit);
    });
}

Result<double> poseCompliance(const JointTrajectories& reference, const JointTrajectories& generated,
                              int first, int last) {
    if (reference.joints != generated.joints || reference.joints.empty())
        return fail("", "the reference poses and the motion have different joints",
                    "Give poses of the same kind of skeleton");
    if (std::abs(reference.frame_time_s - generated.frame_time_s) > 0.01 * generated.frame_time_s)
        return fail("",
                    fmt::format("the reference poses have {:.4g} frames per second, the motion {:.4g}",
                                1.0 / reference.frame_time_s, 1.0 / generated.frame_time_s),
                    "Frames are matched by number: resample both to one rate ('deixis clips resample')");
    const auto frames =
        static_cast<int>(std::min(reference.positions.front().size(), generated.positions.front().size()));
    if (first < 0 || last <= first || last > frames)
        return fail("", fmt::format("found {} frames, expected at least {} (reference poses are in {} to {})",
                                    frames, last, first, last - 1));
    double sum = 0.0;
    for (std::size_t j = 0; j < reference.positions.size(); ++j)
        for (int f = first; f < last; ++f) {
            const auto i = static_cast<std::size_t>(f);
            const Vec3 difference = glm::abs(reference.positions[j][i] - generated.positions[j][i]);
            sum += difference.x + difference.y + difference.z;
        }
    return sum / (3.0 * static_cast<double>(reference.positions.size()) * (last - first));
}

Result<double> styleCompliance(const std::vector<Style>& reference, const std::vector<Style>& generated) {
    if (reference.empty() || reference.size() != generated.size())
        return fail("", fmt::format("found styles of {} and {} frames, expected the same number",
                                    reference.size(), generated.size()));
    double sum = 0.0;
    for (std::size_t i = 0; i < reference.size(); ++i)
        sum += std::abs(reference[i].speed - generated[i].speed) +
               std::abs(reference[i].space - generated[i].space) +
               std::abs(reference[i].handedness - generated[i].handedness);
    return sum / (3.0 * static_cast<double>(reference.size()));
}

}  // namespace deixis::motion
