#include "app/study/locked_set.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <sstream>
#include <system_error>
#include <utility>

#include "core/durable.hpp"
#include "core/files.hpp"
#include "core/hash.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* list_name = "locked.sha256";
constexpr const char* staging_name = ".making";

std::string reason(int code) {
    return std::generic_category().message(code);
}

const char* const put_back =
    "Restore the folder from a copy: without it nobody can be shown what the others were shown";

/// What the files of a set have that its list does not say.
std::vector<std::string> damages(const fs::path& set, const LockedFiles& files, SeenFiles& seen) {
    std::vector<fs::path> paths;
    for (const auto& [name, hash] : files) paths.push_back(set / name);
    const auto hashes = seen.hashes(paths);
    std::vector<std::string> out;
    auto found = hashes.begin();
    for (const auto& [name, hash] : files) {
        if (!*found)
            out.push_back(name + " is missing");
        else if (**found != hash)
            out.push_back(name + " was changed");
        ++found;
    }
    return out;
}

/// Owner only, whatever the umask.
Result<void> makePrivateFolder(const fs::path& folder) {
    std::error_code code;
    if (folder.has_parent_path()) fs::create_directories(folder.parent_path(), code);
    if (::mkdir(folder.c_str(), S_IRWXU) != 0 && errno != EEXIST)
        return fail(folder.string(), "cannot be made: " + reason(errno));
    return {};
}

std::string listText(const LockedFiles& files) {
    std::string out;
    for (const auto& [name, hash] : files) out += fmt::format("{}  {}\n", hash, name);
    return out;
}

}  // namespace

fs::path lockedFolder(const fs::path& database) {
    return fs::path(database).replace_extension(".locked");
}

Error damaged(const fs::path& set, const std::string& how) {
    return {set.string(), "the locked study is damaged: " + how, put_back};
}

SeenFiles seenFiles(const fs::path& database) {
    return SeenFiles(lockedFolder(database) / "seen");
}

fs::path lockedSet(const fs::path& database, const std::string& hash) {
    return lockedFolder(database) / hash.substr(0, 16);
}

Result<LockedFiles> readLockedList(const fs::path& set) {
    const auto text = readFile(set / list_name);
    if (!text) return tl::unexpected(text.error());
    LockedFiles files;
    std::istringstream lines(*text);
    constexpr std::size_t digits = 64;
    for (std::string line; std::getline(lines, line);) {
        if (line.size() < digits + 3 || line.compare(digits, 2, "  ") != 0)
            return fail((set / list_name).string(), fmt::format("'{}' is not a hash and a name", line));
        files.emplace(line.substr(digits + 2), line.substr(0, digits));
    }
    return files;
}

Result<LockedFiles> verifyLocked(const fs::path& database, const std::string& hash) {
    const fs::path set = lockedSet(database, hash);
    std::error_code code;
    if (!fs::is_directory(set, code))
        return fail(set.string(), "the study was locked into this folder, which is not there", put_back);
    const auto list = readFile(set / list_name);
    if (!list || sha256Hex(*list) != hash)
        return fail((set / list_name).string(),
                    list ? "is no longer the list of the locked study" : "is missing", put_back);
    auto files = readLockedList(set);
    if (!files) return files;
    SeenFiles seen = seenFiles(database);
    const auto found = damages(set, *files, seen);
    if (found.empty()) return files;
    constexpr std::size_t max_listed = 5;
    const std::vector<std::string> told(
        found.begin(), found.begin() + static_cast<std::ptrdiff_t>(std::min(max_listed, found.size())));
    return tl::unexpected(damaged(
        set, fmt::format(
                 "{}{}", fmt::join(told, ", "),
                 found.size() > max_listed ? fmt::format(" and {} more", found.size() - max_listed) : "")));
}

LockedSetWriter::LockedSetWriter(fs::path database, int lock)
    : database_(std::move(database)), lock_(lock), adding_(std::make_unique<std::mutex>()) {}

