#include "gesture_windows.hpp"

#include <algorithm>
#include <cmath>

#include "motion/skeleton/minimum_jerk.hpp"

namespace deixis::learning {

namespace {

using motion::gesture_window;
using torch::Tensor;

constexpr float heard_steps = 2048.0F;  // of a number; a sound's root mean square is 1

Tensor posesOf(const motion::UpperBodyMotion& motion) {
    std::vector<float> out;
    for (const auto& pose : motion.frames)
        for (const double number : motion::numbersOf(pose)) out.push_back(static_cast<float>(number));
    return torch::tensor(out).reshape({-1, static_cast<std::int64_t>(motion::upper_body_numbers)});
}

std::vector<std::int16_t> packed(const std::vector<float>& heard) {
    std::vector<std::int16_t> out;
    out.reserve(heard.size());
    for (const float value : heard)
        out.push_back(
            static_cast<std::int16_t>(std::clamp(std::round(value * heard_steps), -32767.0F, 32767.0F)));
    return out;
}

/// Frames `begin` on, as many as a window has; behind the last one it is repeated, or there is nothing.
Tensor framesFrom(const Tensor& rows, int begin, bool repeat) {
    const std::int64_t held = std::min<std::int64_t>(gesture_window, rows.size(0) - begin);
    const Tensor there = rows.narrow(0, begin, held);
    if (held == gesture_window) return there;
    const Tensor last = rows.narrow(0, rows.size(0) - 1, 1).expand({gesture_window - held, rows.size(1)});
    return torch::cat({there, repeat ? last : torch::zeros_like(last)});
}

void setPoses(Tensor controls, const Tensor& poses, std::int64_t first, std::int64_t count) {
    controls.narrow(0, first, count)
        .narrow(1, motion::control_pose, poses.size(1))
        .copy_(poses.narrow(0, first, count));
    controls.narrow(0, first, count).select(1, motion::control_pose_mask).fill_(1.0);
}
void setStyle(Tensor controls, const Tensor& styles, int element) {
    controls.select(1, motion::control_style + element).copy_(styles.select(1, element));
    controls.select(1, motion::control_style_mask + element).fill_(1.0);
}

}  // namespace

GestureWindows::GestureWindows(const std::vector<GestureTake>& takes, const motion::WordVectors& words,
                               const Tensor& mean_pose, int stride)
    : stride_(stride) {
    for (const GestureTake& one : takes) {
        Take take;
        take.heard = packed(motion::heardSound(one.samples));
        take.poses = posesOf(one.motion) - mean_pose;
        const auto frames = static_cast<int>(take.poses.size(0));
        const Eigen::MatrixXf columns = motion::wordFrames(one.utterance, words, frames);
        take.words = torch::from_blob(const_cast<float*>(columns.data()), {frames, columns.rows()}).clone();
        const int last = std::max(0, frames - gesture_window);
        for (int begin = 0; begin < last; begin += stride) windows_.push_back({takes_.size(), begin});
        windows_.push_back({takes_.size(), last});
        takes_.push_back(std::move(take));
    }
}

WindowBatch GestureWindows::join(const std::vector<Window>& windows) const {
    constexpr std::ptrdiff_t samples =
        std::ptrdiff_t{motion::sound_samples_per_frame} * (gesture_window - 1) + motion::sound_samples_heard;
    Tensor sound = torch::zeros({static_cast<std::int64_t>(windows.size()), samples});
    std::vector<Tensor> words, poses;
    for (std::size_t i = 0; i < windows.size(); ++i) {
        const Take& take = takes_[windows[i].take];
        const std::ptrdiff_t begin = std::ptrdiff_t{motion::sound_samples_per_frame} * windows[i].begin -
                                     motion::sound_samples_heard / 2;
        const auto size = static_cast<std::ptrdiff_t>(take.heard.size());
        float* row = sound.data_ptr<float>() + static_cast<std::ptrdiff_t>(i) * samples;
        for (std::ptrdiff_t at = std::max<std::ptrdiff_t>(0, begin); at < std::min(size, begin + samples);
             ++at)
            row[at - begin] = static_cast<float>(take.heard[static_cast<std::size_t>(at)]) / heard_steps;
        words.push_back(framesFrom(take.words, windows[i].begin, false));
        poses.push_back(framesFrom(take.poses, windows[i].begin, true));
    }
    return {sound, torch::stack(words), torch::stack(poses)};
}

WindowBatch GestureWindows::batch(std::span<const std::size_t> numbers, Random& random) const {
    std::vector<Window> windows;
    for (const std::size_t number : numbers) {
        Window window = windows_[number];
        const auto later = static_cast<int>(random.below(static_cast<std::uint64_t>(stride_)));
        const auto frames = static_cast<int>(takes_[window.take].poses.size(0));
        window.begin = std::min(window.begin + later, std::max(0, frames - gesture_window));
        windows.push_back(window);
    }
    return join(windows);
}

WindowBatch GestureWindows::range(std::size_t first, std::size_t count) const {
    const auto begin = windows_.begin() + static_cast<std::ptrdiff_t>(first);
    return join({begin, begin + static_cast<std::ptrdiff_t>(std::min(count, windows_.size() - first))});
}

Tensor meanPoseOf(const std::vector<GestureTake>& takes) {
    std::array<Vec3, motion::upper_bone_count> sums{};
    for (const GestureTake& take : takes)
        for (const auto& pose : take.motion.frames)
            for (std::size_t b = 0; b < sums.size(); ++b) sums[b] += pose.directions[b];
    std::vector<float> out;
    for (const Vec3& sum : sums) {
        const double length = glm::length(sum);
        const Vec3 mean = length > 0.0 ? sum / length : Vec3(0.0, 1.0, 0.0);
        for (const double number : {mean.x, mean.y, mean.z}) out.push_back(static_cast<float>(number));
    }
    return torch::tensor(out);
}

motion::StyleNorm normOf(const Tensor& styles) {
    const Tensor flat = styles.reshape({-1, 3}).to(torch::kFloat64);
    const Tensor mean = flat.mean(0), sd = flat.std(0, false);
    const auto styleOf = [](const Tensor& numbers) {
        return motion::Style{numbers[0].item<double>(), numbers[1].item<double>(), numbers[2].item<double>()};
    };
    return {styleOf(mean), styleOf(sd)};
}

Tensor heldOutControls(const Tensor& poses, const Tensor& styles, GivenControls given) {
    Tensor out = torch::zeros({poses.size(0), poses.size(1), motion::control_numbers});
    for (std::int64_t i = 0; i < poses.size(0); ++i) {
        if (given == GivenControls::poses)
            setPoses(out[i], poses[i], scored_first + posed_first, posed_frames);
        if (given == GivenControls::styles)
            for (int element = 0; element < 3; ++element) setStyle(out[i], styles[i], element);
    }
    return out;
}

Tensor simulatedControls(const Tensor& poses, const Tensor& styles, double share, Random& random) {
    const std::int64_t frames = poses.size(1);
    Tensor out = torch::zeros({poses.size(0), frames, motion::control_numbers});
    for (std::int64_t i = 0; i < poses.size(0); ++i) {
        if (random.uniform() < share) {
            const bool seeded = random.uniform() < 0.5;
            if (seeded) setPoses(out[i], poses[i], 0, motion::gesture_overlap);
            if (!seeded || random.uniform() < 0.5) {
                const auto length =
                    1 + static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(frames)));
                const auto first =
                    static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(frames - length + 1)));
                setPoses(out[i], poses[i], first, length);
            }
        }
        if (random.uniform() >= share) continue;
        const bool whole = random.uniform() < 0.5;
        const auto left_out = static_cast<int>(random.below(3));
        for (int element = 0; element < 3; ++element)
            if (whole || element != left_out) setStyle(out[i], styles[i], element);
    }
    return out;
}

