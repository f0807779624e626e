#include "motion/pointing/phases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/order_statistics.hpp"
#include "motion/skeleton/kinematics.hpp"

namespace deixis::motion {

namespace {

/// Shares of the peak speed at which a hand counts as moving, and as well on its way.
constexpr double moving_share = 0.2;
constexpr double under_way_share = 0.5;
/// Share of the peak speed that makes a stroke of a movement.
constexpr double stroke_share = 0.3;
/// Frames that a gesture takes: one each at rest before and after, and in the hold.
constexpr int min_gesture = 3;

/// The time in which a minimum-jerk movement comes from rest to moving, over that from moving to under way:
/// its speed is (4 u (1 - u))^2 of the largest, so it reaches the share p where u (1 - u) = sqrt(p) / 4.
double slowPart() {
    const auto reached = [](double share) { return 0.5 * (1.0 - std::sqrt(1.0 - std::sqrt(share))); };
    return reached(moving_share) / (reached(under_way_share) - reached(moving_share));
}

/// The speed in one direction of time; 0 is where one looks from.
class View {
  public:
    View(const std::vector<double>& speed, int origin, int step)
        : speed_(speed), origin_(origin), step_(step) {}
    [[nodiscard]] double operator[](int i) const {
        const int index = origin_ + step_ * i;
        return speed_[static_cast<std::size_t>(index)];
    }

  private:
    const std::vector<double>& speed_;
    int origin_;
    int step_;
};

/// Steps from the middle of the hold.
struct Way {
    int reached;   ///< at which the hand comes to its hold
    int departed;  ///< at which it sets out
};

/// Where between two steps the speed passes a value, as a number of steps.
double crossing(const View& v, int slower, int faster, double value) {
    const double rise = v[faster] - v[slower];
    return rise > 0.0 ? slower + (faster - slower) * (value - v[slower]) / rise : slower;
}

/// Where a movement begins whose first moving step, seen from its slow side, is `first`; it is looked at up
/// to `last`, and `first - towards` is slow. `towards`: 1 or -1. One that never gets under way begins there.
double beginOf(const View& v, int first, int last, int towards, double max) {
    const double moving = crossing(v, first - towards, first, moving_share * max);
    for (int i = first; i != last + towards && v[i] >= moving_share * max; i += towards)
        if (v[i] >= under_way_share * max) {
            const double under_way = crossing(v, i - towards, i, under_way_share * max);
            return moving - slowPart() * (under_way - moving);
        }
    return moving;
}

/// The way between rest and hold, seen from the hold: `v[0]` is in its midst, `still` its last step, `out`
/// the last step out of rest, `limit` the farthest one to look at. Both ways are alike, one looked at against
/// time.
Way wayFrom(const View& v, int still, int out, int limit) {
    double max = 0.0;
    for (int i = 0; i <= out; ++i) max = std::max(max, v[i]);
    const auto moves = [&](int i) { return v[i] >= moving_share * max; };
    const auto rounded = [&](double step) {
        return std::clamp(static_cast<int>(std::lround(step)), 0, limit);
    };
    Way way{0, out};
    int first = std::min(still + 1, out);
    while (first > 0 && moves(first - 1)) --first;
    if (first > 0) way.reached = rounded(beginOf(v, first, out, 1, max));
    int last = out;
    while (last < limit && moves(last + 1)) ++last;
    while (last > 1 && !moves(last)) --last;
    way.departed = last < limit ? rounded(beginOf(v, last, 0, -1, max)) : limit;
    return way;
}

/// How many steps from the hold the hand's next movement reaches: to where it all but stops, or turns, that
/// is falls below half its peak speed and then doubles its speed again.
int nearestStop(const View& v, int limit) {
    double max = 0.0;
    int slowest = 0;  // the slowest step since the movement was fastest
    for (int i = 1; i <= limit; ++i) {
        max = std::max(max, v[i]);
        if (v[i] < under_way_share * max && (slowest == 0 || v[i] < v[slowest])) slowest = i;
        if (slowest > 0 && (v[slowest] < moving_share * max || v[i] > 2.0 * v[slowest])) return slowest;
    }
    return limit;
}

double maxOf(const std::vector<double>& values, Run run) {
    return *std::max_element(values.begin() + run.begin, values.begin() + run.end + 1);
}

/// The longest stretch in which a raised hand makes no stroke, and in it the slowest frame.
struct Held {
    Run still;
    int middle = -1;
};
Held holdOf(const Excursion& excursion, const HandTrajectory& trajectory) {
    const Run& run = excursion.frames;
    const auto speed = [&](int f) { return trajectory.speed_m_s[static_cast<std::size_t>(f)]; };
    const auto raised = [&](int f) {
        return trajectory.displacement[static_cast<std::size_t>(f)] >= 0.5 * excursion.farthest;
    };
    const double stroke = stroke_share * maxOf(trajectory.speed_m_s, run);
    Run longest{0, -1};
    for (const Run& still : runsOf(run.begin, run.end, [&](int f) { return raised(f) && speed(f) < stroke; }))
        if (still.frames() > longest.frames()) longest = still;
    const Run& among = longest.frames() > 0 ? longest : run;
    Held held{longest};
    for (int f = among.begin; f <= among.end; ++f)
        if (raised(f) && (held.middle < 0 || speed(f) < speed(held.middle))) held.middle = f;
    if (longest.frames() == 0) held.still = {held.middle, held.middle};
    return held;
}

std::vector<double> displacements(const std::vector<Vec3>& positions, double frame_time_s) {
    constexpr double looked_at_s = 0.1;
    const std::size_t wanted = framesIn(looked_at_s, frame_time_s);
    Vec3 rest{0.0};
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> values;
        for (std::size_t i = 0; i < std::min(positions.size(), wanted); ++i)
            values.push_back(positions[i][axis]);
        rest[axis] = upperMedian(std::move(values));
    }
    std::vector<double> out;
    out.reserve(positions.size());
    for (const Vec3& p : positions) out.push_back(glm::length(p - rest));
    return out;
}

/// Movements that become a stroke, each until it falls below half of that speed.
int strokesOf(const std::vector<double>& speed, Run run) {
    const double stroke = stroke_share * maxOf(speed, run);
    int strokes = 0;
    bool moving = false;
    for (int f = run.begin; f <= run.end; ++f) {
        const double v = speed[static_cast<std::size_t>(f)];
        if (!moving && v >= stroke) ++strokes;
        moving = v >= (moving ? 0.5 * stroke : stroke);
    }
    return strokes;
}

}  // namespace

