#include "motion/speech_gestures/speech_gestures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "gesture_request.hpp"
#include "motion/networks/taking.hpp"
#include "motion/skeleton/minimum_jerk.hpp"

namespace deixis::motion {

namespace {

constexpr double longest_speech_s = 3600.0;
constexpr int freed_before_pose = 15;  ///< frames before a pose that a window sees first
constexpr int least_overlap = 8;       ///< frames that stay pinned all the same

VectorXf vectorOf(const UpperBodyPose& pose) {
    const auto numbers = numbersOf(pose);
    return Eigen::Map<const Eigen::Matrix<double, upper_body_numbers, 1>>(numbers.data()).cast<float>();
}

/// Where a direction has no length it is that of `otherwise`.
UpperBodyPose poseOf(const VectorXf& numbers, const UpperBodyPose& otherwise) {
    UpperBodyPose out = otherwise;
    for (std::size_t b = 0; b < upper_bone_count; ++b) {
        const auto at = static_cast<Eigen::Index>(3 * b);
        const Vec3 direction{numbers[at], numbers[at + 1], numbers[at + 2]};
        if (const double length = glm::length(direction); length > 1e-6)
            out.directions[b] = direction / length;
    }
    return out;
}

/// The frames of a speech from window to window: what the network sees, and what it made so far.
class Frames {
  public:
    Frames(const SpeechGestureRequest& request, std::size_t count, const GestureNetwork& network,
           const WordVectors& words, const VectorXf& mean)
        : network_(network),
          mean_(mean),
          count_(static_cast<int>(count)),
          padded_(paddedCount(static_cast<int>(count))),
          changed_(changedFrames(request, count)),
          posed_(static_cast<std::size_t>(padded_), false),
          words_(wordFrames(request.utterance, words, padded_)),
          controls_(MatrixXf::Zero(network.shape().controls ? control_numbers : 0, padded_)),
          made_(MatrixXf::Zero(upper_body_numbers, padded_)) {
        // A second of sound at a time, so that long speeches need no more memory.
        const std::vector<float> heard = heardSound(request.samples);
        sound_.resize(network.shape().sound_size, padded_);
        for (int first = 0; first < padded_; first += gesture_overlap)
            sound_.middleCols(first, gesture_overlap) =
                network.encodeSound(heardAround(heard, first, gesture_overlap));
        if (!network.shape().controls) return;
        const auto styles = allStyles(request, count);
        for (int f = 0; f < count_; ++f) setStyle(f, styles[static_cast<std::size_t>(f)]);
        for (const PoseControl& one : allPoses(request, count)) {
            pin(controls_, one.frame, vectorOf(one.pose) - mean_);
            posed_[static_cast<std::size_t>(one.frame)] = true;
            made_.col(one.frame) = vectorOf(one.pose) - mean_;
        }
    }

    void makeAll() {
        for (int first = 0; first + gesture_window <= padded_; first += gesture_overlap) make(first);
    }
    [[nodiscard]] VectorXf numbersAt(int frame) const { return made_.col(frame) + mean_; }

  private:
    static int paddedCount(int count) {
        const int beyond = std::max(0, count - gesture_window);
        return gesture_window + (beyond + gesture_overlap - 1) / gesture_overlap * gesture_overlap;
    }
    static void pin(MatrixXf& controls, int column, const VectorXf& pose) {
        controls.block(control_pose, column, upper_body_numbers, 1) = pose;
        controls(control_pose_mask, column) = 1.0F;
    }
    void setStyle(int frame, const StyleControl& style) {
        const std::array elements{style.speed, style.space, style.handedness};
        for (int e = 0; e < 3; ++e) {
            const auto& value = elements[static_cast<std::size_t>(e)];
            if (!value) continue;
            controls_(control_style + e, frame) = static_cast<float>(*value);
            controls_(control_style_mask + e, frame) = 1.0F;
        }
    }
    [[nodiscard]] bool posedAt(int frame) const { return posed_[static_cast<std::size_t>(frame)]; }

    void make(int first) {
        const auto end = changed_.begin() + std::min(first + gesture_window, count_);
        if (std::find(changed_.begin() + first, end, true) == end) return;  // all of it is kept
        const int overlap = first == 0 ? 0 : overlapAt(first);
        MatrixXf controls = controls_.middleCols(first, gesture_window);
        if (network_.shape().controls)
            for (int i = 0; i < overlap; ++i)
                if (!posedAt(first + i)) pin(controls, i, unitDifference(made_.col(first + i)));
        const MatrixXf now = network_.forward(sound_.middleCols(first, gesture_window),
                                              words_.middleCols(first, gesture_window), controls);
        for (int i = 0; i < gesture_window; ++i) {
            const auto share = static_cast<float>(minimumJerk((i + 1.0) / (overlap + 1.0)));
            made_.col(first + i) += share * (now.col(i) - made_.col(first + i));
        }
    }

