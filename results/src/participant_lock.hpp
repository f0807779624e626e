// The file that a ParticipantLock locks.
#pragma once

#include <filesystem>
#include <string>

namespace deixis::results {

/// Beside the database: "DATABASE.PARTICIPANT.lock".
[[nodiscard]] std::filesystem::path lockFile(const std::filesystem::path& database,
                                             const std::string& participant);

}  // namespace deixis::results
