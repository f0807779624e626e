#include "motion/gestures/segmentation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "core/order_statistics.hpp"
#include "hand_track.hpp"
#include "motion/humanoid/mapping.hpp"
#include "motion/pointing/phases.hpp"
#include "motion/skeleton/kinematics.hpp"

namespace deixis::motion {

namespace {

using std::to_string;

constexpr std::array sides{Side::left, Side::right};

std::string framesText(Run run) {
    return to_string(run.begin) + " to " + to_string(run.end);
}

std::string handText(Side side) {
    return "the " + std::string(sideName(side)) + " hand";
}

struct HandExcursion : Excursion {
    Side hand = Side::right;
};

class Cutter {
  public:
    Cutter(const Clip& recording, const HumanoidMap& map, const SegmentationOptions& options)
        : options_(options),
          dt_(recording.frame_time_s),
          count_(recording.frameCount()),
          tracks_(trackHands(recording, map)) {}

    Result<Segmentation> cut() {
        for (const Side side : sides) {
            const auto rest = restOf(side);
            if (!rest) return tl::unexpected(rest.error());
            HandTrack& track = tracks_[static_cast<std::size_t>(side)];
            for (const Vec3& reach : track.reach)
                track.trajectory.displacement.push_back(glm::length(reach - *rest));
        }
        for (const Side side : sides) holds_[static_cast<std::size_t>(side)] = holdsOf(side);
        if (options_.by == CutBy::returns)
            cutByReturns();
        else
            cutByHolds();
        std::stable_sort(out_.left_out.begin(), out_.left_out.end(),
                         [](const LeftOut& a, const LeftOut& b) { return a.first < b.first; });
        return std::move(out_);
    }

  private:
    [[nodiscard]] const HandTrack& track(Side side) const { return tracks_[static_cast<std::size_t>(side)]; }
    [[nodiscard]] double displacement(Side side, int frame) const {
        return track(side).trajectory.displacement[static_cast<std::size_t>(frame)];
    }
    [[nodiscard]] double speed(Side side, int frame) const {
        return track(side).trajectory.speed_m_s[static_cast<std::size_t>(frame)];
    }

    /// Where the hand rests, from the shoulder, arm lengths.
    Result<Vec3> restOf(Side side) {
        const auto& reach = track(side).reach;
        if (options_.rest_frame) {
            const int frame = *options_.rest_frame;
            if (frame < 0 || frame >= count_)
                return fail("", "found " + to_string(frame) + " as the frame at rest, expected 0 to " +
                                    to_string(count_ - 1));
            return reach[static_cast<std::size_t>(frame)];
        }
        constexpr double still_m_s = 0.15;
        const double hanging = std::cos(radiansFromDegrees(40.0));
        std::array<std::vector<double>, 3> at_rest;
        for (int f = 0; f < count_; ++f) {
            const Vec3& r = reach[static_cast<std::size_t>(f)];
            if (-r.y < hanging * glm::length(r) || speed(side, f) > still_m_s) continue;
            for (int axis = 0; axis < 3; ++axis) at_rest[static_cast<std::size_t>(axis)].push_back(r[axis]);
        }
        constexpr double min_s = 0.2;
        if (static_cast<double>(at_rest[0].size()) * dt_ >= min_s - 1e-4)
            return Vec3(upperMedian(at_rest[0]), upperMedian(at_rest[1]), upperMedian(at_rest[2]));
        if (options_.by == CutBy::returns)
            return fail("", handText(side) + " never hangs still with the arm down, expected at least 0.2 s",
                        "Name a frame in which both hands are at rest, or cut by holds");
        out_.remarks.push_back(handText(side) +
                               " never hangs still with the arm down: an arm straight down counts as rest");
        return -up;
    }

    /// Slow, straight and raised.
    [[nodiscard]] std::vector<Run> holdsOf(Side side) const {
        const HandTrack& t = track(side);
        auto runs = runsOf(1, count_ - 1, [&](int f) {
            const auto i = static_cast<std::size_t>(f);
            return t.step_speed_m_s[i] < options_.hold_speed_m_s &&
                   glm::length(t.reach[i]) > options_.hold_reach && displacement(side, f) > options_.out;
        });
        runs.erase(
            std::remove_if(runs.begin(), runs.end(),
                           [&](const Run& run) { return run.frames() < framesFor(options_.min_hold_s); }),
            runs.end());
        return runs;
    }

