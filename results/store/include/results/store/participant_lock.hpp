// A lock that allows one run at a time of a participant in a database.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "core/error.hpp"

namespace deixis::results {

/// Beside the database: "DATABASE.PARTICIPANT.lock".
[[nodiscard]] std::filesystem::path lockFile(const std::filesystem::path& database,
                                             const std::string& participant);

/// Likewise "DATABASE.PARTICIPANT.work": what is authored in the trial under way.
[[nodiscard]] std::filesystem::path workFile(const std::filesystem::path& database,
                                             const std::string& participant);

/// Keeps two runs of one participant in one database apart: holds an advisory lock on a file beside the
/// database until destroyed, which removes the file. Where the process dies the lock ends, and the file stays
/// until the next one.
class ParticipantLock {
  public:
    /// Error: another process holds it.
    [[nodiscard]] static Result<ParticipantLock> take(const std::filesystem::path& database,
                                                      const std::string& participant);
    /// None: another process holds it.
    [[nodiscard]] static Result<std::optional<ParticipantLock>> tryTake(const std::filesystem::path& database,
                                                                        const std::string& participant);
    ParticipantLock(ParticipantLock&&) noexcept;
    ParticipantLock& operator=(ParticipantLock&&) noexcept;
    ~ParticipantLock();

  private:
    ParticipantLock(int file, std::filesystem::path path) : file_(file), path_(std::move(path)) {}
    int file_ = -1;
    std::filesystem::path path_{};
};

}  // namespace deixis::results
