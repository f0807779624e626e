#include "app/study/seen_files.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <sstream>
#include <system_error>
#include <utility>

#include "core/files.hpp"
#include "core/hash.hpp"
#include "core/parallel.hpp"
#include "core/unique_name.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

/// The coarsest clock of a file system in use (FAT's).
constexpr std::int64_t coarsest_clock_ns = 2'000'000'000;

std::int64_t nanoseconds(const timespec& time) {
    return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

}  // namespace

std::optional<SeenFiles::Stamp> SeenFiles::stampOf(const fs::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return std::nullopt;
    return Stamp{status.st_size, nanoseconds(status.st_mtim), nanoseconds(status.st_ctim), status.st_ino,
                 status.st_dev};
}

std::optional<std::pair<std::string, std::optional<SeenFiles::Stamp>>> SeenFiles::readHash(
    const fs::path& file) {
    const auto before = stampOf(file);
    const auto bytes = readFile(file);
    if (!bytes) return std::nullopt;
    const bool stood_still = before && before == stampOf(file);
    return std::pair(sha256Hex(*bytes), stood_still ? before : std::nullopt);
}

SeenFiles::SeenFiles(fs::path memory) : memory_(std::move(memory)) {
    const auto text = readFile(memory_);
    constexpr std::size_t digits = 64;
    // The first line is the hash of the others.
    if (!text || text->size() <= digits ||
        sha256Hex(std::string_view(*text).substr(digits + 1)) != text->substr(0, digits))
        return;
    std::istringstream lines(text->substr(digits + 1));
    Seen one;
    Stamp& stamp = one.stamp;
    std::string path;
    while (lines >> one.hash >> stamp.size >> stamp.changed_ns >> stamp.touched_ns >> stamp.inode >>
               stamp.device &&
           lines.get() == ' ' && std::getline(lines, path))
        seen_[path] = one;
}

std::vector<std::optional<std::string>> SeenFiles::hashes(const std::vector<fs::path>& files) {
    std::vector<std::optional<std::string>> out(files.size());
    std::vector<std::size_t> unknown;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const auto known = seen_.find(fs::absolute(files[i]).lexically_normal().string());
        if (known != seen_.end() && known->second.stamp == stampOf(files[i]))
            out[i] = known->second.hash;
        else
            unknown.push_back(i);
    }
    read_ = static_cast<int>(unknown.size());
    if (unknown.empty()) return out;
    std::error_code code;
    const bool remembers = fs::is_directory(memory_.parent_path(), code);

    // The time by the clock that stamps the files.
    const fs::path clock = memory_.string() + ".clock" + uniqueName();
    std::optional<Stamp> now;
    if (remembers && writeFileUnsynced(clock, "")) now = stampOf(clock);
    fs::remove(clock, code);

    constexpr std::size_t worth_a_thread = 8;
    const auto parts = mapRanges(unknown.size(), worth_a_thread, [&](std::size_t first, std::size_t last) {
        std::vector<std::optional<std::pair<std::string, std::optional<Stamp>>>> read;
        for (std::size_t i = first; i < last; ++i) read.push_back(readHash(files[unknown[i]]));
        return read;
    });
    auto next = unknown.begin();
    bool news = false;
    for (const auto& part : parts)
        for (const auto& read : part) {
            const std::size_t i = *next++;
            if (!read) continue;
            out[i] = read->first;
            const auto& stamp = read->second;
            const bool still =
                now && stamp && stamp->device == now->device &&
                std::max(stamp->changed_ns, stamp->touched_ns) + coarsest_clock_ns < now->changed_ns;
            if (!still) continue;
            seen_[fs::absolute(files[i]).lexically_normal().string()] = {*stamp, read->first};
            news = true;
        }
    if (news) keep();
    return out;
}

void SeenFiles::keep() const {
    std::string text;
    std::error_code code;
    for (const auto& [path, seen] : seen_) {
        const Stamp& stamp = seen.stamp;
        if (path.find('\n') != std::string::npos || !fs::exists(path, code)) continue;
        text += fmt::format("{} {} {} {} {} {} {}\n", seen.hash, stamp.size, stamp.changed_ns,
                            stamp.touched_ns, stamp.inode, stamp.device, path);
    }
    // Where it cannot be kept, the next start is slower, and that is all.
    (void)writeFileUnsynced(memory_, sha256Hex(text) + "\n" + text).has_value();
}

}  // namespace deixis::app
