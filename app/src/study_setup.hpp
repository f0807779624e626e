// What every command that uses a study needs first: the study, its targets and the avatar.
#pragma once

#include <string>
#include <vector>

#include "assets/avatar.hpp"
#include "core/error.hpp"
#include "studies/study.hpp"
#include "studies/targets.hpp"

namespace deixis::app {

struct StudySetup {
    studies::Study study;
    std::vector<studies::TargetItem> targets;
};

/// `name` is a file, or the name of a study that ships ("pointing2023").
[[nodiscard]] Result<StudySetup> loadStudySetup(const std::string& name);

/// The product's own avatar.
[[nodiscard]] Result<assets::Avatar> loadShippedAvatar();

}  // namespace deixis::app
