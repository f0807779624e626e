#include "app/program/written_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>

#include "core/files.hpp"
#include "core/staging.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* how_to_replace = "Give another name, or --force to replace it";

/// Every page names the program at its head, and so does every JSON file; pages of 0.1.0 did in their text.
bool isOurs(const std::string& file) {
    constexpr std::size_t head_size = 4096;
    const auto text = readFile(file);
    if (!text) return false;
    const std::string head = text->substr(0, head_size);
    return text->empty() || head.find("content=\"deixis\"") != std::string::npos ||
           head.find("\"deixis-") != std::string::npos ||
           text->find("eixis 0.1.0 (commit") != std::string::npos;
}

}  // namespace

std::FILE* remarksBeside(const std::string& json) {
    return json == standard_output ? stderr : stdout;
}

Result<void> writeOutput(const std::string& file, std::string_view bytes) {
    if (file != standard_output) return writeFile(file, bytes);
    fmt::print("{}", bytes);
    return {};
}

bool isDatabase(const std::string& file) {
    std::error_code code;
    if (!fs::is_regular_file(file, code)) return false;
    std::ifstream in(file, std::ios::binary);
    std::string start(15, '\0');
    in.read(start.data(), static_cast<std::streamsize>(start.size()));
    return start == "SQLite format 3";
}

Result<void> checkOutput(const std::string& file) {
    if (!file.empty() && isDatabase(file))
        return fail(file, "is a database; a report is not written over it", "Name another file");
    return {};
}

Result<void> checkReplaceable(const std::string& file, bool force) {
    std::error_code code;
    if (force || !fs::is_regular_file(file, code) || isOurs(file)) return {};
    return fail(file, "is there already, and Deixis did not write it", how_to_replace);
}

Result<void> checkFree(const std::string& file, bool force) {
    std::error_code code;
    const auto there = fs::status(file, code);
    if (isDatabase(file)) return fail(file, "is a database; nothing is written over it", "Give another name");
    if (force || !fs::exists(there) || fs::is_other(there)) return {};
    return fail(file, "is there already", how_to_replace);
}

Result<void> checkFolderFree(const std::string& folder, const std::vector<std::string_view>& endings,
                             bool force) {
    std::error_code code;
    if (folder.empty() || !fs::exists(folder, code)) return {};
    if (!fs::is_directory(folder, code))
        return fail(folder, "is a file, expected a folder", "Give another name");
    if (force) return {};
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder, code))
        if (std::find(endings.begin(), endings.end(), entry.path().extension().string()) != endings.end())
            found.insert(entry.path().string());
    if (found.empty()) return {};
    return fail(*found.begin(), "is there already",
                "Give another folder, or --force to write over files of the same names");
}

Result<void> writeFolder(const std::string& folder, const FolderFiles& files) {
    if (folder.empty()) return {};
    auto staging = Staging::within(folder);
    if (!staging) return tl::unexpected(staging.error());
    std::vector<fs::path> names;
    for (const auto& [name, bytes] : files) {
        names.emplace_back(name);
        if (auto added = staging->add(name, bytes); !added) return added;
    }
    return staging->moveHome(names, {}, true);
}

Result<void> writeUnlessEdited(const std::string& file, std::string_view bytes, bool force) {
    std::error_code code;
    if (!force && fs::exists(file, code)) {
        const auto there = readFile(file);
        if (!there || *there != bytes) return fail(file, "is there already", how_to_replace);
    }
    return writeFile(file, bytes);
}

}  // namespace deixis::app