LockedSetWriter::LockedSetWriter(LockedSetWriter&& other) noexcept
    : database_(std::move(other.database_)),
      staging_(std::move(other.staging_)),
      lock_(std::exchange(other.lock_, -1)),
      files_(std::move(other.files_)),
      adding_(std::move(other.adding_)) {}

Result<LockedSetWriter> LockedSetWriter::begin(const fs::path& database) {
    const fs::path home = lockedFolder(database);
    if (auto made = makePrivateFolder(home); !made) return tl::unexpected(made.error());
    const int lock = ::open(home.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (lock < 0) return fail(home.string(), "cannot be opened: " + reason(errno));
    while (::flock(lock, LOCK_EX) != 0)
        if (errno != EINTR) {
            const int why = errno;
            ::close(lock);
            return fail(home.string(), "cannot be locked: " + reason(why),
                        "Keep the database on a local disk");
        }
    LockedSetWriter writer(database, lock);
    // Nobody else is making a set now: one of this name was left by a program that was killed.
    auto staging = Staging::within(home, staging_name);
    if (!staging) return tl::unexpected(staging.error());
    writer.staging_.emplace(std::move(*staging));
    std::error_code code;
    fs::permissions(writer.staging_->path(), fs::perms::owner_all, code);
    return writer;
}

LockedSetWriter::~LockedSetWriter() {
    if (lock_ < 0) return;
    staging_.reset();
    std::error_code code;
    fs::remove(lockedFolder(database_), code);  // where it is empty
    ::close(lock_);
}

Result<void> LockedSetWriter::add(const std::string& name, std::string_view bytes) {
    const fs::path file = staging_->path() / name;
    if (auto written = staging_->add(name, bytes); !written) return written;
    std::error_code code;
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write, code);
    std::string hash = sha256Hex(bytes);
    const std::lock_guard guard(*adding_);
    if (!files_.emplace(name, std::move(hash)).second)
        return fail(file.string(), "two files of the study would have this name");
    return {};
}

Result<std::string> LockedSetWriter::finish(bool durable) {
    const std::string list = listText(files_);
    const std::string hash = sha256Hex(list);
    const fs::path set = lockedSet(database_, hash);
    std::error_code code;
    if (fs::exists(set, code)) {
        if (verifyLocked(database_, hash)) return hash;
        fs::remove_all(set, code);
    }
    if (auto written = staging_->add(list_name, list); !written) return tl::unexpected(written.error());
    fs::permissions(staging_->path() / list_name, fs::perms::owner_read | fs::perms::owner_write, code);
    if (auto became = staging_->become(set, durable); !became) return tl::unexpected(became.error());
    if (durable) syncFolder(fs::absolute(lockedFolder(database_)).parent_path());
    return hash;
}

Result<std::vector<std::string>> copyLockedSets(const std::vector<fs::path>& from, const fs::path& to,
                                                const std::vector<std::string>& hashes) {
    std::vector<std::string> lacking;
    for (const std::string& hash : hashes) {
        const auto whole = std::find_if(from.begin(), from.end(), [&](const fs::path& database) {
            return verifyLocked(database, hash).has_value();
        });
        if (whole == from.end()) {
            lacking.push_back(hash);
            continue;
        }
        const fs::path set = lockedSet(*whole, hash);
        const auto files = readLockedList(set);
        if (!files) return tl::unexpected(files.error());
        auto writer = LockedSetWriter::begin(to);
        if (!writer) return tl::unexpected(writer.error());
        for (const auto& file : *files) {
            const auto bytes = readFile(set / file.first);
            if (!bytes) return tl::unexpected(bytes.error());
            if (auto added = writer->add(file.first, *bytes); !added) return tl::unexpected(added.error());
        }
        if (auto copied = writer->finish(false); !copied) return tl::unexpected(copied.error());
    }
    return lacking;
}

}  // namespace deixis::app
