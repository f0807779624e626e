#include "motion/learned/gt_nn.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>

#include "motion/skeleton/clip_edit.hpp"
#include "motion/synthesis/phase_trajectory.hpp"

namespace deixis::motion {

namespace {

constexpr std::size_t numbers_a_joint = 7;    ///< orientation w x y z, position
constexpr std::size_t numbers_a_gesture = 5;  ///< hand, onset, peak, hold, end
constexpr int most_demonstrations = 100'000;

std::string jointNames(const Skeleton& skeleton) {
    std::string out;
    for (const auto& joint : skeleton.joints) out += (out.empty() ? "" : " ") + joint.name;
    return out;
}

NamedArray framesOf(const Clip& clip, std::size_t number) {
    NamedArray out{fmt::format("clip{}", number),
                   {clip.frames.size(), clip.skeleton.joints.size(), numbers_a_joint},
                   {}};
    for (const LocalPose& frame : clip.frames)
        for (const Pose& joint : frame.joints)
            for (const double value :
                 {joint.orientation.w, joint.orientation.x, joint.orientation.y, joint.orientation.z,
                  joint.position.x, joint.position.y, joint.position.z})
                out.values.push_back(static_cast<float>(value));
    return out;
}

std::vector<LocalPose> framesFrom(const NamedArray& array) {
    std::vector<LocalPose> out(array.shape[0]);
    const float* at = array.values.data();
    for (LocalPose& frame : out) {
        frame.joints.resize(array.shape[1]);
        for (Pose& joint : frame.joints) {
            joint.orientation = Quat(at[0], at[1], at[2], at[3]);
            joint.position = Vec3(at[4], at[5], at[6]);
            at += numbers_a_joint;
        }
    }
    makeContinuous(out);
    return out;
}

Result<Demonstration> demonstrationFrom(const NetworkWeights& weights, std::size_t number,
                                        const NamedArray& targets, const NamedArray& gestures,
                                        double frame_time_s, const Skeleton& avatar) {
    const std::string name = fmt::format("clip{}", number);
    const auto found = std::ranges::find(weights.arrays, name, &NamedArray::name);
    if (found == weights.arrays.end() || found->shape.size() != 3 || found->shape[0] == 0 ||
        found->shape[1] != avatar.joints.size() || found->shape[2] != numbers_a_joint)
        return fail(weights.file + ": " + name, "is missing or of another shape than frames x joints x 7");
    Demonstration out;
    for (int axis = 0; axis < 3; ++axis)
        out.target[axis] = static_cast<double>(targets.values[3 * number + static_cast<std::size_t>(axis)]);
    const float* gesture = &gestures.values[numbers_a_gesture * number];
    const auto frame = [gesture](int at) {
        return static_cast<int>(std::lround(std::clamp(gesture[at], 0.0F, 1e6F)));
    };
    out.gesture.hand = gesture[0] > 0.5F ? Side::right : Side::left;
    out.gesture.onset_frame = frame(1);
    out.gesture.peak_frame = frame(2);
    out.gesture.hold_frame = frame(3);
    out.gesture.end_frame = frame(4);
    out.gesture.clip = {avatar, frame_time_s, framesFrom(*found)};
    if (const auto fits = checkPhases(out.gesture, out.gesture.clip.frameCount()); !fits)
        return fail(weights.file + ": " + name, fits.error().message, fits.error().hint);
    return out;
}

/// The gesture with a hold of that many frames.
GeneratedClip heldFor(const GeneratedClip& gesture, int frames) {
    const Clip& clip = gesture.clip;
    const PhaseDurations own = durationsOf(gesture, clip.frameCount(), clip.frame_time_s);
    PhaseDurations durations = own;
    durations[2] = frames * clip.frame_time_s;
    const int more = frames - (gesture.hold_frame - gesture.peak_frame);
    GeneratedClip out = gesture;
    out.clip.frames.clear();
    for (int f = 0; f < clip.frameCount() + more; ++f)
        out.clip.frames.push_back(sample(clip, withHold(f * clip.frame_time_s, durations, own[2])));
    out.hold_frame += more;
    out.end_frame += more;
    return out;
}

class GtNn : public Generator {
  public:
    explicit GtNn(std::vector<Demonstration> demonstrations) : demonstrations_(std::move(demonstrations)) {}

