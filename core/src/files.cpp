#include "core/files.hpp"

#include <unistd.h>

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
    for (std::size_t count = 0; in; bytes.resize(count)) {
        bytes.resize(count + at_once);
        in.read(bytes.data() + count, static_cast<std::streamsize>(at_once));
        count += static_cast<std::size_t>(in.gcount());
    }
    if (in.bad()) return fail(path.string(), "could not be read to its end");
    return bytes;
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
