#include "motion/gestures/motion_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/pointing/phases.hpp"

namespace deixis::motion {

namespace {

constexpr std::array<Derivative, derivative_count> derivatives{Derivative::speed, Derivative::acceleration,
                                                               Derivative::jerk};

double meanOf(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
}

Histogram summed(const std::vector<Histogram>& histograms) {
    Histogram out = histograms.front();
    for (std::size_t j = 1; j < histograms.size(); ++j)
        for (std::size_t i = 0; i < out.counts.size(); ++i) out.counts[i] += histograms[j].counts[i];
    return out;
}

Result<void> checkAlike(const std::vector<JointTrajectories>& clips) {
    if (clips.empty()) return fail("", "found no clips", "Give at least one");
    for (std::size_t i = 0; i < clips.size(); ++i) {
        const JointTrajectories& clip = clips[i];
        if (clip.joints.empty())
            return fail("", fmt::format("clip {} has none of the joints that are compared", i + 1));
        if (clip.joints != clips.front().joints)
            return fail("", fmt::format("clip {} has other joints than clip 1", i + 1),
                        "Compare clips of one kind of skeleton");
        if (std::abs(clip.frame_time_s - clips.front().frame_time_s) > 1e-6)
            return fail("",
                        fmt::format("clip {} has {:.4g} frames per second, clip 1 {:.4g}", i + 1,
                                    1.0 / clip.frame_time_s, 1.0 / clips.front().frame_time_s),
                        "Resample all to one rate");
        if (clip.positions.front().size() <= derivative_count)
            return fail(
                "", fmt::format("clip {} has {} frames, jerk needs 4", i + 1, clip.positions.front().size()));
    }
    return {};
}

}  // namespace

JointTrajectories jointTrajectories(const Clip& clip, const HumanoidMap& map,
                                    const std::vector<Bone>& bones) {
    JointTrajectories out;
    out.frame_time_s = clip.frame_time_s;
    const auto world = worldPoses(clip);
    const std::vector<Vec3> hips = jointTrajectory(world, map[Bone::hips]);
    for (const Bone bone : bones) {
        if (!map.has(bone)) continue;
        std::vector<Vec3> trajectory = jointTrajectory(world, map[bone]);
        for (std::size_t f = 0; f < trajectory.size(); ++f) trajectory[f] -= hips[f];
        out.joints.push_back(bone);
        out.positions.push_back(std::move(trajectory));
    }
    return out;
}

const std::vector<Bone>& comparedBones() {
    static const std::vector<Bone> bones{Bone::neck,          Bone::head,     Bone::leftUpperArm,
                                         Bone::leftLowerArm,  Bone::leftHand, Bone::rightUpperArm,
                                         Bone::rightLowerArm, Bone::rightHand};
    return bones;
}

std::string_view derivativeName(Derivative derivative) {
    constexpr std::array<std::string_view, derivative_count> names{"speed", "acceleration", "jerk"};
    return names[static_cast<std::size_t>(derivative)];
}

Histogram emptyHistogram(Derivative derivative) {
    constexpr std::array<double, derivative_count> widths{0.01, 0.1, 5.0};
    constexpr std::size_t bins = 300;
    return {widths[static_cast<std::size_t>(derivative)], std::vector<double>(bins, 0.0)};
}

void count(Histogram& histogram, const std::vector<double>& values) {
    const auto last = static_cast<double>(histogram.counts.size() - 1);
    for (const double v : values)
        histogram.counts[static_cast<std::size_t>(std::min(std::floor(v / histogram.bin_width), last))] +=
            1.0;
}

double hellingerDistance(const Histogram& a, const Histogram& b) {
    double all_a = 0.0;
    double all_b = 0.0;
    for (const double c : a.counts) all_a += c;
    for (const double c : b.counts) all_b += c;
    double overlap = 0.0;
    for (std::size_t i = 0; i < a.counts.size(); ++i)
        overlap += std::sqrt(a.counts[i] / all_a * (b.counts[i] / all_b));
    return std::sqrt(std::max(0.0, 1.0 - overlap));
}

Result<MotionStatistics> motionStatistics(const std::vector<JointTrajectories>& clips) {
    if (auto checked = checkAlike(clips); !checked) return tl::unexpected(checked.error());
    MotionStatistics out;
    out.joints = clips.front().joints;
    for (const Derivative derivative : derivatives) {
        const auto d = static_cast<std::size_t>(derivative);
        out.histograms[d].assign(out.joints.size(), emptyHistogram(derivative));
        std::vector<double> clip_means;
        for (const JointTrajectories& clip : clips) {
            std::vector<double> joint_means;
            for (std::size_t j = 0; j < out.joints.size(); ++j) {
                const auto values = magnitudes(clip.positions[j], clip.frame_time_s, derivative);
                count(out.histograms[d][j], values);
                joint_means.push_back(meanOf(values));
            }
            clip_means.push_back(meanOf(joint_means));
        }
        OverClips& average = out.average[d];
        average.mean = meanOf(clip_means);
        double squares = 0.0;
        for (const double m : clip_means) squares += (m - average.mean) * (m - average.mean);
        average.sd = std::sqrt(squares / static_cast<double>(clip_means.size()));
    }
    return out;
}

Result<std::array<MotionDistance, derivative_count>> motionDistances(const MotionStatistics& a,
                                                                     const MotionStatistics& b) {
    if (a.joints != b.joints)
        return fail("", "the two sets of clips have different joints",
                    "Compare clips of one kind of skeleton");
    std::array<MotionDistance, derivative_count> out;
    for (std::size_t d = 0; d < derivative_count; ++d) {
        out[d].pooled = hellingerDistance(summed(a.histograms[d]), summed(b.histograms[d]));
        for (std::size_t j = 0; j < a.joints.size(); ++j)
            out[d].mean += hellingerDistance(a.histograms[d][j], b.histograms[d][j]) /
                           static_cast<double>(a.joints.size());
    }
    return out;
}

}  // namespace deixis::motion
