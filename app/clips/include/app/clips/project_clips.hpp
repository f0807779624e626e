// Projects of the studio as clips with sound.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/clips/clip_output.hpp"
#include "assets/projects/studio_project.hpp"
#include "assets/tables/manifest.hpp"
#include "core/error.hpp"
#include "motion/skeleton/clip.hpp"

namespace deixis::app {

struct ProjectClip {
    motion::Clip clip;       ///< on the reference humanoid, as long as the sound
    std::string wav;         ///< bytes of a file
    std::string processing;  ///< what a manifest says of it
    Utterance utterance;     ///< the words that are said
};

/// Makes of projects what they lack: the speech by flite, gestures by the model, rules and library that ship.
/// What there is in a project stays as it is. Calls may come from several threads; a text is spoken once.
class ProjectClips {
  public:
    ProjectClips();
    ~ProjectClips();
    ProjectClips(const ProjectClips&) = delete;
    ProjectClips& operator=(const ProjectClips&) = delete;

    /// Errors name what of the project: a voice that flite does not have, a text that it cannot speak,
    /// controls that do not fit into the speech; and, where this build has no voices, that it has none.
    /// `name` stands for the project in them.
    [[nodiscard]] Result<ProjectClip> make(const assets::StudioProject& project, const std::string& name);

    /// What a manifest will say of a project's clip; empty where nothing can be told, as where it cannot be
    /// made.
    [[nodiscard]] std::string processing(const assets::StudioProject& project);

    /// The bytes of the files that ship which make clips what they are, for telling clips of one version of
    /// them from those of another.
    [[nodiscard]] Result<std::string> sources();

  private:
    [[nodiscard]] Result<ProjectClip> makeUnnamed(const assets::StudioProject& project);

    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// NAME.bvh and NAME.wav, and what the manifest's row says of them.
[[nodiscard]] Result<void> addProjectClip(const ProjectClip& made, const std::string& name,
                                          OutputFolder& folder, assets::ManifestRow& row);

}  // namespace deixis::app
