// What this program asks of the disk, in order: file names put in place, and bytes waited for. Included in
// one file of a test program, it stands in for the C library's calls, and does as they do.
#pragma once

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

namespace deixis::tests {

/// "rename TO", "fsync PATH" and "syncfs PATH", by the last part of the path's name.
inline std::vector<std::string> disk_calls;

inline void logCall(const std::string& call, const std::filesystem::path& path) {
    static std::mutex guard;
    const std::lock_guard lock(guard);
    disk_calls.push_back(call + " " + path.filename().string());
}

inline std::filesystem::path pathOf(int file) {
    std::error_code code;
    return std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(file), code);
}

/// Where not 0, every fsync fails with it.
inline int fsync_fails_with = 0;

/// Place in the log of the first call that begins so; its end where there is none.
inline std::size_t callAt(const std::string& call) {
    const auto found = std::find_if(disk_calls.begin(), disk_calls.end(),
                                    [&](const std::string& one) { return one.rfind(call, 0) == 0; });
    return static_cast<std::size_t>(found - disk_calls.begin());
}

}  // namespace deixis::tests

extern "C" inline __attribute__((used)) int fsync(int file) {
    deixis::tests::logCall("fsync", deixis::tests::pathOf(file));
    if (deixis::tests::fsync_fails_with != 0) {
        errno = deixis::tests::fsync_fails_with;
        return -1;
    }
    return static_cast<int>(syscall(SYS_fsync, file));
}

extern "C" inline __attribute__((used)) int syncfs(int file) noexcept {
    deixis::tests::logCall("syncfs", deixis::tests::pathOf(file));
    return static_cast<int>(syscall(SYS_syncfs, file));
}

extern "C" inline __attribute__((used)) int rename(const char* from, const char* to) noexcept {
    deixis::tests::logCall("rename", to);
    return static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}
