// What participants authored, as it counts: for the clips of a rating study (Yoon et al. 2021, 7.2).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace deixis::results {

struct AuthoredClip {
    std::string author;  ///< the participant
    std::string system;
    std::string item;
    int trial = 1;           ///< which of the author's trials with that system that count, from 1
    std::string project;     ///< of the studio, JSON
    bool synthetic = false;  ///< by a simulated participant
};

/// In the order of the participants and their trials, without practice, trials that were skipped, and
/// participants who are excluded or dropped out. Errors: as loadResponses(), and where nothing was authored.
[[nodiscard]] Result<std::vector<AuthoredClip>> readAuthored(const std::filesystem::path& database);

}  // namespace deixis::results
