// Changing one participant's rows in a database file.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "core/error.hpp"
#include "results/database/participant_status.hpp"

namespace deixis::results {

[[nodiscard]] tl::unexpected<Error> noParticipant(const std::filesystem::path& database,
                                                  const std::string& participant);

/// Runs `change` as one transaction. Fails where there is no such participant; failing SQLite calls become
/// errors.
[[nodiscard]] Result<void> changeParticipant(const std::filesystem::path& path,
                                             const std::string& participant,
                                             const std::function<void(SQLite::Database&)>& change);

void setStatus(SQLite::Database& database, const std::string& participant, ParticipantStatus status,
               const std::optional<std::string>& reason);

}  // namespace deixis::results