ForeignPoses withForeignPoses(const Tensor& poses, double share, Random& random) {
    constexpr std::uint64_t longest = 10;
    constexpr std::int64_t spread = 12;  // frames
    const std::int64_t windows = poses.size(0), frames = poses.size(1);
    ForeignPoses out{poses.clone(), {}};
    for (std::int64_t i = 0; i < windows; ++i) {
        if (random.uniform() >= share) continue;
        const auto other = static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(windows)));
        const auto length = 1 + static_cast<std::int64_t>(random.below(longest));
        const auto first =
            static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(frames - length + 1)));
        const std::int64_t last = first + length - 1;
        for (std::int64_t f = std::max<std::int64_t>(0, first - spread);
             f < std::min(frames, last + 1 + spread); ++f) {
            const std::int64_t nearest = std::clamp(f, first, last);
            const double apart = static_cast<double>(std::abs(f - nearest)) / spread;
            out.poses[i][f] +=
                (1.0 - motion::minimumJerk(apart)) * (poses[other][nearest] - poses[i][nearest]);
        }
        out.runs.push_back({i, first, length});
    }
    return out;
}

void setForeignControls(Tensor& controls, const ForeignPoses& foreign) {
    for (const auto& run : foreign.runs) {
        controls[run.window].narrow(1, motion::control_pose, motion::control_pose_mask + 1).zero_();
        setPoses(controls[run.window], foreign.poses[run.window], run.first, run.length);
    }
}

}  // namespace deixis::learning
