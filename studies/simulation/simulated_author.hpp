// How a simulated participant authors gestures: it tells edits now and then, and finishes where it may. The
// project that it hands back is the one that it was given.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "studies/station/station.hpp"

namespace deixis::studies {

class SimulatedAuthor {
  public:
    explicit SimulatedAuthor(std::uint64_t seed) : random_(seed, "authoring") {}

    /// A frame of a trial of authoring.
    void see(const PresentedFrame& frame, double time_s);
    /// What it tells now.
    [[nodiscard]] std::optional<AuthoredWork> tell(double time_s);
    [[nodiscard]] std::vector<StationNote> takeNotes();

  private:
    Random random_;
    std::optional<AuthoringTask> task_{};  ///< the trial under way, as seen last
    double next_edit_s_ = 0.0;
    double finish_at_share_ = 1.0;  ///< of the time limit
    std::vector<StationNote> notes_;
};

}  // namespace deixis::studies