std::vector<Excursion> excursionsOf(const std::vector<double>& displacement, double back, double out,
                                    int min_rest) {
    const int last = static_cast<int>(displacement.size()) - 1;
    std::vector<Run> runs;
    for (const Run& run :
         runsOf(0, last, [&](int f) { return displacement[static_cast<std::size_t>(f)] > back; })) {
        if (!runs.empty() && run.begin - runs.back().end - 1 < min_rest)
            runs.back().end = run.end;
        else
            runs.push_back(run);
    }
    std::vector<Excursion> found;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const double farthest = maxOf(displacement, runs[i]);
        const Run around{i > 0 ? runs[i - 1].end + 1 : 0, i + 1 < runs.size() ? runs[i + 1].begin - 1 : last};
        if (farthest >= out && around.frames() >= min_gesture) found.push_back({runs[i], around, farthest});
    }
    return found;
}

GesturePhases phasesOf(const Excursion& excursion, const HandTrajectory& trajectory, Side hand) {
    const auto& [frames, around, farthest] = excursion;
    const auto& speed = trajectory.speed_m_s;
    const bool returns = frames.end + 1 < static_cast<int>(speed.size());
    const Held held = holdOf(excursion, trajectory);
    const int middle = std::clamp(held.middle, around.begin + 1, around.end - 1);
    const Way raise = wayFrom(View(speed, middle, -1), std::max(0, middle - held.still.begin),
                              std::max(0, middle - frames.begin), middle - around.begin);
    const Way lower = wayFrom(View(speed, middle, 1), std::max(0, held.still.end - middle),
                              std::max(0, frames.end - middle), around.end - middle);
    GesturePhases out{hand};
    out.onset_frame = std::min(middle - raise.departed, middle - 1);
    out.peak_frame = std::max(middle - raise.reached, out.onset_frame + 1);
    if (returns) {
        out.end_frame = std::max(middle + lower.departed, middle + 1);
        out.hold_frame = std::min(middle + lower.reached, out.end_frame - 1);
    } else {
        out.hold_frame = std::clamp(held.still.end, middle, around.end - 1);
        out.end_frame =
            out.hold_frame + nearestStop(View(speed, out.hold_frame, 1), around.end - out.hold_frame);
    }
    return out;
}

