#include "guards.hpp"

#include <fmt/core.h>

namespace deixis::studies {

namespace {

constexpr double inside_m = 0.05;
constexpr double worse_m = 0.10;
constexpr double patience_s = 2.0;

}  // namespace

std::optional<GuardNote> PlaceGuard::step(double off_place_m, int trial) {
    off_ = off_place_m > (off_ ? tolerance_m_ - inside_m : tolerance_m_);
    if (!off_) {
        if (!noted_) return std::nullopt;
        noted_ = false;
        return GuardNote{NoteKind::back_on_place};
    }
    if (trial < 0) return std::nullopt;
    if (trial != trial_) {
        trial_ = trial;
        marks_ = 0;
    }
    const bool worse = marks_ == 1 && off_place_m >= marked_m_ + worse_m;
    if (marks_ > 0 && !worse) return std::nullopt;
    ++marks_;
    marked_m_ = off_place_m;
    noted_ = true;
    return GuardNote{NoteKind::off_place, fmt::format("{:.2f} m", off_place_m)};
}

std::optional<GuardNote> PointerGuard::step(bool there, bool something_to_aim_at, double now_s, int trial) {
    if (there || !something_to_aim_at)
        missing_since_s_.reset();
    else if (!missing_since_s_)
        missing_since_s_ = now_s;
    lost_ = missing_since_s_ && now_s - *missing_since_s_ > patience_s;
    if (lost_ && trial >= 0 && noted_in_ != trial) {
        noted_in_ = trial;
        return GuardNote{NoteKind::pointer_lost};
    }
    if (there && noted_in_) {
        noted_in_.reset();
        return GuardNote{NoteKind::pointer_found};
    }
    return std::nullopt;
}

}  // namespace deixis::studies
