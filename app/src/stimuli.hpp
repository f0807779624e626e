// The clips that a session shows: made by the built-in systems, or a lab's own.
#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "assets/avatar.hpp"
#include "core/error.hpp"
#include "results/store.hpp"
#include "studies/session.hpp"
#include "study_setup.hpp"

namespace deixis::app {

/// Clips on the avatar's skeleton, each with the file that it was read from and its hash.
class StimulusLibrary : public studies::ClipSource {
  public:
    /// Loads the clips of the given plans. Clips of built-in systems are kept as BVH files with a manifest
    /// under `folder`, in a folder named after what they depend on, and made there where they are missing. A
    /// clip that is missing, does not parse, or whose manifest row does not fit it is an error that names the
    /// file.
    [[nodiscard]] static Result<StimulusLibrary> load(const StudySetup& setup,
                                                      const std::vector<studies::StudyPlan>& plans,
                                                      const assets::Avatar& avatar,
                                                      const std::filesystem::path& folder);

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
