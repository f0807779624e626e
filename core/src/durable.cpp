#include "core/durable.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace deixis {

namespace {

/// 0, or why the disk has not taken what was written. What cannot be synced (some network folders) is as safe
/// as its file system makes it.
int sync(const std::filesystem::path& path, int flags, int (*how)(int)) {
    const int open = ::open(path.empty() ? "." : path.c_str(), O_RDONLY | O_CLOEXEC | flags);
    if (open < 0) return 0;
    const int why = how(open) == 0 ? 0 : errno;
    ::close(open);
    return why == EIO || why == ENOSPC || why == EDQUOT ? why : 0;
}

}  // namespace

void syncFolder(const std::filesystem::path& folder) {
    sync(folder, O_DIRECTORY, ::fsync);
}

void syncFileSystem(const std::filesystem::path& folder) {
    sync(folder, O_DIRECTORY, ::syncfs);
}

Result<void> moveFile(const std::filesystem::path& from, const std::filesystem::path& to) {
    if (const int why = sync(from, 0, ::fsync); why != 0)
        return fail(to.string(), "cannot be written: " + std::generic_category().message(why));
    std::error_code code;
    std::filesystem::rename(from, to, code);
    if (code) return fail(to.string(), "cannot be written: " + code.message());
    syncFolder(to.parent_path());
    if (from.parent_path() != to.parent_path()) syncFolder(from.parent_path());
    return {};
}

}  // namespace deixis