    std::string_view name() const override { return gt_nn_architecture; }

    GeneratedClip generate(const GenerationRequest& asked) const override {
        const auto& nearest = *std::ranges::min_element(demonstrations_, {}, [&](const Demonstration& one) {
            return glm::distance(one.target, asked.target);
        });
        if (!asked.settings.hold_s) return nearest.gesture;
        const auto frames =
            static_cast<int>(std::lround(*asked.settings.hold_s / nearest.gesture.clip.frame_time_s));
        return heldFor(nearest.gesture, std::max(1, frames));
    }

  private:
    std::vector<Demonstration> demonstrations_;
};

}  // namespace

NetworkWeights gtNnWeights(const std::vector<Demonstration>& demonstrations) {
    const Clip& first = demonstrations.front().gesture.clip;
    NetworkWeights out;
    out.architecture = gt_nn_architecture;
    out.settings = {{"demonstrations", static_cast<double>(demonstrations.size())},
                    {"joints", jointNames(first.skeleton)}};
    NamedArray targets{"targets", {demonstrations.size(), 3}, {}},
        gestures{"gestures", {demonstrations.size(), numbers_a_gesture}, {}},
        frame_times{"frame_times_s", {demonstrations.size()}, {}};
    for (const Demonstration& one : demonstrations) {
        for (int axis = 0; axis < 3; ++axis) targets.values.push_back(static_cast<float>(one.target[axis]));
        const GeneratedClip& gesture = one.gesture;
        for (const int number : {gesture.hand == Side::right ? 1 : 0, gesture.onset_frame, gesture.peak_frame,
                                 gesture.hold_frame, gesture.end_frame})
            gestures.values.push_back(static_cast<float>(number));
        frame_times.values.push_back(static_cast<float>(gesture.clip.frame_time_s));
        out.arrays.push_back(framesOf(gesture.clip, out.arrays.size()));
    }
    out.arrays.insert(out.arrays.end(), {targets, gestures, frame_times});
    return out;
}

Result<std::unique_ptr<Generator>> makeGtNn(const NetworkWeights& weights, const Skeleton& avatar) {
    if (weights.architecture != gt_nn_architecture)
        return fail(weights.file, fmt::format("these are weights of '{}', expected '{}'",
                                              weights.architecture, gt_nn_architecture));
    const auto count = weights.count("demonstrations", 1, most_demonstrations);
    if (!count) return tl::unexpected(count.error());
    const auto joints = weights.text("joints");
    if (!joints) return tl::unexpected(joints.error());
    if (*joints != jointNames(avatar))
        return fail(weights.file + ": settings.joints", "its clips have other joints than this avatar",
                    "Make them for this avatar");
    const auto n = static_cast<std::size_t>(*count);
    const auto targets = weights.array("targets", {n, 3});
    if (!targets) return tl::unexpected(targets.error());
    const auto gestures = weights.array("gestures", {n, numbers_a_gesture});
    if (!gestures) return tl::unexpected(gestures.error());
    const auto frame_times = weights.array("frame_times_s", {n});
    if (!frame_times) return tl::unexpected(frame_times.error());
    std::vector<Demonstration> demonstrations;
    for (std::size_t i = 0; i < n; ++i) {
        const auto frame_time_s = static_cast<double>((*frame_times)->values[i]);
        if (!(frame_time_s >= 1e-4 && frame_time_s <= 1.0))
            return fail(weights.file + ": frame_times_s",
                        fmt::format("found {} s, expected 0.0001 to 1", frame_time_s));
        auto one = demonstrationFrom(weights, i, **targets, **gestures, frame_time_s, avatar);
        if (!one) return tl::unexpected(one.error());
        demonstrations.push_back(std::move(*one));
    }
    return std::make_unique<GtNn>(std::move(demonstrations));
}

}  // namespace deixis::motion
