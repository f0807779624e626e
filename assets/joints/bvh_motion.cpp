#include "bvh_motion.hpp"

#include <algorithm>
#include <cmath>

#include "assets/joints/decimal.hpp"
#include "bvh_text.hpp"

namespace deixis::assets {

namespace {

using motion::LocalPose;

/// Poses may take so much memory: a joint without channels costs the file nothing, but every pose holds it.
constexpr std::size_t always_allowed_bytes = std::size_t{64} << 20U;
constexpr std::size_t allowed_bytes_a_character = 64;

/// turn = turn * (rotation by `degrees` about an axis)
void turnAbout(int axis, double degrees, Quat& turn) {
    const double half = 0.5 * radiansFromDegrees(degrees);
    const double c = std::cos(half);
    const double s = std::sin(half);
    const Quat q = turn;
    if (axis == 0)
        turn = Quat(q.w * c - q.x * s, q.w * s + q.x * c, q.y * c + q.z * s, q.z * c - q.y * s);
    else if (axis == 1)
        turn = Quat(q.w * c - q.y * s, q.x * c - q.z * s, q.w * s + q.y * c, q.z * c + q.x * s);
    else
        turn = Quat(q.w * c - q.z * s, q.x * c + q.y * s, q.y * c - q.x * s, q.w * s + q.z * c);
}

void fill(const std::vector<double>& values, const BvhChannels& channels, LocalPose& pose) {
    const double* next = values.data();
    for (std::size_t j = 0; j < channels.size(); ++j) {
        Pose& joint = pose.joints[j];
        for (const BvhChannel& channel : channels[j]) {
            const double value = *next++;
            if (!channel.rotation)
                joint.position[channel.axis] = value;
            else if (value != 0.0)
                turnAbout(channel.axis, value, joint.orientation);
        }
    }
}

class MotionReader {
  public:
    MotionReader(const BvhMotionText& motion, const BvhChannels& channels, motion::Clip& clip)
        : motion_(motion),
          channels_(channels),
          clip_(clip),
          at_(motion.text.data()),
          end_(at_ + motion.text.size()) {
        std::size_t values = 0;
        for (const auto& joint : channels) values += joint.size();
        values_.resize(values);
    }

    Result<void> read() {
        const std::string declared = std::to_string(motion_.frame_count) + " as 'Frames:' says";
        // The declared number may be nonsense; the characters left bound what there can be.
        clip_.frames.reserve(std::min(motion_.frame_count, motion_.text.size() / (2 * values_.size()) + 1));
        const LocalPose rest = motion::restPose(clip_.skeleton);
        const std::size_t pose_bytes = sizeof(LocalPose) + rest.joints.size() * sizeof(Pose);
        const std::size_t max_frames =
            (always_allowed_bytes + allowed_bytes_a_character * motion_.text.size()) / pose_bytes;
        for (;;) {
            while (at_ < end_ && (isBlank(*at_) || *at_ == '\n')) ++at_;
            if (at_ == end_) break;
            if (clip_.frames.size() == motion_.frame_count)
                return wrong("found more lines of motion, expected " + declared);
            if (clip_.frames.size() == max_frames)
                return wrong("found more than " + std::to_string(max_frames) + " frames of " +
                             std::to_string(rest.joints.size()) +
                             " joints, of which few have channels; "
                             "expected a figure whose joints move");
            if (auto line = readLine(); !line) return line;
            clip_.frames.push_back(rest);
            fill(values_, channels_, clip_.frames.back());
        }
        if (clip_.frames.size() != motion_.frame_count)
            return wrong("found the end of the file after " + std::to_string(clip_.frames.size()) +
                         " frames, expected " + declared);
        return {};
    }

  private:
    /// Reads the numbers of one line; at_ stands on the first.
    Result<void> readLine() {
        const std::size_t expected = values_.size();
        std::size_t count = 0;
        do {
            double value = 0.0;
            const char* stop = readDecimal(at_, end_, value);
            if (stop == nullptr || !(stop == end_ || isBlank(*stop) || *stop == '\n') ||
                !std::isfinite(value)) {
                const auto unusual = unusualNumber();
                if (!unusual) return tl::unexpected(unusual.error());
                value = *unusual;
            } else {
                at_ = stop;
            }
            if (count < expected) values_[count] = value;
            ++count;
            while (at_ < end_ && isBlank(*at_)) ++at_;
        } while (at_ < end_ && *at_ != '\n');
        if (count != expected)
            return wrong("found " + std::to_string(count) + " values, expected " + std::to_string(expected) +
                         ", one for each channel");
        return {};
    }

    /// The word at at_ as a number that the quick way did not take, such as "+1".
    Result<double> unusualNumber() {
        BvhText text(std::string_view(at_, static_cast<std::size_t>(end_ - at_)));
        const std::string_view word = text.wordOfLine();
        const auto value = wholeNumber(word, where(), "a channel");
        at_ = word.data() + word.size();
        return value;
    }

    [[nodiscard]] std::string where() const {
        const auto lines = std::count(motion_.text.data(), at_, '\n');
        return motion_.name + ":" + std::to_string(motion_.first_line + lines);
    }
    [[nodiscard]] tl::unexpected<Error> wrong(std::string message) const {
        return fail(where(), std::move(message));
    }

    const BvhMotionText& motion_;
    const BvhChannels& channels_;
    motion::Clip& clip_;
    const char* at_;
    const char* end_;
    std::vector<double> values_;
};

}  // namespace

Result<void> readBvhMotion(const BvhMotionText& motion, const BvhChannels& channels, motion::Clip& clip) {
    return MotionReader(motion, channels, clip).read();
}

}  // namespace deixis::assets
