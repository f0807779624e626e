#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/learned/moglow.hpp"
#include "motion/pointing/phases.hpp"

namespace deixis::motion {

namespace {

constexpr double clip_frame_time_s = 1.0 / 30.0;
constexpr double rest_before_s = 0.5;
constexpr double after_s = 2.0;  ///< for the way back and the rest

/// One number between frames, by the cubic of Catmull & Rom (1974) through four of them.
double between(double a, double b, double c, double d, double t) {
    return b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
}

/// Frames at one rate between those at another.
std::vector<double> sampled(const std::vector<std::vector<double>>& frames, double at) {
    const auto last = static_cast<std::ptrdiff_t>(frames.size()) - 1;
    const double clamped = std::clamp(at, 0.0, static_cast<double>(last));
    const auto first = static_cast<std::ptrdiff_t>(clamped);
    const auto frame = [&](std::ptrdiff_t i) -> const std::vector<double>& {
        return frames[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))];
    };
    std::vector<double> out;
    for (std::size_t d = 0; d < frames.front().size(); ++d)
        out.push_back(between(frame(first - 1)[d], frame(first)[d], frame(first + 1)[d], frame(first + 2)[d],
                              clamped - static_cast<double>(first)));
    return out;
}

class MoglowSystem : public Generator {
  public:
    MoglowSystem(Moglow model, PoseFeatures features)
        : model_(std::move(model)),
          features_(std::move(features)),
          map_(mapByVrmNames(features_.skeleton())) {}

    std::string_view name() const override { return "moglow"; }

    GeneratedClip generate(const GenerationRequest& asked) const override {
        const double hold_s = asked.settings.hold_s.value_or(model_.hold_s());
        const double off_s = rest_before_s + model_.raise_s() + hold_s;
        const double frame_time_s = model_.shape().frame_time_s;
        std::vector<bool> pointing;
        // The first frame drawn is the one after the figure at ease.
        for (double time_s = frame_time_s; time_s <= off_s + after_s; time_s += frame_time_s)
            pointing.push_back(time_s >= rest_before_s && time_s < off_s);
        Random random(asked.seed, "moglow");
        std::vector<std::vector<double>> frames{std::vector<double>(features_.size(), 0.0)};
        for (auto& frame : model_.draw(asked.target, std::move(pointing), random))
            frames.push_back(std::move(frame));

        GeneratedClip out;
        out.clip.skeleton = features_.skeleton();
        out.clip.frame_time_s = clip_frame_time_s;
        const double duration_s = frame_time_s * static_cast<double>(frames.size() - 1);
        for (int f = 0; f * clip_frame_time_s <= duration_s; ++f)
            out.clip.frames.push_back(
                features_.decode(sampled(frames, f * clip_frame_time_s / frame_time_s)));
        const int count = out.clip.frameCount();
        const auto frameAt = [](double time_s) {
            return static_cast<int>(std::lround(time_s / clip_frame_time_s));
        };
        out.onset_frame = frameAt(rest_before_s);
        out.peak_frame = frameAt(rest_before_s + model_.raise_s());
        out.hold_frame = frameAt(off_s);
        out.end_frame = std::min(count - 1, frameAt(off_s + 0.5 * after_s));
        findPhases(out);
        return out;
    }

  private:
    void findPhases(GeneratedClip& made) const {
        const auto world = worldPoses(made.clip);
        made.hand = recognisedHand(world, map_).hand;
        const auto found = detectPhases(jointTrajectory(world, map_[armBones(made.hand).hand]), made.hand,
                                        clip_frame_time_s);
        if (found && checkPhases(found->phases, made.clip.frameCount()))
            static_cast<GesturePhases&>(made) = found->phases;
    }

    Moglow model_;
    PoseFeatures features_;
    HumanoidMap map_;
};

}  // namespace

Result<std::unique_ptr<Generator>> makeMoglow(const NetworkWeights& weights, const Skeleton& avatar) {
    auto features = PoseFeatures::of(avatar);
    if (!features) return tl::unexpected(features.error());
    auto model = Moglow::of(weights, *features);
    if (!model) return tl::unexpected(model.error());
    return std::make_unique<MoglowSystem>(std::move(*model), std::move(*features));
}

Result<std::unique_ptr<Generator>> loadMoglow(const std::filesystem::path& weights, const Skeleton& avatar) {
    const auto read = readWeights(weights, moglow_architecture);
    if (!read) return tl::unexpected(read.error());
    return makeMoglow(*read, avatar);
}

}  // namespace deixis::motion
