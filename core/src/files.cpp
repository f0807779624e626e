#include "core/files.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace deixis {

Result<std::string> readFile(const std::filesystem::path& path) {
    std::error_code code;
    if (std::filesystem::is_directory(path, code))
        return fail(path.string(), "is a folder, a file was expected");
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (!in) return fail(path.string(), std::string("cannot be opened: ") + std::strerror(errno));
    std::string bytes;
    constexpr std::size_t at_once = std::size_t{1} << 20U;
    constexpr std::uintmax_t most_at_first = std::uintmax_t{1} << 30U;
    if (const auto size = std::filesystem::file_size(path, code); !code)
        bytes.reserve(static_cast<std::size_t>(std::min(size, most_at_first)) + at_once);
    for (std::size_t count = 0; in; bytes.resize(count)) {
        bytes.resize(count + at_once);
        in.read(bytes.data() + count, static_cast<std::streamsize>(at_once));
        count += static_cast<std::size_t>(in.gcount());
    }
    if (in.bad()) return fail(path.string(), "could not be read to its end");
    return bytes;
}

FileBytes::FileBytes(FileBytes&& other) noexcept
    : bytes_(std::move(other.bytes_)), mapped_(std::exchange(other.mapped_, nullptr)), size_(other.size_) {}

FileBytes::~FileBytes() {
    if (mapped_ != nullptr) ::munmap(mapped_, size_);
}

std::string_view FileBytes::view() const {
    return mapped_ != nullptr ? std::string_view(static_cast<const char*>(mapped_), size_) : bytes_;
}

Result<FileBytes> openFile(const std::filesystem::path& path, std::size_t mapped_from) {
    struct stat status {};
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file >= 0 && ::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0 &&
        static_cast<std::size_t>(status.st_size) >= mapped_from) {
        const auto size = static_cast<std::size_t>(status.st_size);
        void* mapped = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
        ::close(file);
        if (mapped != MAP_FAILED) {
            ::madvise(mapped, size, MADV_SEQUENTIAL);
            return FileBytes(mapped, size);
        }
    } else if (file >= 0) {
        ::close(file);
    }
    auto bytes = readFile(path);  // also tells what is wrong with the path
    if (!bytes) return tl::unexpected(bytes.error());
    return FileBytes(std::move(*bytes));
}

Result<void> writeFile(const std::filesystem::path& path, std::string_view bytes) {
    std::error_code code;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), code);
    std::filesystem::path partial = path;
    partial += ".partial" + std::to_string(::getpid());
    errno = 0;
    {
        std::ofstream out(partial, std::ios::binary | std::ios::trunc);
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        out.close();
        if (!out) {
            const std::string why = std::strerror(errno);
            std::filesystem::remove(partial, code);
            return fail(path.string(), "cannot be written: " + why);
        }
    }
    std::filesystem::rename(partial, path, code);
    if (code) {
        const std::string why = code.message();
        std::filesystem::remove(partial, code);
        return fail(path.string(), "cannot be written: " + why);
    }
    return {};
}

}  // namespace deixis
