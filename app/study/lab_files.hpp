// The files of a lab's own that a study is made of, and how they have changed since it was locked.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/clips/study_setup.hpp"
#include "app/study/locked_study.hpp"
#include "app/study/seen_files.hpp"
#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"

namespace deixis::app {

/// Whether a file is part of what ships with the program.
[[nodiscard]] bool isShipped(const std::filesystem::path& file);

/// The study file, then the questionnaires beside it, manifests, clips with the buffers that they name and
/// what is said about their bones, and the avatar likewise, with its pictures. None where the study ships
/// with the program.
[[nodiscard]] Result<std::vector<LabFile>> labFiles(const StudySetup& setup, const assets::Avatar& avatar,
                                                    SeenFiles& seen);

}  // namespace deixis::app
