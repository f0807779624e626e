// Finding the avatar that recorded sessions showed.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "assets/avatar/avatar.hpp"
#include "core/error.hpp"
#include "results/store/recording.hpp"

namespace deixis::app {

/// What recorded sessions showed.
struct ShownAvatar {
    std::string study_source;      ///< the study file's text
    std::set<std::string> hashes;  ///< of all sessions, SHA-256; "" where one was not kept
    std::string whose;             ///< in messages: "P07"
};
[[nodiscard]] ShownAvatar shownAvatar(const results::Recording& recording);

/// The avatar locked beside the database that the sessions showed. Else, where the study named an
/// avatar: the file of that path, from the database's folder on, or of that name
/// beside the database, whose bytes are those that the sessions showed. An error names all that was
/// looked at. Else Deixis's own, with a word on stderr where the sessions showed another one. `instead`:
/// a file to take in its place, whatever was shown; empty: none. As tall as the study says.
[[nodiscard]] Result<assets::Avatar> recordedAvatar(const ShownAvatar& shown,
                                                    const std::filesystem::path& database,
                                                    const std::filesystem::path& instead = {});

}  // namespace deixis::app
