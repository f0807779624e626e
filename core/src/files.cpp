#include "core/files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <vector>

#include "core/durable.hpp"
#include "core/unique_name.hpp"

namespace deixis {

namespace {

tl::unexpected<Error> tooLarge(const std::string& name, std::size_t max_bytes) {
    return fail(name, fmt::format("has more than {} bytes, the maximum that is read at once", max_bytes),
                "Use another file, or a part of it");
}

/// Makes the folder with those above it. Returns the folders that have a new entry, the innermost first.
std::vector<std::filesystem::path> makeFolders(const std::filesystem::path& folder) {
    namespace fs = std::filesystem;
    std::error_code code;
    std::vector<fs::path> grown;
    for (fs::path missing = folder; !missing.empty() && !fs::exists(missing, code);
         missing = missing.parent_path())
        grown.push_back(missing.parent_path());
    fs::create_directories(folder, code);
    return grown;
}

Result<void> writeVia(const std::filesystem::path& path, std::string_view bytes, bool synced) {
    namespace fs = std::filesystem;
    std::error_code code;
    const auto there = fs::status(path, code);
    if (fs::is_fifo(there) || fs::is_character_file(there)) {
        errno = 0;
        std::ofstream out(path, std::ios::binary);
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        out.close();
        if (!out) return fail(path.string(), std::string("cannot be written: ") + std::strerror(errno));
        return {};
    }
    const std::vector<fs::path> grown = makeFolders(path.parent_path());
    fs::path partial = path;
    partial += ".partial" + uniqueName();
    errno = 0;
    {
        std::ofstream out(partial, std::ios::binary | std::ios::trunc);
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        out.close();
        if (!out) {
            const std::string why = std::strerror(errno);
            fs::remove(partial, code);
            return fail(path.string(), "cannot be written: " + why);
        }
    }
    Result<void> moved{};
    if (synced) {
        moved = moveFile(partial, path);
        for (const fs::path& folder : grown) syncFolder(folder);
    } else {
        fs::rename(partial, path, code);
        if (code) moved = fail(path.string(), "cannot be written: " + code.message());
    }
    if (!moved) fs::remove(partial, code);
    return moved;
}

}  // namespace

Result<std::string> readAll(std::istream& in, const std::string& name, std::size_t expected_bytes,
                            std::size_t max_bytes) {
    if (expected_bytes > max_bytes) return tooLarge(name, max_bytes);
    std::string bytes;
    constexpr std::size_t block = std::size_t{1} << 16U;
    // One byte more than expected: the end is met in the first reading.
    std::size_t at_once = expected_bytes > 0 ? std::min(expected_bytes, std::size_t{1} << 30U) + 1 : block;
    for (std::size_t count = 0; in; bytes.resize(count), at_once = std::max(block, count)) {
        bytes.resize(count + at_once);
        in.read(bytes.data() + count, static_cast<std::streamsize>(at_once));
        count += static_cast<std::size_t>(in.gcount());
        if (count > max_bytes) return tooLarge(name, max_bytes);
    }
    if (in.bad()) return fail(name, "could not be read to its end");
    return bytes;
}

Result<std::string> readFile(const std::filesystem::path& path, std::size_t max_bytes) {
    namespace fs = std::filesystem;
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (fs::is_directory(status)) return fail(path.string(), "is a folder, expected a file");
    if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_fifo(status))
        return fail(path.string(), "is a device, which may never end; expected a file");
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (!in) return fail(path.string(), std::string("cannot be opened: ") + std::strerror(errno));
    const auto size = fs::is_regular_file(status) ? fs::file_size(path, code) : 0;
    return readAll(in, path.string(), code ? 0 : static_cast<std::size_t>(size), max_bytes);
}

Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes) {
    return writeVia(path, bytes, true);
}

Result<void> writeFileUnsynced(const std::filesystem::path& path, std::string_view bytes) {
    return writeVia(path, bytes, false);
}

}  // namespace deixis
