#include "motion/pointing/pointing_phases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "motion/skeleton/kinematics.hpp"

namespace deixis::motion {

namespace {

struct Span {
    int first = 0;
    int last = 0;
    [[nodiscard]] int length() const { return last - first; }
};

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Vec3 restingPlace(const std::vector<Vec3>& positions, double frame_time_s) {
    constexpr double looked_at_s = 0.1;
    const auto wanted = static_cast<std::size_t>(std::max(1.0, std::min(looked_at_s / frame_time_s, 1e6)));
    const std::size_t count = std::min(positions.size(), wanted);
    Vec3 out{0.0};
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (std::size_t i = 0; i < count; ++i) values.push_back(positions[i][axis]);
        out[axis] = median(std::move(values));
    }
    return out;
}

std::vector<double> displacements(const std::vector<Vec3>& positions, double frame_time_s) {
    const Vec3 rest = restingPlace(positions, frame_time_s);
    std::vector<double> out;
    out.reserve(positions.size());
    for (const Vec3& p : positions) out.push_back(glm::length(p - rest));
    return out;
}

class Detector {
  public:
    Detector(const std::vector<Vec3>& positions, double frame_time_s, const PhaseThresholds& thresholds)
        : speed_(speeds(positions, frame_time_s)),
          displacement_(displacements(positions, frame_time_s)),
          least_hold_frames_(
              static_cast<int>(std::lround(std::min(thresholds.least_hold_s / frame_time_s, 1e9)))),
          run_out_frames_(static_cast<int>(std::lround(std::min(thresholds.run_out_s / frame_time_s, 1e9)))) {
        const double fastest = *std::max_element(speed_.begin(), speed_.end());
        still_ = std::max(thresholds.still_share * fastest, thresholds.still_mps);
        moving_ = std::max(thresholds.stroke_share * fastest, still_);
        raised_ = thresholds.raised_share * *std::max_element(displacement_.begin(), displacement_.end());
        findStrokes();
    }

    GesturePhases phases(Side hand) {
        GesturePhases out;
        out.hand = hand;
        const int stroke = strokeBeforeHold();
        const auto held = stroke >= 0 ? holdAfter(stroke) : slowestRaised();
        out.peak_frame = held.first;
        out.hold_frame = held.last;
        out.clear_hold = longestStill(held) >= least_hold_frames_ && held.length() > 0;
        bracket(out);
        return out;
    }

  private:
    [[nodiscard]] int lastFrame() const { return static_cast<int>(speed_.size()) - 1; }
    [[nodiscard]] double speed(int frame) const { return speed_[static_cast<std::size_t>(frame)]; }
    [[nodiscard]] double displacement(int frame) const {
        return displacement_[static_cast<std::size_t>(frame)];
    }
    [[nodiscard]] bool raised(int frame) const { return displacement(frame) >= raised_; }

    /// Runs of frames at or above `moving_`; runs between which the hand is never slower than `still_`
    /// belong to one stroke.
    void findStrokes() {
        bool still_since = true;
        for (int f = 0; f <= lastFrame(); ++f) {
            if (speed(f) < still_) still_since = true;
            if (speed(f) < moving_) continue;
            const bool joins = !strokes_.empty() && (strokes_.back().last == f - 1 || !still_since) &&
                               !turnsRaised(strokes_.back().last, f);
            if (joins)
                strokes_.back().last = f;
            else
                strokes_.push_back({f, f});
            still_since = false;
        }
    }

    /// Whether the hand, raised between two frames, slows down to less than half of what makes a stroke.
    [[nodiscard]] bool turnsRaised(int from, int to) const {
        for (int f = from + 1; f < to; ++f)
            if (raised(f) && speed(f) < 0.5 * moving_) return true;
        return false;
    }

    /// Index of the stroke after which the longest raised pause follows, or -1.
    [[nodiscard]] int strokeBeforeHold() const {
        int best = -1;
        int longest = -1;
        for (std::size_t i = 0; i < strokes_.size(); ++i) {
            const int from = strokes_[i].last;
            const int to = i + 1 < strokes_.size() ? strokes_[i + 1].first : lastFrame();
            int raised_frames = 0;
            for (int f = from; f <= to; ++f) raised_frames += raised(f) ? 1 : 0;
            if (2 * raised_frames <= to - from + 1 || !raised(slowest(from, to))) continue;
            if (to - from > longest) {
                longest = to - from;
                best = static_cast<int>(i);
            }
        }
        return best;
    }

    [[nodiscard]] int slowest(int from, int to) const {
        int best = from;
        for (int f = from; f <= to; ++f)
            if (speed(f) < speed(best)) best = f;
        return best;
    }

    /// From the stroke's end on to where the hand is still, and back from the next one's beginning.
    [[nodiscard]] Span holdAfter(int stroke) const {
        const auto index = static_cast<std::size_t>(stroke);
        const int from = strokes_[index].last;
        const int to = index + 1 < strokes_.size() ? strokes_[index + 1].first : lastFrame();
        Span span{from, to};
        while (span.first < to && speed(span.first) >= still_ && !slowestNearby(span.first, to)) ++span.first;
        while (span.last > span.first && speed(span.last) >= still_ && !slowestNearby(span.last, from))
            --span.last;
        span.first = ranOut(span.first, span.last);
        span.last = ranOut(span.last, span.first);
        return span;
    }