    /// How many frames of the window before are pinned: fewer where a pose comes soon that it did not see.
    [[nodiscard]] int overlapAt(int first) const {
        if (!network_.shape().controls) return gesture_overlap;
        for (int i = gesture_overlap; i < gesture_overlap + freed_before_pose; ++i)
            if (posedAt(first + i)) return std::clamp(i - freed_before_pose, least_overlap, gesture_overlap);
        return gesture_overlap;
    }

    /// Relative to the mean pose, of a pose whose directions have unit length again.
    [[nodiscard]] VectorXf unitDifference(const VectorXf& difference) const {
        VectorXf pose = difference + mean_;
        for (int b = 0; b < static_cast<int>(upper_bone_count); ++b)
            if (const float length = pose.segment(3 * b, 3).norm(); length > 0.0F)
                pose.segment(3 * b, 3) /= length;
        return pose - mean_;
    }

    const GestureNetwork& network_;
    const VectorXf& mean_;
    int count_;
    int padded_;
    std::vector<bool> changed_;
    std::vector<bool> posed_;
    MatrixXf words_;
    MatrixXf controls_;
    MatrixXf made_;  ///< relative to the mean pose
    MatrixXf sound_;
};

}  // namespace

void appendPosture(const UpperBodyPose& mean_pose, const StyleNorm& norm, NetworkWeights& weights) {
    const VectorXf mean = vectorOf(mean_pose);
    weights.arrays.push_back({"mean_pose", {upper_body_numbers}, {mean.begin(), mean.end()}});
    weights.settings["style_speed_mean"] = norm.mean.speed;
    weights.settings["style_space_mean"] = norm.mean.space;
    weights.settings["style_handedness_mean"] = norm.mean.handedness;
    weights.settings["style_speed_sd"] = norm.sd.speed;
    weights.settings["style_space_sd"] = norm.sd.space;
    weights.settings["style_handedness_sd"] = norm.sd.handedness;
}

Result<SpeechGestureModel> SpeechGestureModel::read(const NetworkWeights& weights) {
    if (weights.architecture != speech_gestures_architecture)
        return fail(weights.file, fmt::format("these are weights of '{}', expected '{}'",
                                              weights.architecture, speech_gestures_architecture));
    const auto shape = readShape(weights);
    if (!shape) return tl::unexpected(shape.error());
    SpeechGestureModel out;
    out.synthetic_ = weights.synthetic;
    Taking take;
    take(out.network_, GestureNetwork::read(weights, *shape));
    take(out.words_, WordVectors::read(weights));
    take(out.mean_, readVector(weights, "mean_pose", upper_body_numbers));
    take(out.style_norm_.mean.speed, weights.number("style_speed_mean"));
    take(out.style_norm_.mean.space, weights.number("style_space_mean"));
    take(out.style_norm_.mean.handedness, weights.number("style_handedness_mean"));
    take(out.style_norm_.sd.speed, weights.number("style_speed_sd"));
    take(out.style_norm_.sd.space, weights.number("style_space_sd"));
    take(out.style_norm_.sd.handedness, weights.number("style_handedness_sd"));
    if (take.problem()) return tl::unexpected(*take.problem());
    const std::vector<double> mean(out.mean_.begin(), out.mean_.end());
    const auto pose = poseFromNumbers(mean);
    if (!pose) return fail(weights.file + ": mean_pose", pose.error().message, pose.error().hint);
    out.mean_pose_ = *pose;
    return out;
}

Result<SpeechGestureModel> SpeechGestureModel::load(const std::filesystem::path& file) {
    const auto weights = readWeights(file, speech_gestures_architecture);
    if (!weights) return tl::unexpected(weights.error());
    return read(*weights);
}

Result<UpperBodyMotion> SpeechGestureModel::generate(const SpeechGestureRequest& request) const {
    if (!(request.duration_s > 0.0 && request.duration_s <= longest_speech_s))
        return fail("speech", fmt::format("found a duration of {} s, expected more than 0 and up to {}",
                                          request.duration_s, longest_speech_s));
    const std::size_t count = frameCountOf(request.duration_s);
    if (const auto checked = checkRequest(request, count, takesControls()); !checked)
        return tl::unexpected(checked.error());
    Frames frames(request, count, network_, words_, mean_);
    frames.makeAll();
    UpperBodyMotion out;
    for (std::size_t f = 0; f < count; ++f)
        out.frames.push_back(
            poseOf(frames.numbersAt(static_cast<int>(f)), f == 0 ? mean_pose_ : out.frames.back()));
    std::vector<PoseControl> exact;
    if (request.exact) exact = request.poses;
    if (request.keep) {
        const std::vector<bool> changed = changedFrames(request, count);
        for (std::size_t f = 0; f < count; ++f)
            if (!changed[f]) exact.push_back({static_cast<int>(f), request.keep->motion.frames[f]});
    }
    meetPoses(out, std::move(exact));
    return out;
}

}  // namespace deixis::motion
