// The clips that a session shows: those of the locked study.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/study/locked_study.hpp"
#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "results/store/store.hpp"
#include "speech/sound/sound.hpp"
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
    [[nodiscard]] const studies::ClipSound* sound(const studies::Stimulus& stimulus) const override;
    [[nodiscard]] const std::string* project(const studies::Stimulus& stimulus) const override;
    /// All that is heard in the given plans, by ClipSound::id: the name in the locked set.
    [[nodiscard]] const std::map<std::string, speech::Sound>& sounds() const { return sounds_; }
    [[nodiscard]] results::ClipRecords records() const;

  private:
    struct Loaded {
        motion::Clip clip;
        results::ClipRecord record;
        studies::ClipSound sound{};  ///< without an id where nothing is heard
        std::string project{};       ///< empty: it is made of none
    };
    std::map<studies::Stimulus, Loaded> clips_;
    std::map<std::string, speech::Sound> sounds_;
};

}  // namespace deixis::app
