#include "core/staging.hpp"

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

#include "core/durable.hpp"
#include "core/files.hpp"
#include "core/unique_name.hpp"

namespace deixis {

namespace fs = std::filesystem;

Staging::Staging(fs::path home, fs::path path, bool made_home)
    : home_(std::move(home)), path_(std::move(path)), made_home_(made_home) {}

Staging::Staging(Staging&& other) noexcept
    : home_(std::move(other.home_)),
      path_(std::exchange(other.path_, {})),
      made_home_(std::exchange(other.made_home_, false)) {}

Result<Staging> Staging::within(const fs::path& home, std::string name) {
    std::error_code code;
    // Absolute: the working folder may become another one meanwhile.
    const fs::path folder = fs::absolute(home);
    const bool made_home = !fs::exists(folder, code);
    Staging out(folder, folder / (name.empty() ? ".making-" + uniqueName() : std::move(name)), made_home);
    fs::remove_all(out.path_, code);
    fs::create_directories(out.path_, code);
    if (code) return fail(home.string(), "cannot be made: " + code.message());
    return out;
}

Staging::~Staging() {
    std::error_code code;
    if (!path_.empty()) fs::remove_all(path_, code);
    if (made_home_) fs::remove(home_, code);  // where it is empty
}

Result<void> Staging::add(const fs::path& name, std::string_view bytes) const {
    return writeFileUnsynced(path_ / name, bytes);
}

Result<void> Staging::moveHome(const std::vector<fs::path>& names, const std::vector<fs::path>& outdated,
                               bool durable) {
    std::error_code code;
    for (const fs::path& name : names)
        if (fs::is_directory(home_ / name, code))
            return fail((home_ / name).string(), "is a folder, and a file is to be written there",
                        "Give another name, or move the folder away");
    if (durable) syncFileSystem(path_);
    for (const fs::path& name : outdated) fs::remove(home_ / name, code);
    std::set<fs::path> grown{home_, home_.parent_path()};
    for (const fs::path& name : names) {
        const fs::path place = home_ / name;
        fs::create_directories(place.parent_path(), code);
        fs::rename(path_ / name, place, code);
        if (code) {
            path_.clear();
            return fail(place.string(), "cannot be written: " + code.message());
        }
        for (fs::path folder = place.parent_path(); grown.insert(folder).second;)
            folder = folder.parent_path();
    }
    // Folders after what is in them.
    if (durable) std::for_each(grown.rbegin(), grown.rend(), syncFolder);
    return {};
}

Result<void> Staging::become(const fs::path& target, bool durable) {
    if (durable) syncFileSystem(path_);
    std::error_code code;
    fs::rename(path_, target, code);
    if (code) return fail(target.string(), "cannot be written: " + code.message());
    path_.clear();
    if (durable) syncFolder(target.parent_path());
    return {};
}

PartialFile::PartialFile(fs::path target, const char* ending)
    : target_(std::move(target)), path_(target_.string() + ending) {
    remove();
}

PartialFile::~PartialFile() {
    remove();
}

void PartialFile::remove() const {
    std::error_code code;
    for (const char* companion : {"", "-wal", "-shm", "-journal"})
        fs::remove(path_.string() + companion, code);
}

Result<void> PartialFile::finish() {
    return moveFile(path_, target_);
}

}  // namespace deixis
