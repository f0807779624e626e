// The clips that a session shows: those of the locked study.
#pragma once

#include <map>
#include <vector>

#include "app/study/locked_study.hpp"
#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "results/store/store.hpp"
#include "studies/session/session.hpp"

namespace deixis::app {

/// Clips on the avatar's skeleton, each with the file of the locked set that it was read from and its hash.
class StimulusLibrary : public studies::ClipSource {
  public:
    /// Loads the clips of the given plans: of each trial's system and item the one that was made for the
    /// trial's target. One that is not there is an error.
    [[nodiscard]] static Result<StimulusLibrary> load(const LockedStudy& locked,
                                                      const std::vector<studies::StudyPlan>& plans,
                                                      const assets::Avatar& avatar);

    [[nodiscard]] const motion::Clip& clip(const studies::Stimulus& stimulus) const override;
    [[nodiscard]] results::ClipRecords records() const;

  private:
    struct Loaded {
        motion::Clip clip;
        results::ClipRecord record;
    };
    std::map<studies::Stimulus, Loaded> clips_;
};

}  // namespace deixis::app
