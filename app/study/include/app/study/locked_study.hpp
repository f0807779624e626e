// The study in a locked set: written at the first run, opened by every later one.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/clips/study_setup.hpp"
#include "app/study/locked_set.hpp"
#include "core/error.hpp"

namespace deixis::app {

/// A file of the lab's that a set was made from.
struct LabFile {
    std::string file;  ///< from the study file's folder on, or absolute
    std::string hash;  ///< SHA-256
};

/// What one locked set says. The study's avatar is the set's file.
struct LockedStudy {
    std::string hash;              ///< of the set
    LockedFiles files;             ///< of the set, with their hashes
    std::filesystem::path folder;  ///< of the set
    StudySetup setup;
    int planner = 0;                   ///< studies::planner_version of the program that locked it
    bool shipped = false;              ///< the study came with the program; no file of it is a lab's
    std::vector<LabFile> lab_files{};  ///< the study file first; none of a study that ships

    /// The manifest of a system's clips.
    [[nodiscard]] std::filesystem::path manifest(const std::string& system) const {
        return folder / "clips" / system / "manifest.csv";
    }
};

/// Where a set has the project that a clip of it was made of.
[[nodiscard]] inline std::filesystem::path projectBeside(const std::filesystem::path& clip) {
    return clip.string() + ".json";
}

/// What is locked beside the setup itself.
struct LockRequest {
    std::filesystem::path database;
    std::filesystem::path made;  ///< folder in which clips that the program makes are kept
    /// Of plans that were stored before anything was locked, see ClipSources.
    std::vector<studies::TargetItem> earlier{};
    std::map<std::string, std::filesystem::path> shown{};
    bool durable = true;  ///< on the disk on return
};

/// Writes the set beside the database. Returns its hash. Every problem of the clips, none of the set then.
[[nodiscard]] tl::expected<std::string, std::vector<Error>> lockStudy(const StudySetup& setup,
                                                                      const LockRequest& request);

/// The same set for this program's planner. Returns its hash.
[[nodiscard]] Result<std::string> lockForPlanner(const std::filesystem::path& database,
                                                 const LockedStudy& locked);

/// The set of that hash, verified, in `language` (empty: the study's first).
[[nodiscard]] Result<LockedStudy> openLocked(const std::filesystem::path& database, const std::string& hash,
                                             const std::string& language = {});

/// How a lab's files differ from those that the set was made from, each in words. `study` as for
/// loadStudySetup().
[[nodiscard]] Result<std::vector<std::string>> labDifferences(const LockedStudy& locked,
                                                              const std::string& study, SeenFiles seen);

}  // namespace deixis::app