    /// Durations that fall short by rounding alone count as reached.
    [[nodiscard]] int framesFor(double time_s) const {
        return static_cast<int>(std::ceil((time_s - 1e-4) / dt_));
    }

    [[nodiscard]] std::vector<HandExcursion> excursionsOf(Side side) const {
        std::vector<HandExcursion> out;
        for (const Excursion& e : motion::excursionsOf(track(side).trajectory.displacement, options_.back,
                                                       options_.out, framesFor(options_.min_rest_s)))
            if (e.frames.frames() >= framesFor(options_.min_gesture_s)) out.push_back({e, side});
        return out;
    }

    void cutByReturns() {
        std::vector<HandExcursion> excursions = excursionsOf(Side::left);
        for (const HandExcursion& e : excursionsOf(Side::right)) excursions.push_back(e);
        // Of what the two hands do together, the one that goes farther leads.
        std::stable_sort(
            excursions.begin(), excursions.end(),
            [](const HandExcursion& a, const HandExcursion& b) { return a.farthest > b.farthest; });
        std::vector<const HandExcursion*> leading;
        for (const HandExcursion& e : excursions) {
            const auto leader = std::find_if(leading.begin(), leading.end(), [&](const HandExcursion* other) {
                return other->hand != e.hand && together(e.frames, other->frames);
            });
            if (leader == leading.end())
                leading.push_back(&e);
            else
                leaveOut(e.frames, e.hand,
                         "moves along with " + handText((*leader)->hand) + ", which moves farther");
        }
        for (const HandExcursion* e : leading) {
            if (e->frames.begin == 0)
                leaveOut(e->frames, e->hand, "the recording begins when the hand is out of rest");
            else if (e->frames.end == count_ - 1)
                leaveOut(e->frames, e->hand, "the recording ends before the hand is back");
            else
                out_.gestures.push_back(gestureOf(*e, remarksOnOther(*e, excursions)));
        }
        sortGestures();
        shareMargins();
    }

    [[nodiscard]] static std::vector<std::string> remarksOnOther(
        const HandExcursion& e, const std::vector<HandExcursion>& excursions) {
        std::vector<std::string> remarks;
        constexpr double nearly = 0.9;
        for (const HandExcursion& other : excursions)
            if (other.hand != e.hand && together(e.frames, other.frames))
                remarks.push_back(handText(other.hand) + " is out of rest too (frames " +
                                  framesText(other.frames) + ")" +
                                  (other.farthest > nearly * e.farthest ? " and moves as far" : ""));
        return remarks;
    }

    /// More than half of the shorter one lies in the other.
    static bool together(Run a, Run b) {
        const int common = std::min(a.end, b.end) - std::max(a.begin, b.begin) + 1;
        return 2 * common > std::min(a.end - a.begin, b.end - b.begin) + 1;
    }

    Gesture gestureOf(const HandExcursion& e, std::vector<std::string> remarks) const {
        const GesturePhases phases = phasesOf(e, track(e.hand).trajectory, e.hand);
        double reach = 0.0;
        for (int f = phases.peak_frame; f <= phases.hold_frame; ++f)
            reach = std::max(reach, glm::length(track(e.hand).reach[static_cast<std::size_t>(f)]));
        constexpr double bent = 0.8;
        if (reach < bent) remarks.emplace_back("the arm stays bent");
        constexpr double min_stop_s = 0.1;
        if ((phases.hold_frame - phases.peak_frame) * dt_ < min_stop_s)
            remarks.emplace_back("the hand does not stop");
        const auto& holds = holds_[static_cast<std::size_t>(e.hand)];
        const auto several = std::count_if(holds.begin(), holds.end(), [&](const Run& hold) {
            return hold.begin >= e.frames.begin && hold.end <= e.frames.end;
        });
        if (several > 1) remarks.push_back("holds " + to_string(several) + " times before the hand is back");
        return gesture(phases, e.around, std::move(remarks));
    }

    [[nodiscard]] Gesture gesture(const GesturePhases& phases, Run around,
                                  std::vector<std::string> remarks) const {
        const int margin = static_cast<int>(std::lround(options_.margin_s / dt_));
        return {std::max(around.begin, phases.onset_frame - margin),
                std::min(around.end, phases.end_frame + margin), phases, std::move(remarks)};
    }

