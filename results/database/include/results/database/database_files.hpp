// The files of a database: the main one, and the log and journal that SQLite keeps beside it.
#pragma once

#include <filesystem>
#include <optional>

#include "core/error.hpp"

namespace deixis::results {

/// A writer is, or was when it died, at work on the database: its latest answers stand in the log.
[[nodiscard]] bool hasLog(const std::filesystem::path& database);

/// Likewise, in the mode that programs other than this one may have left the database in: a transaction that
/// was interrupted, or is under way, and what the pages held before. Whoever reads next undoes it.
[[nodiscard]] bool hasJournal(const std::filesystem::path& database);

/// Answers in a log or journal whose database is not there: it is missing, empty, or another file has taken
/// its name. SQLite would delete such a log, or take it for the other file's. Or answers in a recovered copy,
/// while the database is missing.
[[nodiscard]] std::optional<Error> orphanBeside(const std::filesystem::path& database);

/// Error: no database may be made under this name, since what is left of another one with it lies there,
/// which has answers that are nowhere else. That it is there itself is not an error.
[[nodiscard]] Result<void> checkPlaceForDatabase(const std::filesystem::path& database);

/// Where the nth copy of what a database held goes when it is lost in a session: "study.recovered.sqlite",
/// "study.recovered-2.sqlite", ... beside it.
[[nodiscard]] std::filesystem::path recoveredCopy(const std::filesystem::path& database, int nth);

/// What no database can be: a folder, pipe or device.
[[nodiscard]] Result<void> checkKindOfFile(const std::filesystem::path& database);

/// Makes an empty file that its owner alone may read and write. False where one of that name is there, or it
/// cannot be made.
[[nodiscard]] bool makeOwnFile(const std::filesystem::path& file);

}  // namespace deixis::results
