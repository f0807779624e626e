#include "assets/data_paths.hpp"

#include <cstdlib>
#include <system_error>
#include <vector>

namespace deixis::assets {

std::filesystem::path dataFile(std::string_view relative) {
    namespace fs = std::filesystem;
    std::error_code code;
    std::vector<fs::path> folders;
    if (const char* data = std::getenv("DEIXIS_DATA")) folders.emplace_back(data);
    const fs::path program = fs::read_symlink("/proc/self/exe", code);
    if (!code) folders.push_back(program.parent_path() / "data");
    folders.emplace_back(DEIXIS_BUILT_DATA);
    folders.emplace_back(DEIXIS_SOURCE_DATA);
    for (const fs::path& folder : folders)
        if (fs::exists(folder / relative, code)) return folder / relative;
    // Nowhere: name the place where it ships, so that the error of whoever opens it is about that file.
    return fs::path(DEIXIS_SOURCE_DATA) / relative;
}

std::filesystem::path fileOrShipped(const std::string& name, std::string_view kind) {
    const std::filesystem::path path = name;
    std::error_code code;
    const bool there = std::filesystem::exists(path, code) && !std::filesystem::is_directory(path, code);
    if (there || path.has_parent_path() || path.has_extension()) return path;
    return dataFile(std::string(kind) + "/" + name + ".toml");
}

}  // namespace deixis::assets
