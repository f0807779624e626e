// All clips that the participants of a study may see: checked by `check`, and locked by the first run.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/clips/study_setup.hpp"
#include "assets/avatar/avatar.hpp"
#include "assets/tables/manifest.hpp"
#include "core/error.hpp"

namespace deixis::app {

/// A system's clip for an item, as it is shown.
struct StudyClip {
    assets::ManifestRow row;  ///< of the system's manifest; fps as shown
    std::string bytes;        ///< of the file, on the avatar
    std::string extension;    ///< of the file: ".bvh"
    std::string sound{};      ///< bytes of the WAV file that is heard with it; empty: none is
    std::string project{};    ///< bytes of the studio's project that it was made of; empty: of none
};

/// Takes a clip; of one system after another in the order of its manifest, of several systems at once.
using ClipTaker = std::function<Result<void>(const studies::SystemSource& system, StudyClip clip)>;

struct ClipSources {
    const StudySetup& setup;
    const assets::Avatar* avatar = nullptr;  ///< null: it cannot be read, and nothing is brought to it
    /// Where clips that the program makes are kept; empty: none are made, and built-in systems are passed
    /// over.
    std::filesystem::path made{};
    /// Items whose targets were others when plans were stored: these clips are wanted, too.
    std::vector<studies::TargetItem> earlier{};
    /// By system: the manifest of a built-in system's clips that were shown before.
    std::map<std::string, std::filesystem::path> shown{};
};

/// Reads every clip: each system has one for each item, made for where the target is, which fits its row and
/// plays on the avatar. Every problem, with the study's line and key, the manifest's line, and the clip.
[[nodiscard]] std::vector<Error> readStudyClips(const ClipSources& sources, const ClipTaker& take);

/// The clips of one system's manifest: those that carry its name, or all where the manifest is of one system
/// only. None: it has several systems, but none of that name.
[[nodiscard]] std::vector<const assets::ManifestRow*> rowsOfSystem(const assets::Manifest& manifest,
                                                                   const std::string& system);

/// Whether a clip was made for a target; within a millimetre.
[[nodiscard]] bool madeFor(const assets::ManifestRow& row, const studies::TargetItem& item);

}  // namespace deixis::app
