#include "simulated_observer.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>

#include "motion/skeleton/kinematics.hpp"

namespace deixis::studies {

namespace {

constexpr double raised_share = 0.6;    ///< of the largest displacement: there the hand counts as raised
constexpr double still_share = 0.25;    ///< of the peak speed: slower, a raised hand counts as held
constexpr double started_share = 0.05;  ///< of the peak speed: slower, the raise has not begun

double turn_deg(const Quat& a, const Quat& b) {
    return degreesFromRadians(2.0 * std::acos(std::min(1.0, std::abs(glm::dot(a, b)))));
}

}  // namespace

GestureObserver::GestureObserver(const motion::Skeleton& avatar, const Reading& reading)
    : avatar_(avatar), map_(motion::mapByVrmNames(avatar)), reading_(reading) {
    using motion::Bone;
    for (const Bone bone : motion::pointingBones())
        if (!map_.has(bone))
            throw std::invalid_argument("the avatar has no joint " + std::string(motion::boneName(bone)));
    for (const Bone bone : {Bone::hips, Bone::spine, Bone::upperChest, Bone::chest})
        if (map_.has(bone)) trunk_ = map_[bone];
    seen_.reserve(512);
}

void GestureObserver::forget() {
    seen_.clear();
}

void GestureObserver::see(const std::vector<Pose>& stage_from_joint, double time_s) {
    ObservedFrame& observed = seen_.emplace_back();
    observed.time_s = time_s;
    for (const motion::Side side : {motion::Side::left, motion::Side::right}) {
        const auto index = static_cast<std::size_t>(side);
        observed.tip[index] = motion::fingertipPosition(avatar_, map_, stage_from_joint, side);
        observed.lines[index] = armLines(avatar_, map_, stage_from_joint, side, reading_);
    }
    observed.head = stage_from_joint[static_cast<std::size_t>(map_[motion::Bone::head])].orientation;
    observed.trunk = stage_from_joint[static_cast<std::size_t>(trunk_)].orientation;
}

/// The longest run of frames in which the hand is raised and slow; the frame of the largest displacement
/// where there is none.
GestureObserver::Span GestureObserver::holdOf(const std::vector<Vec3>& tip,
                                              const std::vector<double>& speed) {
    std::vector<double> displacement;
    for (const Vec3& place : tip) displacement.push_back(glm::length(place - tip.front()));
    const auto farthest = std::max_element(displacement.begin(), displacement.end());
    const double peak_speed = *std::max_element(speed.begin(), speed.end());
    const auto peak = static_cast<std::size_t>(farthest - displacement.begin());
    Span best{peak, peak};
    std::size_t length = 0;
    std::size_t run = 0;
    for (std::size_t i = 1; i < tip.size(); ++i) {
        const bool held = displacement[i] >= raised_share * *farthest && speed[i] <= still_share * peak_speed;
        run = held ? run + 1 : 0;
        if (run <= length) continue;
        length = run;
        best = {i + 1 - run, i};
    }
    return best;
}

SeenGesture GestureObserver::gesture() const {
    SeenGesture seen;
    if (seen_.size() < 2) return seen;

    // The hand that moved farther is the one that points.
    std::array<double, 2> reach{0.0, 0.0};
    for (const ObservedFrame& observed : seen_)
        for (std::size_t side = 0; side < 2; ++side)
            reach[side] = std::max(reach[side], glm::length(observed.tip[side] - seen_.front().tip[side]));
    const std::size_t side = reach[0] > reach[1] ? 0 : 1;
    seen.hand = side == 0 ? motion::Side::left : motion::Side::right;

    std::vector<double> times_s;
    std::vector<Vec3> tip;
    for (const ObservedFrame& observed : seen_) {
        times_s.push_back(observed.time_s);
        tip.push_back(observed.tip[side]);
    }
    const std::vector<double> speed = motion::speedsAt(times_s, tip);
    const Span hold = holdOf(tip, speed);
    std::vector<ArmLines> held;
    for (std::size_t i = hold.first; i <= hold.last; ++i) held.push_back(seen_[i].lines[side]);
    seen.lines = meanOf(held);
    seen.at_first = held.front();
    seen.at_last = held.back();
    seen.hold_middle_s = 0.5 * (seen_[hold.first].time_s + seen_[hold.last].time_s);
    for (std::size_t i = hold.first; i <= hold.last; ++i) seen.hold_speed_m_s += speed[i];
    seen.hold_speed_m_s /= static_cast<double>(hold.last - hold.first + 1);

    // The raise: back from the hold to where the hand was last almost still.
    const double peak =
        *std::max_element(speed.begin() + 1, speed.begin() + static_cast<std::ptrdiff_t>(hold.first) + 1);
    std::size_t start = hold.first;
    while (start > 1 && speed[start - 1] <= started_share * peak)
        --start;  // the approach to the hold may be slow
    while (start > 1 && speed[start - 1] > started_share * peak) --start;
    double length_m = 0.0;
    for (std::size_t i = start; i < hold.first; ++i) length_m += speed[i];
    const auto raise_frames = static_cast<double>(hold.first - start);
    if (length_m > 0.0) seen.peak_over_mean = peak * raise_frames / length_m;

    const ObservedFrame& before = seen_[start > 1 ? start - 1 : 0];
    const ObservedFrame& during = seen_[(hold.first + hold.last) / 2];
    seen.participation_deg = turn_deg(before.head, during.head) + turn_deg(before.trunk, during.trunk);
    return seen;
}

}  // namespace deixis::studies