    /// A movement slows down to nothing: on from the frame in which it falls below the threshold, as long as
    /// the speed goes on falling to a tenth of it, for at most run_out_s.
    [[nodiscard]] int ranOut(int frame, int towards) const {
        const int step = towards > frame ? 1 : -1;
        for (int i = 0; i < run_out_frames_ && frame != towards; ++i) {
            if (speed(frame) < 0.1 * still_ || speed(frame + step) >= speed(frame)) break;
            frame += step;
        }
        return frame;
    }

    /// A frame from which on the hand gets no slower: the end of a stroke that runs into another movement.
    [[nodiscard]] bool slowestNearby(int frame, int towards) const {
        const int step = towards > frame ? 1 : -1;
        constexpr int looked_at = 3;
        for (int i = 1; i <= looked_at; ++i) {
            const int f = frame + step * i;
            if (f < 0 || f > lastFrame()) break;
            if (speed(f) < speed(frame)) return false;
        }
        return true;
    }

    [[nodiscard]] Span slowestRaised() const {
        int best = -1;
        for (int f = 0; f <= lastFrame(); ++f)
            if (raised(f) && (best < 0 || speed(f) < speed(best))) best = f;
        return {best, best};
    }

    [[nodiscard]] int longestStill(const Span& span) const {
        int longest = 0;
        int run = 0;
        for (int f = span.first; f <= span.last; ++f) {
            run = speed(f) < still_ ? run + 1 : 0;
            longest = std::max(longest, run);
        }
        return longest;
    }

    /// Onset and end: where the hand was and is at rest, not raised and still.
    void bracket(GesturePhases& out) const {
        const auto resting = [&](int f) { return !raised(f) && speed(f) < still_; };
        int onset = out.peak_frame;
        while (onset > 0 && !resting(onset)) --onset;
        int end = out.hold_frame;
        while (end < lastFrame() && !resting(end)) ++end;
        out.returns = end > out.hold_frame && resting(end);
        out.onset_frame = ranOut(std::min(onset, std::max(0, out.peak_frame - 1)), 0);
        out.end_frame = ranOut(end, lastFrame());
        for (const Span& stroke : strokes_)
            if (stroke.last >= onset && stroke.first <= end) ++out.strokes;
        out.peak_speed_frame = out.onset_frame;
        for (int f = out.onset_frame; f <= out.peak_frame; ++f)
            if (speed(f) > speed(out.peak_speed_frame)) out.peak_speed_frame = f;
        out.peak_speed_mps = speed(out.peak_speed_frame);
    }

    std::vector<double> speed_;
    std::vector<double> displacement_;
    int least_hold_frames_;
    int run_out_frames_;
    double still_ = 0.0;
    double moving_ = 0.0;
    double raised_ = 0.0;
    std::vector<Span> strokes_;
};

}  // namespace

Result<GesturePhases> detectPhases(const std::vector<Vec3>& hand_positions, Side hand, double frame_time_s,
                                   const PhaseThresholds& thresholds) {
    for (std::size_t i = 0; i < hand_positions.size(); ++i)
        if (!std::isfinite(hand_positions[i].x + hand_positions[i].y + hand_positions[i].z))
            return fail(
                "", fmt::format("the position of the {} hand in frame {} is no number", sideName(hand), i),
                "Repair the clip");
    if (hand_positions.size() < 3)
        return fail("", fmt::format("found {} frames, too few for a gesture", hand_positions.size()),
                    "A gesture has at least 3");
    const auto away = displacements(hand_positions, frame_time_s);
    const double farthest = *std::max_element(away.begin(), away.end());
    if (farthest < thresholds.least_displacement_m)
        return fail(
            "",
            fmt::format("the {} hand stays within {:.3f} m of where it rests: no gesture", sideName(hand),
                        farthest),
            fmt::format("A gesture takes the hand at least {:.2f} m away", thresholds.least_displacement_m));
    return Detector(hand_positions, frame_time_s, thresholds).phases(hand);
}

PointingHand recognisedHand(const std::vector<std::vector<Pose>>& world, const HumanoidMap& map) {
    const auto hips = jointCourse(world, map[Bone::hips]);
    const auto farthest = [&](Side side) {
        const auto hand = jointCourse(world, map[armBones(side).hand]);
        double out = 0.0;
        for (std::size_t f = 0; f < hand.size(); ++f)
            out = std::max(out, glm::length((hand[f] - hips[f]) - (hand[0] - hips[0])));
        return out;
    };
    const double left = farthest(Side::left);
    const double right = farthest(Side::right);
    if (left > right) return {Side::left, left, right};
    return {Side::right, right, left};
}

std::vector<std::vector<Pose>> worldPoses(const Clip& clip) {
    std::vector<std::vector<Pose>> out(clip.frames.size());
    for (std::size_t f = 0; f < out.size(); ++f) worldPose(clip.skeleton, clip.frames[f], out[f]);
    return out;
}

std::vector<Vec3> jointCourse(const std::vector<std::vector<Pose>>& world, int joint) {
    std::vector<Vec3> out;
    out.reserve(world.size());
    for (const auto& frame : world) out.push_back(frame[static_cast<std::size_t>(joint)].position);
    return out;
}

}  // namespace deixis::motion
