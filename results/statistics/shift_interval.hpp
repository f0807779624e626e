// The shifts that a rank test does not reject: confidence intervals as the inversion of the very test that is
// reported, with its ties and its zeros.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

namespace deixis::results {

/// p is constant between neighbouring places (pairwise means or differences), and may be another at them,
/// where values tie or become zero.
enum class Near : unsigned char { below, at, above };

/// In units of the places.
template <typename Int>
struct ShiftInterval {
    Int lower{};
    Int upper{};
    bool lower_included = true;
    bool upper_included = true;
    double outside_p = 0.0;  ///< the largest p just outside its ends
};

/// One end. `Places` has min(), max(), before(place) and after(place); p(place, near) is the p of the
/// test of a shift there.
template <typename Int, typename Places, typename P>
class IntervalEnd {
  public:
    IntervalEnd(const Places& places, const P& p, double alpha, bool is_lower)
        : places_(places), p_(p), alpha_(alpha), is_lower_(is_lower) {}

    /// Begins at `place`; looks for shifts that are not rejected beyond those that are, too, up to
    /// `max_looks` places further out. False where every shift from `place` inwards is rejected. A place by
    /// itself, at which values vanish or tie, does not make the interval longer.
    bool find(Int place, int max_looks) {
        place_ = place;
        while (!accepts(place_, outer()) && !accepts(place_, inner())) {
            if (place_ == innermost()) return false;
            place_ = is_lower_ ? places_.after(place_) : places_.before(place_);
        }
        for (;;) {
            while (place_ != outermost() && accepts(place_, outer())) place_ = outwards(place_);
            Int beyond = place_;
            bool found = false;
            for (int looks = 0; looks < max_looks && beyond != outermost() && !found; ++looks) {
                beyond = outwards(beyond);
                const double p = pOf(beyond, outer());
                found = p > alpha_;
                if (p < 0.5 * alpha_) break;
            }
            if (!found) break;
            place_ = beyond;
        }
        // Where not even the widest interval reaches the level, it is given with its own.
        outside_p_ = pOf(place_, outer());
        included_ = outside_p_ > alpha_ || accepts(place_, Near::at);
        if (!included_) outside_p_ = std::max(outside_p_, pOf(place_, Near::at));
        return true;
    }
    [[nodiscard]] const Int& place() const { return place_; }
    [[nodiscard]] bool included() const { return included_; }
    [[nodiscard]] double outsideP() const { return outside_p_; }

  private:
    [[nodiscard]] bool accepts(const Int& place, Near near) { return pOf(place, near) > alpha_; }
    /// The last one is kept: of large samples an exact p takes long, and most are asked for twice.
    [[nodiscard]] double pOf(const Int& place, Near near) {
        if (!last_ || last_->near != near || last_->place != place) last_ = {place, near, p_(place, near)};
        return last_->p;
    }
    [[nodiscard]] Near outer() const { return is_lower_ ? Near::below : Near::above; }
    [[nodiscard]] Near inner() const { return is_lower_ ? Near::above : Near::below; }
    [[nodiscard]] Int outermost() const { return is_lower_ ? places_.min() : places_.max(); }
    [[nodiscard]] Int innermost() const { return is_lower_ ? places_.max() : places_.min(); }
    [[nodiscard]] Int outwards(const Int& place) const {
        return is_lower_ ? places_.before(place) : places_.after(place);
    }

    const Places& places_;
    const P& p_;
    double alpha_;
    bool is_lower_;
    Int place_{};
    bool included_ = true;
    double outside_p_ = 0.0;
    struct Known {
        Int place;
        Near near;
        double p;
    };
    std::optional<Known> last_{};
};

/// From the smallest to the largest shift with p > alpha; `low` and `high` are places near the
/// ends, `middle` the one in the middle. It holds 0
/// exactly where the test itself does not reject 0: where the test does and shifts on both sides of it are
/// not rejected, the interval ends at 0, on the side that is rejected less. None where every shift is
/// rejected.
template <typename Int, typename Places, typename P>
std::optional<ShiftInterval<Int>> invertTest(const Places& places, const P& p, double alpha, const Int& low,
                                             const Int& high, const Int& middle, int max_looks) {
    const Int zero(0);
    const double p_of_zero = p(zero, Near::at);
    IntervalEnd<Int, Places, P> lower(places, p, alpha, true);
    IntervalEnd<Int, Places, P> upper(places, p, alpha, false);
    ShiftInterval<Int> out;
    if (lower.find(low, max_looks) && upper.find(high, max_looks)) {
        out = {lower.place(), upper.place(), lower.included(), upper.included(),
               std::max(lower.outsideP(), upper.outsideP())};
    } else {
        // All differences may be alike, or nearly so: that one shift.
        const Int& only = p(middle, Near::at) > alpha ? middle : zero;
        if (p(only, Near::at) <= alpha) return std::nullopt;
        out = {only, only, true, true, std::max(p(only, Near::below), p(only, Near::above))};
    }
    // The widest interval speaks at its own level.
    if (out.outside_p > alpha) return out;
    if (p_of_zero > alpha) {
        if (out.lower >= Int(0)) {
            out.lower = Int(0);
            out.lower_included = true;
        }
        if (out.upper <= Int(0)) {
            out.upper = Int(0);
            out.upper_included = true;
        }
    } else if (out.lower <= Int(0) && out.upper >= Int(0)) {
        out.outside_p = std::max(out.outside_p, p_of_zero);
        if (p(Int(0), Near::below) < p(Int(0), Near::above)) {
            out.lower = Int(0);
            out.lower_included = false;
        } else {
            out.upper = Int(0);
            out.upper_included = false;
        }
        if (out.lower == out.upper) return std::nullopt;
    }
    return out;
}

}  // namespace deixis::results
