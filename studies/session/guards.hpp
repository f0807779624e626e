// What keeps participants from doing their part: they stand off their place, or hold nothing to point with.
#pragma once

#include <optional>
#include <string>

#include "studies/station/note_kind.hpp"

namespace deixis::studies {

/// A note that a guard asks for.
struct GuardNote {
    NoteKind kind;
    std::string detail{};
};

/// Off the place from beyond the tolerance on, and back on it 5 cm inside, so that nobody who sways at its
/// edge is called again and again.
class PlaceGuard {
  public:
    explicit PlaceGuard(double tolerance_m) : tolerance_m_(tolerance_m) {}

    /// One frame; `trial` is the index of the trial that would be marked, -1: none. Notes off_place once a
    /// trial, and once more where it gets worse by 10 cm; back_on_place after either.
    std::optional<GuardNote> step(double off_place_m, int trial);
    [[nodiscard]] bool off() const { return off_; }

  private:
    double tolerance_m_;
    bool off_ = false;
    bool noted_ = false;  ///< this time
    int trial_ = -1;      ///< the last that was marked,
    int marks_ = 0;       ///< how often,
    double marked_m_ = 0.0;
};

/// Lost where there has been no pointer for 2 s while there was something to aim at.
class PointerGuard {
  public:
    /// One frame; `trial` as above. Notes pointer_lost, and pointer_found after it.
    std::optional<GuardNote> step(bool there, bool something_to_aim_at, double now_s, int trial);
    [[nodiscard]] bool lost() const { return lost_; }

  private:
    bool lost_ = false;
    std::optional<double> missing_since_s_;
    std::optional<int> noted_in_;  ///< trial in which this loss was noted
};

}  // namespace deixis::studies