GesturePhases phasesAroundHold(Run hold, Run around, const HandTrajectory& trajectory, Side hand) {
    const auto& speed = trajectory.speed_m_s;
    return {hand, hold.begin - nearestStop(View(speed, hold.begin, -1), hold.begin - around.begin),
            hold.begin, hold.end, hold.end + nearestStop(View(speed, hold.end, 1), around.end - hold.end)};
}

Result<DetectedGesture> detectPhases(const std::vector<Vec3>& hand_positions, Side hand,
                                     double frame_time_s) {
    constexpr double min_displacement_m = 0.10;
    constexpr double back_share = 0.2;
    constexpr double out_share = 0.5;
    constexpr double min_rest_s = 0.1;
    constexpr double still_share = 0.05;
    constexpr double still_m_s = 0.05;
    constexpr double min_hold_s = 0.1;
    for (std::size_t i = 0; i < hand_positions.size(); ++i)
        if (!std::isfinite(hand_positions[i].x + hand_positions[i].y + hand_positions[i].z))
            return fail(
                "", fmt::format("the position of the {} hand in frame {} is not a number", sideName(hand), i),
                "Repair the clip");
    if (hand_positions.size() < min_gesture)
        return fail("", fmt::format("found {} frames, too few for a gesture", hand_positions.size()),
                    "A gesture has at least 3");
    const HandTrajectory trajectory{displacements(hand_positions, frame_time_s),
                                    speeds(hand_positions, frame_time_s)};
    const double farthest = *std::max_element(trajectory.displacement.begin(), trajectory.displacement.end());
    if (farthest < min_displacement_m)
        return fail("",
                    fmt::format("the {} hand stays within {:.3f} m of its rest: no gesture", sideName(hand),
                                farthest),
                    fmt::format("In a gesture the hand moves at least {:.2f} m away", min_displacement_m));
    DetectedGesture out;
    Run whole;
    for (const Excursion& excursion :
         excursionsOf(trajectory.displacement, back_share * farthest, out_share * farthest,
                      static_cast<int>(framesIn(min_rest_s, frame_time_s)))) {
        const GesturePhases found = phasesOf(excursion, trajectory, hand);
        if (whole.end > 0 &&
            found.hold_frame - found.peak_frame <= out.phases.hold_frame - out.phases.peak_frame)
            continue;
        out.phases = found;
        out.returns = excursion.frames.end + 1 < static_cast<int>(hand_positions.size());
        whole = {found.onset_frame, found.end_frame};
    }
    if (whole.end == 0)
        return fail("", fmt::format("the {} hand moves between too few frames: no gesture", sideName(hand)));
    const auto& speed = trajectory.speed_m_s;
    const double still = std::max(still_share * maxOf(speed, whole), still_m_s);
    for (const Run& run : runsOf(out.phases.peak_frame, out.phases.hold_frame,
                                 [&](int f) { return speed[static_cast<std::size_t>(f)] < still; }))
        out.clear_hold =
            out.clear_hold || run.frames() >= static_cast<int>(framesIn(min_hold_s, frame_time_s));
    out.strokes = strokesOf(speed, whole);
    return out;
}

PointingHand recognisedHand(const std::vector<std::vector<Pose>>& world, const HumanoidMap& map) {
    const auto hips = jointTrajectory(world, map[Bone::hips]);
    const auto farthest = [&](Side side) {
        const auto hand = jointTrajectory(world, map[armBones(side).hand]);
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

std::vector<Vec3> jointTrajectory(const std::vector<std::vector<Pose>>& world, int joint) {
    std::vector<Vec3> out;
    out.reserve(world.size());
    for (const auto& frame : world) out.push_back(frame[static_cast<std::size_t>(joint)].position);
    return out;
}

}  // namespace deixis::motion
