#include "results/store/participant_lock.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <system_error>
#include <utility>

namespace deixis::results {

namespace {

/// A participant id may hold what a file name must not.
std::string fileNamePart(const std::string& id) {
    std::string out;
    for (const char c : id) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) != 0 || c == '-' || c == '_')
            out += c;
        else
            out += fmt::format("%{:02X}", byte);
    }
    return out;
}

/// Whether the open file still has the name.
bool isAt(int file, const std::filesystem::path& path) {
    struct stat open {};
    struct stat named {};
    return ::fstat(file, &open) == 0 && ::stat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino &&
           open.st_dev == named.st_dev;
}

}  // namespace

std::filesystem::path lockFile(const std::filesystem::path& database, const std::string& participant) {
    std::filesystem::path path = database;
    path += "." + fileNamePart(participant) + ".lock";
    return path;
}

std::filesystem::path workFile(const std::filesystem::path& database, const std::string& participant) {
    std::filesystem::path path = database;
    path += "." + fileNamePart(participant) + ".work";
    return path;
}

Result<std::optional<ParticipantLock>> ParticipantLock::tryTake(const std::filesystem::path& database,
                                                                const std::string& participant) {
    const std::filesystem::path path = lockFile(database, participant);
    for (;;) {
        const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
        if (file < 0)
            return fail(
                path.string(),
                fmt::format("the lock file cannot be made: {}", std::generic_category().message(errno)),
                "Check that the folder exists and that you may write in it");
        // The kernel lets go of the lock when the process ends in whatever way, so a file left behind does no
        // harm.
        if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
            const int why = errno;
            ::close(file);
            if (why == EWOULDBLOCK) return std::nullopt;
            return fail(path.string(),
                        fmt::format("cannot be locked: {}", std::generic_category().message(why)),
                        "Keep the database on a local disk");
        }
        if (isAt(file, path)) return ParticipantLock(file, path);
        ::close(file);  // who had it before has just removed it
    }
}

Result<ParticipantLock> ParticipantLock::take(const std::filesystem::path& database,
                                              const std::string& participant) {
    auto lock = tryTake(database, participant);
    if (!lock) return tl::unexpected(lock.error());
    if (!*lock)
        return fail(database.string(),
                    fmt::format("participant {} is already being run in another process", participant),
                    "End that run first, or give another participant id");
    return std::move(**lock);
}

ParticipantLock::ParticipantLock(ParticipantLock&& other) noexcept
    : file_(std::exchange(other.file_, -1)), path_(std::move(other.path_)) {}

ParticipantLock& ParticipantLock::operator=(ParticipantLock&& other) noexcept {
    std::swap(file_, other.file_);
    std::swap(path_, other.path_);
    return *this;
}

ParticipantLock::~ParticipantLock() {
    if (file_ < 0) return;
    if (isAt(file_, path_)) ::unlink(path_.c_str());
    ::close(file_);
}

}  // namespace deixis::results
