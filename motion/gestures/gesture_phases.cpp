#include "gesture_phases.hpp"

#include <algorithm>
#include <cmath>

namespace deixis::motion {

namespace {

/// Shares of the greatest speed at which a hand counts as moving, and as well on its way.
constexpr double moving_share = 0.2;
constexpr double under_way_share = 0.5;

/// The time in which a minimum-jerk movement comes from rest to moving, over that from moving to under way:
/// its speed is (4 u (1 - u))^2 of the greatest, so it reaches the share p where u (1 - u) = sqrt(p) / 4.
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
        const int frame = origin_ + step_ * i;
        return speed_[static_cast<std::size_t>(frame)];
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
double beginOf(const View& v, int first, int last, int towards, double greatest) {
    const double moving = crossing(v, first - towards, first, moving_share * greatest);
    for (int i = first; i != last + towards && v[i] >= moving_share * greatest; i += towards)
        if (v[i] >= under_way_share * greatest) {
            const double under_way = crossing(v, i - towards, i, under_way_share * greatest);
            return moving - slowPart() * (under_way - moving);
        }
    return moving;
}

/// The way between rest and hold, seen from the hold: `v[0]` is the middle of the hold, `out` the last step
/// out of rest, `limit` the farthest one to look at. Both ways are alike, one looked at against time.
Way wayFrom(const View& v, int out, int limit) {
    double greatest = 0.0;
    for (int i = 0; i <= out; ++i) greatest = std::max(greatest, v[i]);
    const auto moves = [&](int i) { return v[i] >= moving_share * greatest; };
    const auto rounded = [&](double step) {
        return std::clamp(static_cast<int>(std::lround(step)), 0, limit);
    };
    Way way{0, out};
    if (!moves(0)) {
        int first = 1;
        while (first < out && !moves(first)) ++first;
        way.reached = rounded(beginOf(v, first, out, 1, greatest));
    }
    int last = out;
    while (last < limit && moves(last + 1)) ++last;
    while (last > 1 && !moves(last)) --last;
    way.departed = last < limit ? rounded(beginOf(v, last, 0, -1, greatest)) : limit;
    return way;
}

/// How many steps from the hold the hand's next movement reaches: to where it all but stops, or turns, that
/// is falls below half its greatest speed and then doubles its speed again.
int nearestStop(const View& v, int limit) {
    double greatest = 0.0;
    int slowest = 0;  // the slowest step since the movement was fastest
    for (int i = 1; i <= limit; ++i) {
        greatest = std::max(greatest, v[i]);
        if (v[i] < under_way_share * greatest && (slowest == 0 || v[i] < v[slowest])) slowest = i;
        if (slowest > 0 && (v[slowest] < moving_share * greatest || v[i] > 2.0 * v[slowest])) return slowest;
    }
    return limit;
}

}  // namespace

GestureFrames gesturePhases(const std::vector<double>& speed, int from, int leaves, int middle,
                            int comes_back, int to) {
    const Way raise = wayFrom(View(speed, middle, -1), middle - leaves, middle - from);
    const Way lower = wayFrom(View(speed, middle, 1), comes_back - middle, to - middle);
    GestureFrames out;
    out.onset = std::min(middle - raise.departed, middle - 1);
    out.end = std::max(middle + lower.departed, middle + 1);
    out.peak = std::max(middle - raise.reached, out.onset + 1);
    out.hold = std::min(middle + lower.reached, out.end - 1);
    return out;
}

GestureFrames phasesAroundHold(const std::vector<double>& speed, int from, int peak, int hold, int to) {
    return {peak - nearestStop(View(speed, peak, -1), peak - from), peak, hold,
            hold + nearestStop(View(speed, hold, 1), to - hold)};
}

}  // namespace deixis::motion
