// What every command that uses a study needs first: the study, its targets and the avatar.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "studies/design/targets.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::app {

struct StudySetup {
    studies::Study study;
    std::vector<studies::TargetItem> targets;
};

/// `name` is a file, or the name of a study that ships ("pointing2023"). Texts are in `language`; empty: the
/// study's first. All that is wrong with the file, and with the manifests that its targets come from.
[[nodiscard]] tl::expected<StudySetup, std::vector<Error>> checkStudySetup(const std::string& name,
                                                                           const std::string& language = {});

/// The same with the first problem alone, which says where to find the others.
[[nodiscard]] Result<StudySetup> loadStudySetup(const std::string& name, const std::string& language = {});

/// The first of several problems, with where to find the others.
[[nodiscard]] Error firstOf(const std::vector<Error>& problems, const std::string& study);

/// The product's own avatar.
[[nodiscard]] Result<assets::Avatar> loadShippedAvatar();

/// The avatar in the file; where none is named, Deixis's own.
[[nodiscard]] Result<assets::Avatar> loadAvatarOrShipped(const std::filesystem::path& file,
                                                         const assets::AvatarOptions& options = {});

/// The one that the study shows. Errors name the study's key.
[[nodiscard]] Result<assets::Avatar> loadStudyAvatar(const studies::Study& study);

}  // namespace deixis::app