    void cutByHolds() {
        for (const Side side : sides) {
            const auto& holds = holds_[static_cast<std::size_t>(side)];
            for (std::size_t i = 0; i < holds.size(); ++i) {
                const Run& hold = holds[i];
                const auto between = [](const Run& a, const Run& b) { return (a.end + b.begin) / 2; };
                const Run around{i > 0 ? between(holds[i - 1], hold) : 0,
                                 i + 1 < holds.size() ? between(hold, holds[i + 1]) : count_ - 1};
                if (hold.end == count_ - 1) {
                    leaveOut(hold, side, "the recording ends during the hold");
                    continue;
                }
                std::vector<std::string> remarks;
                for (const Run& other : holds_[static_cast<std::size_t>(opposite(side))])
                    if (std::min(hold.end, other.end) >= std::max(hold.begin, other.begin))
                        remarks.push_back(handText(opposite(side)) + " holds too (frames " +
                                          framesText(other) + ")");
                out_.gestures.push_back(gesture(phasesAroundHold(hold, around, track(side).trajectory, side),
                                                around, std::move(remarks)));
            }
        }
        sortGestures();
    }

    void leaveOut(Run frames, Side hand, std::string why) {
        out_.left_out.push_back({frames.begin, frames.end, hand, std::move(why)});
    }

    void sortGestures() {
        std::stable_sort(out_.gestures.begin(), out_.gestures.end(), [](const Gesture& a, const Gesture& b) {
            return a.phases.onset_frame < b.phases.onset_frame;
        });
    }

    /// The rest between two gestures is shared where it is short.
    void shareMargins() {
        for (std::size_t i = 1; i < out_.gestures.size(); ++i) {
            Gesture& before = out_.gestures[i - 1];
            Gesture& after = out_.gestures[i];
            const int end = before.phases.end_frame;
            const int onset = after.phases.onset_frame;
            if (end >= onset) {
                before.last = end;
                after.first = onset;
                after.remarks.push_back("starts before " + handText(before.phases.hand) + " is back");
                continue;
            }
            const int middle = (end + onset) / 2;
            before.last = std::min(before.last, middle);
            after.first = std::max(after.first, middle + 1);
        }
    }

    const SegmentationOptions& options_;
    double dt_;
    int count_;
    std::vector<HandTrack> tracks_;  // by Side, as all below
    std::array<std::vector<Run>, 2> holds_;
    Segmentation out_;
};

Result<void> checkFigure(const Clip& recording, const HumanoidMap& map) {
    using enum Bone;
    auto missing = missingBones(map, pointingBones());
    for (const Bone bone : {leftUpperLeg, rightUpperLeg})
        if (!map.has(bone)) missing.emplace_back(boneName(bone));
    if (!missing.empty())
        return fail("",
                    fmt::format("no joint was found for {}, expected a figure with hips and two arms",
                                fmt::join(missing, ", ")),
                    "Name the joints as VRM, Mixamo, CMU or another common rig does");
    Vec3 trunk(0.0);
    double arms = 0.0;
    std::vector<Pose> world;
    for (const LocalPose& frame : recording.frames) {
        worldPose(recording.skeleton, frame, world);
        const auto at = [&](Bone bone) { return world[static_cast<std::size_t>(map[bone])].position; };
        const Vec3 along = 0.5 * (at(leftUpperArm) + at(rightUpperArm)) - at(hips);
        if (glm::length(along) > 0.0) trunk += glm::normalize(along);
        arms = std::max(arms, glm::length(at(leftHand) - at(leftUpperArm)) *
                                  glm::length(at(rightHand) - at(rightUpperArm)));
    }
    if (!(arms > 0.0)) return fail("", "an arm has no length, expected shoulder, elbow and hand apart");
    if (!(trunk.y > 0.7 * glm::length(trunk)))
        return fail("", "the figure does not stand upright, expected a person whose trunk points along y",
                    "Turn the recording so that y is up");
    return {};
}

}  // namespace

Result<Segmentation> segment(const Clip& recording, const HumanoidMap& map,
                             const SegmentationOptions& options) {
    if (const auto checked = checkFigure(recording, map); !checked) return tl::unexpected(checked.error());
    return Cutter(recording, map, options).cut();
}

}  // namespace deixis::motion
