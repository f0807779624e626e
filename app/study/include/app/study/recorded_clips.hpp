// Finding the clips that a recorded session showed.
#pragma once

#include <filesystem>
#include <map>

#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "results/store/recording.hpp"
#include "studies/session/session.hpp"

namespace deixis::app {

/// Adds the clip of a stimulus to those of other participants. Error: they were shown another one for it.
[[nodiscard]] Result<void> addShownClip(results::ClipRecords& to, const studies::Stimulus& stimulus,
                                        const results::ClipRecord& record,
                                        const std::filesystem::path& database);

class RecordedClips : public studies::ClipSource {
  public:
    /// Clips are looked for in what is locked beside the database, where `folder` is given under it by their
    /// names, and at their recorded paths. A file whose bytes are not those that were shown is an error.
    [[nodiscard]] static Result<RecordedClips> load(const results::ClipRecords& records,
                                                    const assets::Avatar& avatar,
                                                    const std::filesystem::path& folder,
                                                    const std::filesystem::path& database);

    [[nodiscard]] const motion::Clip& clip(const studies::Stimulus& stimulus) const override;

  private:
    std::map<studies::Stimulus, motion::Clip> clips_;
};

}  // namespace deixis::app
