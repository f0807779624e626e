// A database whose file is renamed, moved, replaced or deleted while it is written to.
#include <fmt/core.h>
#include <sys/stat.h>

#include <system_error>

#include "core/durable.hpp"
#include "results/database/database_files.hpp"
#include "results/database/database_open.hpp"
#include "store_impl.hpp"

namespace deixis::results {

namespace fs = std::filesystem;

namespace {

/// "study.recovered.sqlite", "study.recovered-2.sqlite", ... beside the database, or where that folder is
/// gone in the working or the temporary one. Returns the first that could be made.
std::optional<fs::path> makeNewFile(const fs::path& database) {
    std::error_code code;
    constexpr int max = 1000;
    for (const fs::path& folder :
         {database.parent_path(), fs::current_path(code), fs::temp_directory_path(code)}) {
        if (!fs::is_directory(folder, code)) continue;
        for (int i = 1; i < max; ++i) {
            const fs::path file = recoveredCopy(folder / database.filename(), i);
            if (fs::exists(file, code)) continue;
            if (makeOwnFile(file)) return file;
            break;
        }
    }
    return std::nullopt;
}

/// All that the database holds, as one file that is on the disk on return.
void copyTo(SQLite::Database& database, const fs::path& file) {
    SQLite::Database copy(file.string(), SQLite::OPEN_READWRITE);
    copyWhole(database, copy);
    if (copy.execAndGet("PRAGMA journal_mode = DELETE").getString() != "delete" ||
        copy.execAndGet("PRAGMA integrity_check").getString() != "ok")
        throw SQLite::Exception("the copy cannot be read back", SQLITE_IOERR);
    syncFolder(file.parent_path());
}

std::optional<std::uint64_t> inodeOf(const fs::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return std::nullopt;
    return static_cast<std::uint64_t>(status.st_ino);
}

}  // namespace

void Store::Impl::checkInPlace() {
    if (inPlace()) return;
    moved = rescue();
    throw DatabaseMoved(*moved);
}

bool Store::Impl::inPlace() {
    int has_moved = 0;
    if (sqlite3_file_control(database.getHandle(), "main", SQLITE_FCNTL_HAS_MOVED, &has_moved) == SQLITE_OK &&
        has_moved != 0)
        return false;
    const auto inode = inodeOf(path.string() + "-wal");
    if (!log_inode) log_inode = inode;
    return inode == log_inode;
}

Error Store::Impl::rescue() {
    const char* const what = "was renamed, moved, replaced or deleted while a session wrote to it";
    std::string why = "no file can be made";
    if (const auto file = makeNewFile(path)) {
        try {
            copyTo(database, *file);
            // Nothing is left in a log that has no database: where the file has only another name, it is
            // whole.
            database.tryExec("PRAGMA wal_checkpoint(TRUNCATE)");
            return {path.string(),
                    fmt::format(
                        "the database {}. Everything stored until then, including all answers, is in '{}'",
                        what, file->string()),
                    fmt::format("Find out what happened to '{}', then give that copy its name",
                                path.filename().string())};
        } catch (const SQLite::Exception& problem) {
            why = problem.what();
            std::error_code ignored;
            fs::remove(*file, ignored);
        }
    }
    return {path.string(), fmt::format("the database {}, and no copy of it could be written ({})", what, why),
            fmt::format("The latest answers are in '{}-wal': delete nothing, give the database back its name "
                        "beside it, and they are read into it",
                        path.filename().string())};
}

}  // namespace deixis::results
