#include "core/durable.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <system_error>

namespace deixis {

namespace {

/// What cannot be synced (some network folders) is as safe as its file system makes it.
void sync(const std::filesystem::path& path, int flags) {
    const int open = ::open(path.empty() ? "." : path.c_str(), O_RDONLY | O_CLOEXEC | flags);
    if (open < 0) return;
    ::fsync(open);
    ::close(open);
}

}  // namespace

void syncFolder(const std::filesystem::path& folder) {
    sync(folder, O_DIRECTORY);
}

Result<void> moveFile(const std::filesystem::path& from, const std::filesystem::path& to) {
    sync(from, 0);
    std::error_code code;
    std::filesystem::rename(from, to, code);
    if (code) return fail(to.string(), "cannot be written: " + code.message());
    syncFolder(to.parent_path());
    if (from.parent_path() != to.parent_path()) syncFolder(from.parent_path());
    return {};
}

}  // namespace deixis
