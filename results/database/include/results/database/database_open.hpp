// Opening the database files of a study: for a run, for changing participants, and read-only.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <chrono>
#include <filesystem>
#include <type_traits>
#include <utility>

#include "core/error.hpp"
#include "results/database/database_errors.hpp"

namespace deixis::results {

/// Another program's lock is waited for this long, in a call of SQLite.
inline constexpr int busy_timeout_ms = 1000;
/// And in opening for writing, where others may be about to open or make the same file: long enough for a
/// hundred stations that start at once.
inline constexpr std::chrono::milliseconds opening_patience{30'000};

enum class Missing : unsigned char {
    create,  ///< a file that is not there is made, with the newest tables
    reject
};

/// Opens for writing, once all of it has been looked over (checkWhole()), and brings an older database to the
/// newest version. Foreign keys are enforced, the
/// journal is a write-ahead log, and each transaction waits for the disk. Nothing is opened or made beside
/// the log or journal of a database that is not there. Failing SQLite calls throw; a lock does only after
/// `patience`, in which a time that the machine stood still does not count.
[[nodiscard]] Result<SQLite::Database> openToWrite(const std::filesystem::path& path, Missing missing,
                                                   std::chrono::milliseconds patience = opening_patience);

/// Copies all of the database into the other, which must be empty. Failing SQLite calls throw.
void copyWhole(SQLite::Database& from, SQLite::Database& to);

enum class WithLog : unsigned char {
    where_there_is_one,  ///< else the file is all there is, and needs no file beside it
    yes
};

/// A database opened only to be read, in the newest schema. Nothing in the file or beside it is changed, but
/// that a transaction broken off is undone by its journal, which asks for permission to write: one of an
/// older version is copied into memory and updated there.
class ReadOnlyDatabase {
  public:
    [[nodiscard]] SQLite::Database& operator*() { return database_; }
    [[nodiscard]] SQLite::Database* operator->() { return &database_; }
    /// Whether what was read can be relied on: false if a writer has begun since and the file was read
    /// without its log. Then read again with openReadOnly(path, WithLog::yes).
    [[nodiscard]] bool undisturbed() const;
    /// The schema's version in the file itself.
    [[nodiscard]] int fileVersion() const { return file_version_; }

  private:
    friend Result<ReadOnlyDatabase> openReadOnly(const std::filesystem::path& path, WithLog log);
    ReadOnlyDatabase(SQLite::Database database, std::filesystem::path path, bool without_log,
                     std::filesystem::file_time_type written, int file_version)
        : database_(std::move(database)),
          path_(std::move(path)),
          without_log_(without_log),
          written_(written),
          file_version_(file_version) {}

    SQLite::Database database_;
    std::filesystem::path path_;
    bool without_log_ = false;
    std::filesystem::file_time_type written_{};
    int file_version_ = 0;
};

/// Errors: no such file, not one of ours, a newer version, no tables in it yet, damaged (checkWhole()),
/// locked.
[[nodiscard]] Result<ReadOnlyDatabase> openReadOnly(const std::filesystem::path& path,
                                                    WithLog log = WithLog::where_there_is_one);

/// Opens and gives to `read` (SQLite::Database& -> Result<...>), within one read transaction: one moment of
/// the database. Reads again where a writer came in between. Failing SQLite calls become errors.
/// `file_version`: gets the version of the schema in the file.
template <typename Read>
[[nodiscard]] auto readDatabase(const std::filesystem::path& path, const Read& read,
                                int* file_version = nullptr)
    -> std::invoke_result_t<Read, SQLite::Database&> {
    try {
        auto opened = openReadOnly(path);
        if (!opened) return tl::unexpected(opened.error());
        if (file_version != nullptr) *file_version = opened->fileVersion();
        (*opened)->exec("BEGIN");
        auto out = read(**opened);
        if (opened->undisturbed()) return out;
        opened = openReadOnly(path, WithLog::yes);
        if (!opened) return tl::unexpected(opened.error());
        (*opened)->exec("BEGIN");
        return read(**opened);
    } catch (const SQLite::Exception& problem) {
        return tl::unexpected(describe(path, problem));
    }
}

}  // namespace deixis::results
