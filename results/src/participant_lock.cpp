#include "participant_lock.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <system_error>

#include "results/store.hpp"

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

}  // namespace

std::filesystem::path lockFile(const std::filesystem::path& database, const std::string& participant) {
    std::filesystem::path path = database;
    path += "." + fileNamePart(participant) + ".lock";
    return path;
}

Result<ParticipantLock> ParticipantLock::take(const std::filesystem::path& database,
                                              const std::string& participant) {
    const std::filesystem::path path = lockFile(database, participant);
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0)
        return fail(path.string(),
                    fmt::format("the lock file cannot be made: {}", std::generic_category().message(errno)),
                    "Check that the folder exists and that you may write in it");
    // The kernel lets go of the lock when the process ends in whatever way, so a file left behind does no
    // harm.
    if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
        const int why = errno;
        ::close(file);
        if (why != EWOULDBLOCK)
            return fail(path.string(),
                        fmt::format("cannot be locked: {}", std::generic_category().message(why)),
                        "Keep the database on a local disk");
        return fail(database.string(),
                    fmt::format("participant {} is already being run in another process", participant),
                    "End that run first, or give another participant id");
    }
    return ParticipantLock(file);
}

ParticipantLock::ParticipantLock(ParticipantLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

ParticipantLock& ParticipantLock::operator=(ParticipantLock&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
}

ParticipantLock::~ParticipantLock() {
    if (file_ >= 0) ::close(file_);
}

}  // namespace deixis::results
