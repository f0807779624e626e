#include "results/database/database_files.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace deixis::results {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t log_header_bytes = 32;

fs::path beside(const fs::path& database, const char* suffix) {
    fs::path path = database;
    path += suffix;
    return path;
}

std::uintmax_t sizeOf(const fs::path& file) {
    std::error_code missing;
    const auto size = fs::file_size(file, missing);
    return missing ? 0 : size;
}

std::string beginOf(const fs::path& file, std::size_t bytes) {
    std::ifstream in(file, std::ios::binary);
    std::string begin(bytes, '\0');
    in.read(begin.data(), static_cast<std::streamsize>(bytes));
    begin.resize(static_cast<std::size_t>(in.gcount()));
    return begin;
}

/// A log with frames belongs to a database whose header says that it has one; nothing else has.
bool keepsLog(std::string_view header) {
    constexpr std::string_view magic("SQLite format 3\0", 16);
    constexpr std::size_t write_version = 18;
    constexpr char log = 2;
    return header.size() == 100 && header.starts_with(magic) && header[write_version] == log;
}

/// A journal that holds pages of a database as they were; not one that has been used up.
bool holdsPages(std::string_view journal) {
    constexpr std::string_view magic("\xd9\xd5\x05\xf9\x20\xa1\x63\xd7", 8);
    if (journal.size() < 20 || !journal.starts_with(magic)) return false;
    // How many pages the database had before: where it had none, it was being made.
    return journal.substr(16, 4) != std::string_view("\0\0\0\0", 4);
}

Error orphan(const fs::path& database, const fs::path& left, std::string_view state) {
    return {database.string(),
            fmt::format(
                "'{}' is beside it, with the latest answers of a database that is missing: this one is {}",
                left.filename().string(), state),
            "Nothing was opened or changed. The database was renamed, moved or replaced: give it back its "
            "name beside that file, and the answers are read into it. Keep copies of both, and use another "
            "database until then"};
}

}  // namespace

bool hasLog(const fs::path& database) {
    return sizeOf(beside(database, "-wal")) > 0;
}

bool hasJournal(const fs::path& database) {
    return sizeOf(beside(database, "-journal")) > 0;
}

std::optional<Error> orphanBeside(const fs::path& database) {
    const fs::path log = beside(database, "-wal");
    const fs::path journal = beside(database, "-journal");
    // The log first, and once more at the end: meanwhile another process may make the database, or put an
    // end to its log.
    const bool has_frames = sizeOf(log) > log_header_bytes;
    const std::string header = beginOf(database, 100);
    std::error_code code;
    const char* state = !fs::exists(database, code) ? "missing" : header.empty() ? "empty" : "another file";
    if (has_frames && !keepsLog(header) && sizeOf(log) > log_header_bytes)
        return orphan(database, log, state);
    if (header.empty() && holdsPages(beginOf(journal, 20)) && sizeOf(database) == 0)
        return orphan(database, journal, state);
    const fs::path copy = recoveredCopy(database, 1);
    if (!fs::exists(database, code) && fs::exists(copy, code))
        return Error{
            database.string(),
            fmt::format("is missing, and '{}' beside it has the answers of a database of this name that was "
                        "renamed, moved or deleted in a session",
                        copy.filename().string()),
            "Give that file this name to continue with it, or move it to another folder to start again"};
    return std::nullopt;
}

fs::path recoveredCopy(const fs::path& database, int nth) {
    return database.parent_path() / fmt::format("{}.recovered{}{}", database.stem().string(),
                                                nth == 1 ? "" : fmt::format("-{}", nth),
                                                database.extension().string());
}

Result<void> checkPlaceForDatabase(const fs::path& database) {
    if (auto left = orphanBeside(database)) return tl::unexpected(std::move(*left));
    return {};
}

Result<void> checkKindOfFile(const fs::path& database) {
    std::error_code code;
    const auto status = fs::status(database, code);
    if (fs::is_directory(status))
        return fail(database.string(), "found a folder, expected a database file", "Name a file in it");
    if (fs::exists(status) && !fs::is_regular_file(status))
        return fail(database.string(), "found a pipe or device, expected a database file", "Name a file");
    return {};
}

bool makeOwnFile(const fs::path& file) {
    const int made = ::open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (made < 0) return false;
    ::close(made);
    return true;
}

}  // namespace deixis::results
