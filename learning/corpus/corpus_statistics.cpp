#include "learning/corpus/corpus_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>

#include "core/text.hpp"

namespace deixis::learning {

namespace {

using motion::Hands;
using motion::SpeechStroke;
using motion::UpperBodyJoints;
using motion::UpperJoint;

MeanAndSd describe(const std::vector<double>& values) {
    MeanAndSd out;
    out.count = static_cast<int>(values.size());
    if (values.empty()) return out;
    double sum = 0.0, squares = 0.0;
    for (const double value : values) sum += value;
    out.mean = sum / out.count;
    for (const double value : values) squares += (value - out.mean) * (value - out.mean);
    out.sd = std::sqrt(squares / out.count);
    return out;
}

Vec3 at(const UpperBodyJoints& joints, UpperJoint joint) {
    return joints[static_cast<std::size_t>(joint)];
}

/// Of one take: joints by frame, and the wrists' speeds on the way to each frame.
struct MeasuredMotion {
    std::vector<UpperBodyJoints> joints;
    std::array<std::vector<double>, 2> wrist_m_s;  // right, left

    explicit MeasuredMotion(const motion::UpperBodyMotion& motion) {
        for (const motion::UpperBodyPose& pose : motion.frames) {
            joints.push_back(jointsOf(pose));
            constexpr std::array wrists{UpperJoint::right_wrist, UpperJoint::left_wrist};
            for (std::size_t h = 0; h < wrists.size(); ++h)
                wrist_m_s[h].push_back(joints.size() < 2
                                           ? 0.0
                                           : glm::length(at(joints.back(), wrists[h]) -
                                                         at(joints[joints.size() - 2], wrists[h])) *
                                                 motion::upper_body_fps);
        }
    }

    [[nodiscard]] std::size_t frameAt(double time_s) const {
        const auto frame =
            static_cast<std::size_t>(std::max(0.0, std::round(time_s * motion::upper_body_fps)));
        return std::min(frame, joints.size() - 1);
    }
};

bool moves(Hands hands, std::size_t hand) {
    return hands == Hands::both || hands == (hand == 0 ? Hands::right : Hands::left);
}

class Collector {
  public:
    void add(const CorpusTake& take) {
        ++out_.takes;
        seconds_ += take.utterance.duration_s;
        out_.words += static_cast<int>(take.utterance.words.size());
        for (const SpokenWord& word : take.utterance.words) forms_.insert(lowerCase(word.text));
        accents_ += static_cast<double>(take.utterance.accents.size());
        if (take.motion.frames.empty()) return;
        const MeasuredMotion measured(take.motion);
        for (std::size_t f = 1; f < measured.joints.size(); ++f) {
            const double right = measured.wrist_m_s[0][f], left = measured.wrist_m_s[1][f];
            wrist_m_s_.push_back(right);
            wrist_m_s_.push_back(left);
            constexpr double still_m_s = 0.1;
            still_ += right < still_m_s && left < still_m_s ? 1.0 : 0.0;
        }
        if (take.strokes.empty()) return;
        utterances_.push_back(take.utterance);
        strokes_.push_back(take.strokes);
        for (const SpeechStroke& stroke : take.strokes)
            if (stroke.hands != Hands::none) addStroke(take, stroke, measured);
    }

    CorpusStatistics finish() {
        out_.minutes = seconds_ / 60.0;
        out_.word_forms = static_cast<int>(forms_.size());
        if (seconds_ > 0.0) out_.accents_per_minute = accents_ / out_.minutes;
        out_.strokes = strokeStatistics(utterances_, strokes_);
        out_.stroke_s = describe(stroke_s_);
        out_.before_accent_s = describe(before_s_);
        out_.hold_s = describe(hold_s_);
        if (!stroke_s_.empty()) out_.both_hands = both_ / static_cast<double>(stroke_s_.size());
        for (std::size_t c = 0; c < out_.places.size(); ++c)
            out_.places[c] = {describe(heights_m_[c]), describe(outward_m_[c])};
        if (!wrist_m_s_.empty()) {
            out_.still = still_ / (static_cast<double>(wrist_m_s_.size()) / 2.0);
            std::ranges::sort(wrist_m_s_);
            out_.wrist_p99_m_s = wrist_m_s_[wrist_m_s_.size() * 99 / 100];
            out_.wrist_most_m_s = wrist_m_s_.back();
        }
        return out_;
    }

  private:
    void addStroke(const CorpusTake& take, const SpeechStroke& stroke, const MeasuredMotion& measured) {
        stroke_s_.push_back(stroke.apex_s - stroke.stroke_s);
        both_ += stroke.hands == Hands::both ? 1.0 : 0.0;
        if (stroke.accent)
            before_s_.push_back(take.utterance.accents[static_cast<std::size_t>(*stroke.accent)].start_s -
                                stroke.stroke_s);
        const std::size_t apex = measured.frameAt(stroke.apex_s);
        const UpperBodyJoints& joints = measured.joints[apex];
        const double shoulders_m =
            0.5 * (at(joints, UpperJoint::right_shoulder).y + at(joints, UpperJoint::left_shoulder).y);
        double height_m = 0.0, hands = 0.0, outward_m = -1.0;
        std::size_t frame = apex + 1;
        for (std::size_t h = 0; h < 2; ++h) {
            if (!moves(stroke.hands, h)) continue;
            const Vec3 wrist = at(joints, h == 0 ? UpperJoint::right_wrist : UpperJoint::left_wrist);
            height_m += wrist.y - shoulders_m;
            hands += 1.0;
            outward_m = std::max(outward_m, h == 0 ? -wrist.x : wrist.x);
        }
        constexpr double held_m_s = 0.3;
        const auto isHeld = [&](std::size_t f) {
            for (std::size_t h = 0; h < 2; ++h)
                if (moves(stroke.hands, h) && measured.wrist_m_s[h][f] >= held_m_s) return false;
            return true;
        };
        while (frame < measured.joints.size() && isHeld(frame)) ++frame;
        if (frame > apex + 1)
            hold_s_.push_back(static_cast<double>(frame - apex - 1) * motion::upper_body_frame_time_s);
        const auto c = static_cast<std::size_t>(stroke.gesture_class);
        heights_m_[c].push_back(height_m / hands);
        outward_m_[c].push_back(outward_m);
    }

    CorpusStatistics out_;
    double seconds_ = 0.0, accents_ = 0.0, still_ = 0.0, both_ = 0.0;
    std::set<std::string> forms_;
    std::vector<Utterance> utterances_;
    std::vector<std::vector<SpeechStroke>> strokes_;
    std::vector<double> stroke_s_, before_s_, hold_s_, wrist_m_s_;
    std::array<std::vector<double>, motion::gesture_class_count> heights_m_, outward_m_;
};

}  // namespace

CorpusStatistics corpusStatistics(std::span<const CorpusTake* const> takes) {
    Collector collector;
    for (const CorpusTake* take : takes) collector.add(*take);
    return collector.finish();
}

CorpusStatistics corpusStatistics(const Corpus& corpus) {
    Collector collector;
    for (const CorpusTake& take : corpus.takes) collector.add(take);
    return collector.finish();
}

}  // namespace deixis::learning
