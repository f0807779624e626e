#include "assets/data/data_paths.hpp"

#include <cstdlib>
#include <system_error>
#include <vector>

namespace deixis::assets {

namespace {

namespace fs = std::filesystem;

/// Beside the programs of a build, and as seen from an installation's bin folder.
std::vector<fs::path> foldersOfProgram() {
    std::error_code code;
    const fs::path program = fs::read_symlink("/proc/self/exe", code);
    if (code) return {};
    const fs::path folder = program.parent_path();
    return {folder / "share/deixis", folder.parent_path() / "share/deixis"};
}

}  // namespace

std::filesystem::path dataFile(std::string_view relative) {
    std::error_code code;
    if (const char* data = std::getenv("DEIXIS_DATA"))
        if (fs::exists(fs::path(data) / relative, code)) return fs::path(data) / relative;
    const std::vector<fs::path> folders = foldersOfProgram();
    for (const fs::path& folder : folders)
        // In a build these are links: who reads the name is told the file that can be mended.
        if (fs::exists(folder / relative, code)) return fs::weakly_canonical(folder / relative, code);
    // Nowhere: name the place where it would be, so that the error of whoever opens it is about that file.
    for (const fs::path& folder : folders)
        if (fs::exists(folder, code)) return fs::weakly_canonical(folder / relative, code);
    return folders.empty() ? fs::path(relative) : folders.back() / relative;
}

std::filesystem::path fileOrShipped(const std::string& name, std::string_view kind) {
    const std::filesystem::path path = name;
    std::error_code code;
    const bool there = std::filesystem::exists(path, code) && !std::filesystem::is_directory(path, code);
    if (there || path.has_parent_path() || path.has_extension()) return path;
    return dataFile(std::string(kind) + "/" + name + ".toml");
}

}  // namespace deixis::assets
