// The projects of a study: a folder of files ITEM.SYSTEM.json.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "app/clips/project_clips.hpp"
#include "core/error.hpp"
#include "studies/design/targets.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::app {

/// Of all projects of a folder, in their order. Fails where there is no such folder, or none in it, or a file
/// of another form of name.
[[nodiscard]] Result<std::set<std::string>> itemsOfProjects(const std::filesystem::path& folder);

/// Where a system has its project for an item.
[[nodiscard]] std::filesystem::path projectFile(const studies::SystemSource& system, const std::string& item);

/// A project as a system shows it.
struct ItemProject {
    std::string item;
    std::string bytes;  ///< of its file; without controls where the system takes none
    assets::StudioProject project;
};

/// The system's projects for those items, each once, in their order. Every problem: those that are not there,
/// together, and each that cannot be read.
[[nodiscard]] tl::expected<std::vector<ItemProject>, std::vector<Error>> readProjects(
    const studies::SystemSource& system, const std::vector<studies::TargetItem>& items);

/// The manifest of their clips, in a folder under `folder` that is named after all that they depend on, and
/// made there where it is not there yet. Several threads and programs may ask for the same clips at once.
[[nodiscard]] Result<std::filesystem::path> projectsManifest(const studies::SystemSource& system,
                                                             const std::vector<ItemProject>& projects,
                                                             ProjectClips& maker,
                                                             const std::filesystem::path& folder);

}  // namespace deixis::app
