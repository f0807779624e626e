#include "training_frames.hpp"

#include <algorithm>
#include <cmath>

namespace deixis::learning {

namespace {

using motion::ControlledFrames;
using motion::Demonstration;

/// Between two rows, at a share of the way.
std::vector<double> between(const std::vector<double>& a, const std::vector<double>& b, double t) {
    std::vector<double> out;
    for (std::size_t d = 0; d < a.size(); ++d) out.push_back(a[d] + t * (b[d] - a[d]));
    return out;
}

template <typename Seconds>
double mean(const std::vector<Demonstration>& demonstrations, const Seconds& seconds) {
    double sum = 0.0;
    for (const Demonstration& one : demonstrations) sum += seconds(one.gesture);
    return sum / static_cast<double>(demonstrations.size());
}

}  // namespace

std::vector<double> FeatureScale::standardised(const std::vector<double>& features) const {
    std::vector<double> out;
    for (std::size_t d = 0; d < features.size(); ++d) out.push_back((features[d] - mean[d]) / sd[d]);
    return out;
}

FeatureScale scaleOf(const std::vector<Demonstration>& demonstrations, const motion::PoseFeatures& features) {
    constexpr double min_sd = 0.01;
    FeatureScale out{std::vector<double>(features.size(), 0.0), std::vector<double>(features.size(), 0.0)};
    std::vector<double> squares(features.size(), 0.0);
    double count = 0.0;
    for (const Demonstration& one : demonstrations)
        for (const auto& frame : features.encode(one.gesture.clip)) {
            count += 1.0;
            for (std::size_t d = 0; d < frame.size(); ++d) {
                out.mean[d] += frame[d];
                squares[d] += frame[d] * frame[d];
            }
        }
    for (std::size_t d = 0; d < out.mean.size(); ++d) {
        out.mean[d] /= count;
        const double variance = squares[d] / count - out.mean[d] * out.mean[d];
        out.sd[d] = std::max(min_sd, std::sqrt(std::max(0.0, variance)));
    }
    return out;
}

ControlledFrames framesOf(const Demonstration& demonstration, const motion::PoseFeatures& features,
                          const FeatureScale& scale, const MoglowSettings& settings) {
    const motion::GeneratedClip& made = demonstration.gesture;
    const auto rows = features.encode(made.clip);
    const double frame_time_s = settings.shape.frame_time_s;
    const double recorded_s = made.clip.frame_time_s;
    const double end_s = made.clip.duration_s() + settings.rest_after_s;
    ControlledFrames out;
    out.target = demonstration.target;
    const std::vector<double> at_ease(features.size(), 0.0);
    const auto before = std::lround(settings.rest_before_s / frame_time_s);
    for (auto i = -before; static_cast<double>(i) * frame_time_s <= end_s; ++i) {
        const double at = static_cast<double>(i) * frame_time_s / recorded_s;
        out.pointing.push_back(at >= made.onset_frame && at < made.hold_frame);
        if (at < 0.0 || at > made.clip.frameCount() - 1) {
            out.features.push_back(scale.standardised(at_ease));
            continue;
        }
        const auto first = static_cast<std::size_t>(at);
        const std::size_t second = std::min(first + 1, rows.size() - 1);
        out.features.push_back(
            scale.standardised(between(rows[first], rows[second], at - static_cast<double>(first))));
    }
    return out;
}

double meanRaise_s(const std::vector<Demonstration>& demonstrations) {
    return mean(demonstrations, [](const motion::GeneratedClip& made) {
        return made.clip.frame_time_s * (made.peak_frame - made.onset_frame);
    });
}

double meanHold_s(const std::vector<Demonstration>& demonstrations) {
    return mean(demonstrations, [](const motion::GeneratedClip& made) {
        return made.clip.frame_time_s * (made.hold_frame - made.peak_frame);
    });
}

}  // namespace deixis::learning
